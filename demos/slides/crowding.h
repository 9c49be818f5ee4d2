/// Slides with more words than fit: told before a deck is played, where no browser measures them.
#pragma once
#include <string>

#include "demos/slides/deck.h"

namespace demos {

/// "talk.toml:12: slide 5, 'Stacks': about 40 lines where 30 fit; ...", or empty. An estimate by
/// letters and lines at their smallest, without tables: the page may still mark a slide that
/// passes.
std::string crowdingOf(const Deck& deck, const Slide& slide, std::size_t number);

}  // namespace demos
