/// Independent pieces of work, each in its own process: a crash does not affect the others, and
/// each may have an OpenGL context (two in one process would wait for each other).
#pragma once
#include <functional>
#include <string>

namespace demos {

/// How a piece ended.
struct PoolResult {
    bool ended = false;  // it finished, and `text` is what it returned
    std::string text;    // else why not: "was killed by signal 11 (Segmentation fault)"
};

/// Runs `work(i)` for i from 0 to count - 1 in forked processes, at most `jobs` at a time. The
/// results go to `take(i, result)` in this order, and to `finished(i, result)` as soon as they are
/// available. Call it before any OpenGL. `work` must not throw. After SIGINT or SIGTERM the
/// processes are killed and Stop (interrupted) is thrown.
void runInProcesses(int count, int jobs, const std::function<std::string(int)>& work,
                    const std::function<void(int, const PoolResult&)>& take,
                    const std::function<void(int, const PoolResult&)>& finished = {});

}  // namespace demos
