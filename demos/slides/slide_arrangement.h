/// How large a slide will show its pictures: what is written in them is to be read.
#pragma once
#include <optional>

#include "demos/slides/slide_layout.h"

namespace demos {

/// Of letters in pictures and charts, as the slide shows them: px of the font's em.
inline constexpr double kLeastLetters = 16.5;

/// No words, charts or tables stand beside.
bool standsAlone(const Slide& slide);

/// Before its tables are there.
SlideLayout plannedLayout(const Slide& slide);

/// The place of the slide's film, still or strip, of this width over height.
SlideRoom exhibitRoom(const Slide& slide, double aspect);

/// Moments of a strip or runs of a film, `aspect` each: in rows and columns where they are largest,
/// no more rows than columns. Empty cells have to be worth it.
PictureGrid arrangement(const Slide& slide, std::size_t count, double aspect);

/// Of the letters in a film or still of so many pixels across, which has letters of kLabelPoints.
double pointPixels(const Slide& slide, PictureSize picture);

/// The place of one of `count` charts. `exhibit`: width over height of what stands with them.
SlideRoom chartRoom(const Slide& slide, const std::vector<MadeTable>& tables, std::size_t count,
                    std::optional<double> exhibit);

}  // namespace demos
