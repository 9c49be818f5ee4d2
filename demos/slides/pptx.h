/// A deck as a .pptx, once it is known where the parts of its slides are.
#pragma once
#include <cstdint>
#include <vector>

#include "demos/slides/measured_slide.h"

namespace demos {

/// `measured`: one per slide. Throws FormulaError; render::Error if a film cannot be read.
/// (slides_pptx.cpp)
std::vector<std::uint8_t> pptxOf(const MadeDeck& deck, const std::vector<MeasuredSlide>& measured);

}  // namespace demos
