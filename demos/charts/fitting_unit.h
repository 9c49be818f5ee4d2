/// Units that fit: 15.8 km instead of 1.581e+07 mm.
#pragma once
#include <string>

namespace demos {

struct FittingUnit {
    double scale = 1.0;
    std::string name;
};

/// The unit in which `largest` (in `unit`) is at least 0.001 and below 10,000: `unit` or one a thousand,
/// a million, ... times as large or small. For mm, m/s, J and N s; other units stay.
FittingUnit fittingUnit(const std::string& unit, double largest);

}  // namespace demos
