/// Colours that stay apart for colour-blind eyes and in print (Okabe and Ito, 'Color Universal
/// Design', 2008), slightly softened for large faces.
#pragma once
#include "render/frame.h"

namespace render {

inline constexpr int kPaletteSize = 7;

/// Green, yellow, sky blue, orange, pink, vermilion, blue, and again from the start; any int is fine.
Color paletteColor(int index);

/// Static and heavy bodies.
Color darkGrey();

/// Contact dots, contact impulses and nudges in overlays.
Color markerPink();
Color arrowRed();
Color nudgeBlue();

}  // namespace render
