/// The page of a folder.
#pragma once
#include <string>

#include "demos/slides/made_deck.h"

namespace demos {

/// Its films and pictures are in media/ next to it.
std::string linkedSlidesPage(const MadeDeck& deck);

}  // namespace demos
