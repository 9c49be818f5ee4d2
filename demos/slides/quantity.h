/// Writes a number with its unit in a short, readable form.
#pragma once
#include <string>

#include "engine/base/math.h"

namespace demos {

/// Where the number is used: between words, or within a LaTeX formula.
enum class NumberSetting { text, formula };

/// Zeros at the end of a number's decimals.
enum class Zeros { dropped, kept };

/// "1.27 mm", "264.8 kJ", "12 deg"; `1.27\,\mathrm{mm}`. Metres, m/s, J, N and N s get a prefix
/// from 1000 and below 0.1; metres already below 1, so that short lengths are all in mm. A value
/// that no prefix makes short is written like 1.2 × 10⁻¹³. `digits`: significant; a whole number
/// without a unit is a count and keeps all of its digits. A text has no line breaks in it.
std::string quantityText(double value, const std::string& unit, int digits, NumberSetting setting,
                         Zeros zeros = Zeros::dropped);

/// "(−0.32, 0.24, 3) m/s": with the precision of its largest component and one prefix or power.
std::string vectorText(const engine::Vec3& value, const std::string& unit, int digits,
                       NumberSetting setting, Zeros zeros = Zeros::dropped);

}  // namespace demos
