/// The version of this program.
#pragma once

namespace demos {

#ifdef IMPULSE_VERSION
inline constexpr const char* kVersion = IMPULSE_VERSION;
#else
inline constexpr const char* kVersion = "0.2";
#endif

}  // namespace demos
