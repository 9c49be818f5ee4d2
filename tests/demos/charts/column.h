/// The paper of most tests of figures.
#pragma once
#include "demos/look/paper.h"

namespace demos {

inline constexpr Paper kColumn{85.0, 300};  // a column of a page with two

}  // namespace demos
