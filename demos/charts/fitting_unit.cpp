#include "demos/charts/fitting_unit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "demos/charts/chart.h"

namespace demos {
namespace {

constexpr std::array<const char*, 8> kUnitPrefixes = {"p", "n", "µ", "m", "", "k", "M", "G"};
constexpr int kMilli = 3, kNone = 4, kMost = 7;

}  // namespace

FittingUnit fittingUnit(const std::string& unit, double largest) {
    const bool isLength = unit == "mm";
    if (!isLength && unit != "m/s" && unit != "J" && unit != "N s") return {1.0, unit};
    int prefix = isLength ? kMilli : kNone;
    const int last = isLength ? kNone + 1 : kMost;
    double scale = 1.0;
    for (; scale * largest >= 1e4 && prefix < last; ++prefix) scale *= 1e-3;
    for (; scale * largest < 1e-3 && largest > 0.0 && prefix > 0; --prefix) scale *= 1e3;
    return {scale, kUnitPrefixes[static_cast<std::size_t>(prefix)] + (isLength ? "m" : unit)};
}

void useFittingUnit(Chart& chart) {
    double largest = 0.0;
    for (const Series& series : chart.series)
        for (const double y : series.y)
            if (std::isfinite(y)) largest = std::max(largest, std::abs(y));
    if (chart.yUnit != "mm" || chart.logY) return;
    const FittingUnit unit = fittingUnit(chart.yUnit, largest);
    chart.yUnit = unit.name;
    for (Series& series : chart.series)
        for (double& y : series.y) y *= unit.scale;
}

}  // namespace demos
