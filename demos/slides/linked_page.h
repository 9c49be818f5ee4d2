/// Pages with nothing embedded.
#pragma once
#include <string>

#include "demos/slides/made_deck.h"
#include "render/frame.h"

namespace demos {

/// Its films and pictures are in media/ next to it.
std::string linkedSlidesPage(const MadeDeck& deck);

/// "#2263b0"
std::string hexOf(const render::Color& color);

/// The same places for words and pictures as in slidesPage(), without any picture.
std::string blankSlidesPage(const MadeDeck& deck);

}  // namespace demos
