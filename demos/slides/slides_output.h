/// The outputs of a deck: the extension of a name selects what is written.
#pragma once
#include <string>
#include <vector>

#include "demos/options/options.h"
#include "demos/slides/deck.h"

namespace demos {

enum class SlidesKind { page, pdf, pptx, folder };

struct SlidesOutput {
    SlidesKind kind = SlidesKind::page;
    std::string name;
};

/// The outputs of -o, or the default. Throws Stop (usage, wouldOverwrite) or render::Error if one
/// cannot be written, two have the same place, or one would overwrite a source of the deck.
std::vector<SlidesOutput> slidesOutputsOf(const Options& options, const Deck& deck);

}  // namespace demos
