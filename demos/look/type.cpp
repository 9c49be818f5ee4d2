#include "demos/look/type.h"

#include <algorithm>
#include <cmath>

namespace demos {
namespace {

constexpr float kTitle = 24.0f;  // on a screen, larger texts are titles
constexpr float kLabel = 15.0f;  // of names and plates on a screen

}  // namespace

int letterPixels(double points, double pixelsPerPoint) {
    return std::max(static_cast<int>(std::lround(points * pixelsPerPoint / kEmShare)), 1);
}

void setType(double pixelsPerPoint, render::Frame& frame) {
    const auto pixels = [&](double points) { return static_cast<float>(points * pixelsPerPoint); };
    const float unit = static_cast<float>(letterPixels(kLabelPoints, pixelsPerPoint)) / kLabel;
    const float title = static_cast<float>(letterPixels(kTitlePoints, pixelsPerPoint)) / unit;
    frame.look.unit = unit;
    frame.look.edgePixels = pixels(kEdgePoints);
    for (render::Text& text : frame.texts) text.size = text.size > kTitle ? title : kLabel;
    for (render::Plate& plate : frame.plates) plate.size = kLabel;
    for (render::Label& label : frame.labels) label.size = kLabel;
    for (render::Trail& trail : frame.trails) trail.pixels = pixels(kTrailPoints) / unit;
}

}  // namespace demos
