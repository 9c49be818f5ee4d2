/// Work in a process of its own, so that its OpenGL leaves nothing in this one: a process that has had a context must
/// not fork drawing processes any more, because a thread of the driver stays, and its locks are copied as they are.
#pragma once
#include <functional>
#include <string>

namespace demos {

/// Runs `work` in a forked process and returns what it returned. Its Stop or render::Error is thrown here; other
/// exceptions as render::Error. `what` ("the process that measures") begins the message if it is killed. After SIGINT
/// or SIGTERM it is killed and Stop (interrupted) is thrown.
std::string inOwnProcess(const std::string& what, const std::function<std::string()>& work);

}  // namespace demos
