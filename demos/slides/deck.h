/// A deck as plain data: what every slide says and shows, before anything is simulated or drawn.
///
/// It is made from a deck file (read_deck.h) or from scenes' sections (deck_of_scenes.h);
/// make_deck.h simulates and draws what it needs; deck_files.h writes the result.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "demos/options/options.h"
#include "demos/scene/description.h"

namespace demos {

/// What a slide shows of its runs.
enum class Exhibit {
    none,   // only words, charts and tables
    film,   // from..until; several runs side by side
    still,  // one moment
    strip   // several moments in a row
};

/// One run, or several that are compared.
struct SlideRuns {
    std::string scene;                  // a built-in name, or a path from the current folder
    std::vector<std::string> settings;  // as --set takes them, for all runs
    std::string comparison;             // of builtinComparisons(); has a scene of its own
    std::vector<std::string> vary;      // as --vary of compare
    std::vector<std::string> cases;     // as --case of compare
    std::string over;                   // as --over of sweep: one setting over many values
    bool several() const {
        return !comparison.empty() || !vary.empty() || !cases.empty() || !over.empty();
    }
    bool any() const { return !scene.empty() || !comparison.empty(); }
};

struct Slide {
    std::string id;        // unique, for names of files: "03-clamp"
    std::string title;     // one line of CommonMark
    std::string text;      // CommonMark with $formulas$ and @{numbers}
    std::vector<std::string> formulas;  // LaTeX, each on its own line
    std::string code;                   // shown verbatim, line by line
    std::string caption;   // below the exhibit; CommonMark
    std::string notes;     // for the speaker; CommonMark
    bool opening = false;  // the title slide

    SlideRuns runs;
    Exhibit exhibit = Exhibit::none;
    double from = 0.0;            // s of the run
    std::optional<double> until;  // s; else the run's end. Numbers and tables are taken then
    std::optional<double> at;     // s, of a still; else the time of `poster`
    int moments = 4;              // of a strip
    std::vector<std::string> show;  // overlays, added to the scene's
    std::string colorBy;            // empty = the scene's
    double slow = 1.0;            // a film at this share of its speed
    bool reveal = false;          // the items of the text's lists appear one after the other
    bool pause = false;           // a film waits on its first frame until it is started
    bool loop = false;            // a film starts again at its end
    std::string poster = "last";  // "last", "first" or a time in s of the run

    std::vector<std::string> plots;  // charts: of measureNames(); of several runs: measures()
    bool measures = false;           // a table of measures(), a row per run
    bool expectations = false;       // a table of the scene's [[expect]] with measured values
    Place place;                     // in the deck's file
};

constexpr int kLeastSlideSide = 64, kMostSlideSide = 8192;  // pixels; an even number

struct Deck {
    std::string name;  // the file's stem, or the first scene's name
    std::string title, subtitle, author, date;
    std::string theme = "studio";   // studio, dark or print: of the slides and their pictures
    PictureSize size{1280, 720};    // pixels of a picture that fills a slide
    int fps = 30;                   // of films
    std::vector<Slide> slides;
    std::vector<std::filesystem::path> files;  // the files read for it; no output replaces them
};

}  // namespace demos
