/// `impulse --licenses`.
#pragma once
#include <string_view>

namespace demos {

/// The notices of all that is compiled in, joined while configuring (see licenses.cmake).
std::string_view licenses();

}  // namespace demos
