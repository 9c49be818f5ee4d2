/// One [[slide]] of a deck's file.
#pragma once
#include <filesystem>
#include <optional>
#include <string_view>

#include "demos/scene/keys.h"
#include "demos/slides/deck.h"
#include "demos/slides/section_slide.h"

namespace demos {

/// What all slides of a deck are read with.
struct DeckReading {
    const std::filesystem::path& folder;  // of the deck's file
    std::string_view source;              // its text
    std::optional<int> fps;               // that the deck gives
    Complaints& complaints;
    SectionFiles sections;
    std::vector<std::filesystem::path> files = {};  // that scenes were read from
};

/// `opening`: its title is the deck's.
Slide readSlide(Keys keys, bool opening, DeckReading& reading);

/// "03-clamp-the-total": a name for files. `number` counts from 1 of `count`.
std::string slideId(int number, std::size_t count, const std::string& title);

}  // namespace demos
