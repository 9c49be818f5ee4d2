/// Reads one [[slide]] of a deck's file.
#pragma once
#include <filesystem>
#include <optional>
#include <string_view>

#include "demos/scene/keys.h"
#include "demos/slides/deck.h"
#include "demos/slides/section_slide.h"

namespace demos {

/// The context in which all slides of a deck are read.
struct DeckReading {
    const std::filesystem::path& folder;  // of the deck's file
    std::string_view source;              // its text
    std::optional<int> fps;               // if the deck gives it
    Complaints& complaints;
    SectionFiles sections;
    std::vector<std::filesystem::path> files = {};  // the files of scenes
};

/// `opening`: the slide has the deck's title.
Slide readSlide(Keys keys, bool opening, DeckReading& reading);

/// "03-clamp-the-total": a name for files. `number` counts from 1 of `count`.
std::string slideId(int number, std::size_t count, const std::string& title);

}  // namespace demos
