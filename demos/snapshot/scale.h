/// Lengths that suit a scene of any size, and round numbers for legends.
#pragma once
#include "demos/scene/description.h"

namespace demos {

/// m: what the camera sees from the lower to the upper edge, where it looks; at the start.
double viewHeight(const CameraDescription& camera);

/// The largest of 1, 2 or 5 times a power of ten that is not above x; 0 for x that is not positive.
double roundBelow(double x);
/// The smallest that is not below x; 1 for x that is not positive.
double roundAbove(double x);

/// How long an arrow is for each N s (or m of nudge): the peak's is a sixth of the view's height.
struct ArrowScale {
    double metersPerUnit = 0.0;  // 0: nothing to show
    double longest = 0.0;        // m
    double sample = 0.0;         // of the legend: a round number of units

    ArrowScale(double peak, double viewHeight);
    /// Shorter ones are specks.
    bool shows(double length) const { return length > 0.03 * longest; }
};

}  // namespace demos
