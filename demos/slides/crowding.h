/// Finds slides with more words than fit, before a deck is simulated and without a browser.
#pragma once
#include <string>

#include "demos/slides/deck.h"

namespace demos {

/// "talk.toml:12: slide 5, 'Stacks': about 40 lines ..., but only 30 fit; ...", or empty. An
/// estimate from the smallest letters and lines, without tables: the page may still mark a slide
/// that passes.
std::string crowdingOf(const Deck& deck, const Slide& slide, std::size_t number);

}  // namespace demos
