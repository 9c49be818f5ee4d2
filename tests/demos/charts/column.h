/// The paper that most tests of figures draw on.
#pragma once
#include "demos/look/paper.h"

namespace demos {

inline constexpr Paper kColumn{85.0, 300};  // of a page with two

}  // namespace demos
