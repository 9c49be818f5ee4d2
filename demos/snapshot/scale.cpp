#include "demos/snapshot/scale.h"

#include <cmath>
#include <numbers>

namespace demos {
namespace {

constexpr double kLongestShare = 0.16;  // of the view's height
constexpr double kSampleShare = 0.8;    // of the peak, at most
constexpr double kLastBits = 1e-9;      // so that 1e-3 counts as round despite its last bit

double decadeBelow(double x) {
    return std::pow(10.0, std::floor(std::log10(x * (1.0 + kLastBits))));
}

}  // namespace

double viewHeight(const CameraDescription& camera) {
    const double half = std::tan(camera.fovDegrees * std::numbers::pi / 360.0);
    return 2.0 * half * (camera.from - camera.lookAt).norm();
}

double roundBelow(double x) {
    if (!(x > 0.0)) return 0.0;
    const double decade = decadeBelow(x);
    for (const double step : {5.0, 2.0})
        if (step * decade <= x * (1.0 + kLastBits)) return step * decade;
    return decade;
}

double roundAbove(double x) {
    if (!(x > 0.0)) return 1.0;
    const double decade = decadeBelow(x);
    for (const double step : {1.0, 2.0, 5.0})
        if (step * decade >= x * (1.0 - kLastBits)) return step * decade;
    return 10.0 * decade;
}

ArrowScale::ArrowScale(double peak, double viewHeight) : longest(kLongestShare * viewHeight) {
    if (!(peak > 0.0)) return;
    metersPerUnit = longest / peak;
    sample = roundBelow(kSampleShare * peak);
}

}  // namespace demos
