/// Numbers that are as long as they need to be.
#pragma once

namespace demos {

/// To so many significant digits, 1 to 17; what is not finite stays.
double rounded(double value, int digits);

}  // namespace demos
