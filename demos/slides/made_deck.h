/// A deck with everything simulated and drawn, ready to be written.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "demos/slides/deck.h"

namespace demos {

/// A still, a strip or charts.
struct MadePicture {
    std::vector<std::uint8_t> png;
    std::string svg;  // the same as lines and text; empty for pictures drawn in pixels
    PictureSize size;  // pixels
    std::string says;  // its description for people who cannot see it: one line
};

struct MadeFilm {
    std::filesystem::path file;  // an .mp4 in DeckMaking::folder; empty: none is made
    int frames = 0;
    int fps = 30;             // of the film as it plays
    double first = 0.0;       // s of the run, at the first frame
    double secondsAFrame = 0.0;  // s of the run
    MadePicture poster;
};

/// Cells as text, numbers with their units.
struct MadeTable {
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;  // as many cells as the head
};

struct MadeSlide {
    Slide slide;  // with its numbers filled in: no @{...} is left
    std::optional<MadeFilm> film;
    std::vector<MadePicture> pictures;  // still or strip, then charts
    std::vector<MadeTable> tables;
    std::string command;  // makes the picture alone: "impulse compare nudges ..."; or empty
};

struct MadeDeck {
    Deck deck;
    std::vector<MadeSlide> slides;
    std::vector<std::string> diagnostics;  // notes and warnings, a line each
    std::string incident;  // the first in a slide's only run, "slide 'ID': LINE"; empty: none
    std::string compared;  // the same, of a slide that compares runs
};

}  // namespace demos
