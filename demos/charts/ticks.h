/// Axes: their range, and the positions and texts of their ticks.
#pragma once
#include <string>
#include <vector>

namespace demos {

struct Axis {
    double low = 0.0, high = 1.0;  // low < high
    bool log = false;
    std::vector<double> ticks;  // within low..high
    std::vector<std::string> texts;

    /// 0 at `low`, 1 at `high`; on a log axis the value must be above 0.
    double share(double value) const;
};

enum class Reach {
    data,  // from the smallest to the largest value
    ticks  // extended to the next ticks and to 0 if they are near
};

/// At most `most` steps of 1, 2 or 5 times a power of ten; `whole`: steps of at least 1.
/// If low and high are equal, or nearly, the axis begins or ends at 0.
Axis linearAxis(double low, double high, double most, Reach reach, bool whole);

/// Whole decades around low..high, both above 0, with a tick at every one or every few of them.
Axis logAxis(double low, double high, int most);

/// Short forms: 0, 0.25, 1500, 20k, 1.5M, 2×10⁻⁴. They depend on the axis's step and largest tick.
std::string tickText(double value, double step, double largest);

/// 10⁻⁶, 1, 10, 10²
std::string decadeText(int exponent);

}  // namespace demos
