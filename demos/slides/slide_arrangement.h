/// How large a slide will show its pictures, so that text in them is readable.
#pragma once
#include <optional>

#include "demos/slides/slide_layout.h"

namespace demos {

/// The least size of letters in pictures and charts on the slide: px of the font's em.
inline constexpr double kLeastLetters = 16.5;

/// Whether the slide has no words, charts or tables next to the picture.
bool standsAlone(const Slide& slide);

/// The layout before the tables are known.
SlideLayout plannedLayout(const Slide& slide);

/// The space for the slide's film, still or strip; `aspect`: its width over height.
SlideRoom exhibitRoom(const Slide& slide, double aspect);

/// The rows and columns that show moments of a strip or runs of a film largest, no more rows than
/// columns. Empty cells are used only if the gain is large. `aspect`: of each.
PictureGrid arrangement(const Slide& slide, std::size_t count, double aspect);

/// Pixels per point for a film or still of this size, so that letters of kLabelPoints are readable.
double pointPixels(const Slide& slide, PictureSize picture);

/// The space for one of `count` charts. `exhibit`: width over height of the picture with them.
SlideRoom chartRoom(const Slide& slide, const std::vector<MadeTable>& tables, std::size_t count,
                    std::optional<double> exhibit);

}  // namespace demos
