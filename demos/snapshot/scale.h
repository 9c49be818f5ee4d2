/// Lengths for scenes of any size, and round numbers for legends.
#pragma once
#include "demos/scene/description.h"

namespace demos {

/// m: the height of the camera's view at lookAt, at the start.
double viewHeight(const CameraDescription& camera);

/// The largest of 1, 2 or 5 times a power of ten not above x; 0 if x is not positive.
double roundBelow(double x);
/// The smallest not below x; 1 if x is not positive.
double roundAbove(double x);

/// Arrow lengths per N s (or per m of nudge): the peak's arrow is a sixth of the view's height.
struct ArrowScale {
    double metersPerUnit = 0.0;  // 0: nothing to show
    double longest = 0.0;        // m
    double sample = 0.0;         // for the legend: a round number of units

    ArrowScale(double peak, double viewHeight);
    /// Shorter arrows would be specks.
    bool shows(double length) const { return length > 0.03 * longest; }
};

}  // namespace demos
