/// Where a deck goes: the ending picks what is written.
#pragma once
#include <string>
#include <vector>

#include "demos/options/options.h"
#include "demos/slides/deck.h"

namespace demos {

enum class SlidesKind { page, pdf, folder };

struct SlidesOutput {
    SlidesKind kind = SlidesKind::page;
    std::string name;
};

/// Those of -o, or the default. Throws Stop (usage, wouldOverwrite) or render::Error for what
/// cannot be written, or twice to one place, or over what the deck was read from.
std::vector<SlidesOutput> slidesOutputsOf(const Options& options, const Deck& deck);

}  // namespace demos
