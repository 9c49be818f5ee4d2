/// The page of a folder.
#pragma once
#include <string>

#include "demos/slides/made_deck.h"

namespace demos {

/// With its films and pictures in media/ beside it.
std::string linkedSlidesPage(const MadeDeck& deck);

}  // namespace demos
