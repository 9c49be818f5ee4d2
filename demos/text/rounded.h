/// Rounds numbers for output.
#pragma once

namespace demos {

/// Rounds to this many significant digits, 1 to 17; a value that is not finite is returned as is.
double rounded(double value, int digits);

}  // namespace demos
