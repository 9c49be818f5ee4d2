/// Letters and lines of figures in points: they have the same size on paper in every figure.
#pragma once
#include "render/frame.h"
#include "render/glyphs.h"

namespace demos {

inline constexpr double kLabelPoints = 8.0;  // of the font's em, as in typesetting
inline constexpr double kTitlePoints = 9.0;
inline constexpr double kCurvePoints = 0.8;  // width of a chart's lines
inline constexpr double kEdgePoints = 0.45;  // of lines along bodies' edges
inline constexpr double kTrailPoints = 1.4;  // of a trail at its newest point
inline constexpr double kGapPoints = 6.0;    // between the pictures of a figure

using render::kEmShare;

/// Whole pixels from cap to descender of letters of this many points.
int letterPixels(double points, double pixelsPerPoint);

/// Sets the sizes of all overlays of a frame.
void setType(double pixelsPerPoint, render::Frame& frame);

}  // namespace demos
