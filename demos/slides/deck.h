/// A deck as plain data: what every slide says and shows, before anything is played or drawn.
///
/// The reader makes it of a deck file (read_deck.h) or of scenes' sections (deck_of_scenes.h);
/// make_deck.h plays and draws what it asks for; slides_page.h, slides_folder.h and slides_pdf.h
/// write it down.
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
    none,   // words, charts and tables alone
    film,   // from..until; of several runs side by side
    still,  // one moment
    strip   // several moments in a row
};

/// One run, or several that are compared.
struct SlideRuns {
    std::string scene;                  // a built-in name, or a path that is right from here
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
    std::vector<std::string> formulas;  // LaTeX, each on a line of its own
    std::string code;                   // set as it is, line by line
    std::string caption;   // below the exhibit; CommonMark
    std::string notes;     // for who speaks; CommonMark
    bool opening = false;  // the title's slide

    SlideRuns runs;
    Exhibit exhibit = Exhibit::none;
    double from = 0.0;            // s of the run
    std::optional<double> until;  // s; else the run's end. Numbers and tables are of this moment
    std::optional<double> at;     // s, of a still; else as `poster` says
    int moments = 4;              // of a strip
    std::vector<std::string> show;  // overlays, added to the scene's
    std::string colorBy;            // empty = the scene's
    double slow = 1.0;            // a film at this share of its speed
    bool pause = false;           // a film waits on its first frame until it is asked to go on
    bool loop = false;            // a film begins again at its end
    std::string poster = "last";  // "last", "first" or a time in s of the run

    std::vector<std::string> plots;  // charts: of measureNames(); of several runs: measures()
    bool measures = false;           // a table of measures(), a row a run
    bool expectations = false;       // a table of the scene's [[expect]] with what came out
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
    std::vector<std::filesystem::path> files;  // that were read for it, which no output replaces
};

}  // namespace demos
