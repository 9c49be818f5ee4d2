/// The colours of bodies: their own, or by what they do.
#pragma once
#include <string>
#include <vector>

#include "demos/look/overlays.h"
#include "demos/play/stage.h"
#include "render/frame.h"

namespace demos {

struct History;

inline constexpr float kSensorAlpha = 0.34f;  // a sensor is translucent

/// By body: m/s for "speed"; N s for "impulse", the sum along the normals in the last step. Empty
/// for colourings without a scale. The value of fixed bodies is -1.
std::vector<double> colorValues(const Stage& stage, const std::string& colorBy);

/// Viridis (van der Walt and Smith 2015): perceptually uniform, also for colour-blind viewers.
/// share: 0..1, clamped.
render::Color scaleColor(double share);
/// x red, y green, z blue.
render::Color axisColor(int axis);
/// The colours of the scale from low to high.
std::vector<render::Color> scaleRamp();

/// The end of the scale: as set, or the smallest of 1, 2 or 5 times a power of ten not below the
/// largest value so far.
double scaleEnd(const Overlays& overlays, const History& history);

/// By body: the island of bodies connected by contacts and joints, as the least index in it. Fixed
/// bodies do not connect others, and have -1.
std::vector<int> islandsOf(const Stage& stage);

/// The meanings of colours for "group" and "material", in the order of the moving bodies.
struct ColorMeaning {
    std::string name;
    render::Color color;
};
std::vector<ColorMeaning> colorMeanings(const Stage& stage, const std::string& colorBy);

/// By body.
std::vector<render::Color> bodyColors(const Stage& stage, const Overlays& overlays,
                                      const History& history);
/// The body's own colour, whatever the colouring.
render::Color ownColor(const Stage& stage, int body);

}  // namespace demos
