/// Bodies' colours: their own, or by what they do.
#pragma once
#include <string>
#include <vector>

#include "demos/look/overlays.h"
#include "demos/play/stage.h"
#include "render/frame.h"

namespace demos {

struct History;

inline constexpr float kSensorAlpha = 0.34f;  // a sensor lets through what is behind it

/// By body: m/s for "speed"; N s for "impulse", the sum along the normals in the last step. Empty
/// for colourings without a scale. Fixed bodies have the value -1.
std::vector<double> colorValues(const Stage& stage, const std::string& colorBy);

/// Viridis (van der Walt and Smith 2015): evenly spaced to the eye, also to colour-blind ones.
/// share: 0..1, clamped.
render::Color scaleColor(double share);
/// x red, y green, z blue.
render::Color axisColor(int axis);
/// From low to high, as many as it takes.
std::vector<render::Color> scaleRamp();

/// The end of the scale: given, or the least of 1, 2 or 5 times a power of ten not below the
/// largest value so far.
double scaleEnd(const Overlays& overlays, const History& history);

/// Bodies that hang together by contacts and joints, each named by the least number among them;
/// fixed bodies do not join others, and are -1.
std::vector<int> islandsOf(const Stage& stage);

/// What the colours of moving bodies say, in the bodies' order: for "group" and "material".
struct ColorMeaning {
    std::string name;
    render::Color color;
};
std::vector<ColorMeaning> colorMeanings(const Stage& stage, const std::string& colorBy);

/// By body.
std::vector<render::Color> bodyColors(const Stage& stage, const Overlays& overlays,
                                      const History& history);
/// Its own, whatever else colours bodies.
render::Color ownColor(const Stage& stage, int body);

}  // namespace demos
