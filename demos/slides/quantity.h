/// A number with its unit, as short as it can be read.
#pragma once
#include <string>

#include "engine/base/math.h"

namespace demos {

/// Where it stands: between words, or within a LaTeX formula.
enum class NumberSetting { text, formula };

/// Zeros at the end of a number's decimals.
enum class Zeros { dropped, kept };

/// "1.27 mm", "264.8 kJ", "12 deg"; `1.27\,\mathrm{mm}`. Metres, m/s, J, N and N s get a prefix
/// where they are 1000 or more, or below 0.1; metres below 1, so that short lengths are all in mm.
/// What no prefix makes short is 1.2 × 10⁻¹³. `digits`: significant; a whole number without a unit
/// is a count and keeps all of its digits. In a text nothing in it breaks across lines.
std::string quantityText(double value, const std::string& unit, int digits, NumberSetting setting,
                         Zeros zeros = Zeros::dropped);

/// "(−0.32, 0.24, 3) m/s": as exact as its largest part is, with one prefix or power of ten.
std::string vectorText(const engine::Vec3& value, const std::string& unit, int digits,
                       NumberSetting setting, Zeros zeros = Zeros::dropped);

}  // namespace demos
