#include <algorithm>
#include <cmath>

#include "demos/charts/chart.h"

namespace demos {

void useSmallUnit(Chart& chart) {
    double largest = 0.0;
    for (const Series& series : chart.series)
        for (const double y : series.y)
            if (std::isfinite(y)) largest = std::max(largest, std::abs(y));
    if (chart.yUnit != "mm" || chart.logY || !(largest > 0.0)) return;
    double scale = 1.0;
    for (const char* unit : {"µm", "nm", "pm"}) {
        if (scale * largest >= 1e-3) break;  // a tick of 0.001
        scale *= 1e3;
        chart.yUnit = unit;
    }
    for (Series& series : chart.series)
        for (double& y : series.y) y *= scale;
}

}  // namespace demos
