/// The command line as plain values. options.cpp alone knows how it is parsed.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace demos {

enum class Command {
    render,
    still,
    strip,
    sim,
    plot,
    compare,
    sweep,
    exports,  // export is a word of the language
    slides,
    watch,
    gallery,
    test,
    approve,
    list,
    doctor,
    bench,
    completion
};

struct PictureSize {
    int width = 0, height = 0;  // pixels
};

struct Options {
    Command command = Command::list;
    std::vector<std::string> scenes;     // built-in names or paths; one, except for bench, test
    std::vector<std::string> overrides;  // "world.hz=240"

    // render, still; outputs, size and theme of plot too, outputs and fps of export
    std::vector<std::string> outputs;  // patterns; empty = the default
    std::string quality = "medium";
    bool qualityAsked = false;  // it was given
    std::optional<PictureSize> size;
    std::optional<int> fps;
    std::optional<int> samples;
    std::optional<int> blur;        // moments a frame is the mean of
    std::optional<double> shutter;  // open for so much of a frame, 0..1
    std::optional<double> seconds;  // length; also of sim, plot, export and bench
    std::vector<std::string> show;  // overlays, added to the scene's
    std::string theme;              // empty = the scene's
    std::string colorBy;            // empty = the scene's
    int jobs = 0;                   // 0 = a worker per core
    std::vector<std::string> passes;  // render: data beside the frames
    bool clean = false;             // no text
    bool overwrite = false;
    bool reproducible = false;
    std::string context = "auto";          // of OpenGL: auto, osmesa, egl
    bool dryRun = false;                   // render: say what it would be, draw nothing
    std::optional<std::uint64_t> maxSize;  // bytes a film may have, render
    std::string poster;                    // render: a .png; empty = not asked for
    std::optional<double> posterTime;      // s
    int moments = 6;                       // strip
    std::vector<double> times;             // s, strip; empty = evenly over the film
    int columns = 0;                       // strip; 0 = up to six, all rows alike
    std::optional<double> time;            // s, still
    std::optional<int> frame;              // still; negative counts from the end

    // sim
    std::string csv, bodies, joints, contacts, sweeps;  // a file or "-"; empty = not asked for
    std::string events;                                 // likewise
    bool exact = false;  // sweeps are compared with the direct solution
    int every = 1;
    bool hash = false;
    int hashEvery = 0;  // 0 = the last step only
    bool expect = true;
    std::string plot;  // a file; empty = not asked for

    // plot
    std::vector<std::string> what;  // charts; empty = the most telling ones that have data

    // compare, sweep: those of render, --csv and --plot of sim, and
    std::vector<std::string> vary, cases;  // KEY=VALUE,VALUE... | LABEL: KEY=VALUE KEY=VALUE
    std::string over;                      // KEY=FROM..TO
    std::string measure;                   // to plot; empty = the most telling
    bool film = true;                      // compare: draw it
    bool strip = true;                     // compare: a plot below the pictures
    bool listOnly = false;                 // compare: the built-in ones

    // test, approve
    std::string baselines;               // a folder; empty = beside the scenes
    std::string update;                  // missing, changed, all, none; empty = missing, or none
    std::string results = "output/test"; // approve: of which test
    bool cache = true, selfTest = false;
    bool all = false, prune = false;

    // still, strip, plot, compare, sweep: figures for papers
    std::optional<double> width;  // mm on paper
    int dpi = 300;                // pixels an inch, with a width
    std::string caption;          // a file; empty = beside the figure where that has a width

    // watch
    bool once = false;  // one draft, then the end

    // gallery
    bool films = true;

    bool quiet = false, json = false;
    bool print = false;    // list: the scene file itself
    bool schema = false;   // list: the JSON Schema of scene files
    bool benchFilm = false;  // bench: time drawing instead of steps
    bool phases = false;   // bench: and every phase of the loop
    std::string against;   // bench: an earlier run's JSON lines
    std::string shell = "bash";
    std::string commandLine;  // as a shell takes it, to go on after an interruption

    const std::string& scene() const { return scenes.front(); }
};

/// The options; nothing when help or the version was asked for and has been printed.
/// Throws Stop (usage).
std::optional<Options> parseOptions(int argc, const char* const* argv);

/// A command's name and what may follow it, for shells to complete.
struct CommandWords {
    std::string name;
    std::vector<std::string> options;
};
std::vector<CommandWords> commandWords();

}  // namespace demos
