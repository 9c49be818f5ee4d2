#include "demos/slides/slide_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "demos/slides/slide_arrangement.h"
#include "demos/text/complaints.h"
#include "demos/text/shell_word.h"

namespace demos {
namespace {

int evenPart(int pixels, double share) {
    return std::max(2 * static_cast<int>(std::lround(0.5 * share * pixels)), 2);
}

/// A command line of impulse, with words quoted where necessary.
class CommandLine {
public:
    explicit CommandLine(const std::string& command) : text_("impulse " + command) {}
    void add(const std::string& word) { text_ += " " + shellWord(word); }
    void add(const std::string& option, const std::string& value) {
        text_ += " " + option;
        add(value);
    }
    void addEach(const std::string& option, const std::vector<std::string>& values) {
        for (const std::string& value : values) add(option, value);
    }
    const std::string& text() const { return text_; }

private:
    std::string text_;
};

const char* verbOf(const Slide& slide) {
    if (!slide.runs.over.empty()) return "sweep";
    if (slide.runs.several()) return "compare";
    switch (slide.exhibit) {
        case Exhibit::film:
            return "render";
        case Exhibit::still:
            return "still";
        case Exhibit::strip:
            return "strip";
        case Exhibit::none:
            break;
    }
    return "plot";
}

void addRuns(const SlideRuns& runs, CommandLine& line) {
    line.add(runs.comparison.empty() ? runs.scene : runs.comparison);
    line.addEach("--set", runs.settings);
    line.addEach("--vary", runs.vary);
    line.addEach("--case", runs.cases);
    if (!runs.over.empty()) line.add("--over", runs.over);
}

/// Adds the charts of a slide without a picture.
void addCharts(const Slide& slide, const LoadedRuns& loaded, CommandLine& line) {
    if (!loaded.several) return line.add("--what", fmt::format("{}", fmt::join(slide.plots, ",")));
    line.add("--measure", slide.plots.front());
    if (!loaded.isSweep()) line.add("--no-film");
    line.add("--plot", slide.id + ".svg");
}

/// A shell comment, as the command has no option for it.
std::string spanOf(const Slide& slide, const LoadedRuns& loaded) {
    if (slide.exhibit != Exhibit::film) return {};
    std::string span;
    if (slide.from > 0.0)
        span += fmt::format(" shows {} s to {} s", numberText(slide.from),
                            numberText(untilOf(slide, loaded.variants.front())));
    if (slide.slow != 1.0)
        span += fmt::format("{} at {} times the speed", span.empty() ? " plays" : ",",
                            numberText(slide.slow));
    return span.empty() ? "" : "  # the slide" + span;
}

/// Stills and strips have commands for one run; for several runs the command makes a film.
void addTimes(const Slide& slide, const LoadedRuns& loaded, PictureSize whole, CommandLine& line) {
    const bool film = slide.exhibit == Exhibit::film || slide.exhibit == Exhibit::none;
    if (film || loaded.several) {
        if (slide.until) line.add("--seconds", numberText(*slide.until));
        return;
    }
    std::string times;
    for (const double time : momentTimes(slide, untilOf(slide, loaded.variants.front())))
        times += (times.empty() ? "" : ",") + fmt::format("{:.6g}", time);
    line.add(slide.exhibit == Exhibit::still ? "-t" : "--times", times);
    if (slide.exhibit == Exhibit::strip && !loaded.several)
        line.add("--columns", std::to_string(stripColumns(slide, whole)));
}

/// Whether one film or still stands beside words, in a column that is higher than a wide picture.
bool fillsColumn(const Slide& slide) {
    if (slide.runs.several() || slide.exhibit == Exhibit::strip) return false;
    const SlideLayout layout = plannedLayout(slide);
    return layout == SlideLayout::beside || layout == SlideLayout::even ||
           layout == SlideLayout::openingPictured;
}

}  // namespace

int stripColumns(const Slide& slide, PictureSize whole) {
    const double aspect = static_cast<double>(whole.width) / whole.height;
    return arrangement(slide, static_cast<std::size_t>(std::max(slide.moments, 1)), aspect).columns;
}

PictureSize pictureSize(const Slide& slide, PictureSize whole) {
    const bool tall = fillsColumn(slide);
    const double share = standsAlone(slide) && !tall ? 1.0 : 2.0 / 3.0;
    const PictureSize size{evenPart(whole.width, share), evenPart(whole.height, share)};
    return {size.width, tall ? std::max(size.height, evenPart(size.width, 0.75)) : size.height};
}

Options optionsOf(const Slide& slide, const Deck& deck, const DeckMaking& making) {
    Options options;
    options.jobs = making.options.jobs;
    options.context = making.options.context;
    options.samples = making.options.samples;
    options.reproducible = making.options.reproducible;
    options.quiet = true;
    const SlideRuns& runs = slide.runs;
    options.scenes = {runs.comparison.empty() ? runs.scene : runs.comparison};
    options.overrides = runs.settings;
    options.show = slide.show;
    options.colorBy = slide.colorBy;
    options.theme = deck.theme;
    options.size = pictureSize(slide, deck.size);
    return options;
}

std::string commandOf(const Slide& slide, const Deck& deck, const LoadedRuns& loaded) {
    const bool drawn = slide.exhibit != Exhibit::none;
    if (loaded.variants.empty() || (!drawn && slide.plots.empty())) return {};
    CommandLine line(verbOf(slide));
    addRuns(slide.runs, line);
    addTimes(slide, loaded, deck.size, line);
    if (!drawn) addCharts(slide, loaded, line);
    if (drawn && !slide.show.empty())
        line.add("--show", fmt::format("{}", fmt::join(slide.show, ",")));
    if (drawn && !slide.colorBy.empty()) line.add("--colour-by", slide.colorBy);
    line.add("--theme", deck.theme);
    if (drawn && loaded.isSweep()) line.add("-o", slide.id + ".mp4");
    return line.text() + spanOf(slide, loaded);
}

}  // namespace demos
