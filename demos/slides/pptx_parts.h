/// The parts of a .pptx that all slides share: theme, master, layouts, the list of slides.
#pragma once
#include <cstddef>
#include <string>

#include "demos/slides/deck.h"
#include "demos/slides/pptx_package.h"

namespace demos {

/// Adds them. Slides are slides/slide1.xml and so on, with the layout layouts/slideLayout1.xml, the
/// opening with slideLayout2.xml; notes have notesMasters/notesMaster1.xml.
void addPptxParts(const Deck& deck, std::size_t slides, PptxPackage& package);

}  // namespace demos
