/// A number with its unit, as short as it can be read.
#pragma once
#include <string>

#include "engine/base/math.h"

namespace demos {

/// Where it stands: between words, or within a LaTeX formula.
enum class NumberSetting { text, formula };

/// "1.27 mm", "264.8 kJ", "12 deg"; `1.27\,\mathrm{mm}`. Metres, m/s, J, N and N s get a prefix
/// where they are 1000 or more, or below 0.1. `digits`: significant, without trailing zeros; a
/// whole number without a unit is a count and keeps all of its digits.
std::string quantityText(double value, const std::string& unit, int digits, NumberSetting setting);

/// "(-0.32, 0.24, 3) m/s": as exact as its largest part is.
std::string vectorText(const engine::Vec3& value, const std::string& unit, int digits,
                       NumberSetting setting);

}  // namespace demos
