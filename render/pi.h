/// Pi in single precision, for pictures.
#pragma once

namespace render {

inline constexpr float kPi = 3.14159265f;

}  // namespace render
