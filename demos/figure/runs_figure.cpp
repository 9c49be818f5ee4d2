#include "demos/figure/runs_figure.h"
#include "demos/options/picture_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "demos/figure/figure_file.h"
#include "demos/figure/moments_figure.h"
#include "demos/film/pattern.h"
#include "demos/measures/plot_file.h"
#include "demos/text/complaints.h"
#include "demos/text/stop.h"
#include "demos/text/table.h"
#include "render/encode/png.h"

namespace demos {
namespace {

std::string pictureFile(const PanelFigure& figure, const RunsFigureSettings& settings,
                        const Options& options) {
    if (options.outputs.size() > 1)
        throw Stop(Exit::usage,
                   fmt::format("{} outputs; with --width there is one picture, give one "
                               "--output",
                               options.outputs.size()));
    const std::string pattern =
        options.outputs.empty() ? settings.picture : options.outputs.front();
    if (pattern == "-") return pattern;
    const FilmPlan& plan = figure.plans.front();
    const std::string name = expandPattern(pattern, {0, figure.time, plan.name, plan.quality});
    if (!name.ends_with(".png"))
        throw Stop(Exit::usage,
                   fmt::format("--output '{}': with --width a picture ends in .png, or "
                               "is -; a film has no --width",
                               printable(name)));
    return name;
}

/// Charts for the screen are always replaced; a figure with a caption is not.
bool hasCaption(const std::string& file, const Options& options) {
    return !captionFiles({file}, options).empty();
}

/// "penetration, residual over solver.substeps"
std::string plottedText(const std::vector<Chart>& charts) {
    if (charts.empty()) return {};
    std::vector<std::string> names;
    for (const Chart& chart : charts)
        names.push_back(chart.yTitle.substr(0, chart.yTitle.find(": ")));
    return fmt::format("{} over {}", fmt::join(names, ", "), charts.front().xTitle);
}

std::string capital(std::string text) {
    if (!text.empty())
        text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text;
}

/// A file to write, and what it contains.
struct Written {
    std::string what, file;
};

std::vector<Written> filesOf(const std::string& what, const std::string& file,
                             const Options& options) {
    std::vector<Written> files{{what, file}};
    for (const std::string& caption : captionFiles({file}, options))
        files.push_back({"the caption of " + what, caption});
    return files;
}

/// Throws Stop (usage) if two files have the same place; the options check "-" themselves.
void checkApart(const std::vector<Written>& all) {
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (all[i].file != "-" && all[k].file != "-" &&
                placeOf(all[i].file) == placeOf(all[k].file))
                throw Stop(Exit::usage,
                           fmt::format("{} and {} would both be '{}'; give one of them another "
                                       "name{}",
                                       all[k].what, all[i].what, printable(all[i].file),
                                       all[i].what.starts_with("the caption")
                                           ? ", the caption with --caption FILE"
                                           : ""));
}

}  // namespace

void checkFigureOptions(const RunsOptions& options, bool pictured, const char* remedy) {
    if (options.time && !options.width)
        throw Stop(Exit::usage, fmt::format("--time {}: belongs to a figure; give --width, for "
                                            "example --width 85mm",
                                            *options.time));
    if ((options.width && pictured) || !options.plot.empty()) return;
    if (!options.caption.empty() || options.width)
        throw Stop(Exit::usage, fmt::format("{} belongs to a figure; give {}",
                                            options.width ? "--width" : "--caption",
                                            options.width ? remedy : "--width or --plot FILE"));
}

RunsFigure::RunsFigure(RunsFigureSettings settings, const RunsOptions& options)
    : settings_(std::move(settings)), options_(options), chartOptions_(options) {
    if (!settings_.pictured.empty()) {
        panels_ = planPanels(settings_.pictured, settings_.columns, settings_.chart, options_);
        target_ = pictureFile(*panels_, settings_, options_);
        checkFigure({target_}, options_);
        chartOptions_.caption.clear();
        chartOptions_.size.reset();  // the pictures' ratio
    }
    if (options_.plot.empty()) return;
    checkChartFile(options_.plot);
    if (options_.width) chartSize(std::size_t{1}, paperOf(options_), chartOptions_.size);
    if (hasCaption(options_.plot, chartOptions_)) checkFigure({options_.plot}, chartOptions_);
    std::vector<Written> files = filesOf("the chart", options_.plot, chartOptions_);
    if (!target_.empty())
        for (const Written& file : filesOf("the pictures", target_, options_))
            files.push_back(file);
    checkApart(files);
}

void RunsFigure::write(const std::vector<Chart>& below, const std::vector<Chart>& alone,
                       const Talk& talk) const {
    if (!options_.plot.empty()) writeChart(alone, talk);
    if (panels_) writePictures(below, talk);
}

/// ": (a) nudges; (b) Baumgarte, 0.2", a sentence of its own if the title has a colon.
std::string RunsFigure::runsText() const {
    const char* first = settings_.title.find(": ") == std::string::npos ? ":" : ".";
    std::string text;
    for (std::size_t i = 0; i < settings_.pictured.size(); ++i)
        text += fmt::format("{} {} {}", i == 0 ? first : ";", panelLetter(static_cast<int>(i)),
                            settings_.pictured[i].label);
    return text;
}

/// What all runs share of the world; the rest is in their own lines.
void RunsFigure::addShared(Caption& caption) const {
    const SceneDescription& first = settings_.runs.front().scene;
    const bool alike =
        std::all_of(settings_.runs.begin(), settings_.runs.end(), [&](const Variant& run) {
            return run.scene.hz == first.hz && run.scene.gravity == first.gravity &&
                   run.scene.seed == first.seed;
        });
    if (alike) return addWorld(first, options_, caption);
    caption.add("scene", options_.scene());
}

/// A line per run: its settings, solver and state.
void RunsFigure::addRuns(const std::vector<Variant>& runs, const DrawnPanels* drawn,
                         Caption& caption) const {
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const Variant& run = runs[i];
        std::string text =
            fmt::format("{}: {} ({}, {} steps a second)", run.label, fmt::join(run.settings, " "),
                        solverText(run.scene), run.scene.hz);
        if (drawn) text += fmt::format(", state {}", hexText(drawn->facts[i].state));
        if (drawn && !drawn->diverged[i].empty()) text += ", diverged: " + drawn->diverged[i];
        caption.add(drawn ? panelLetter(static_cast<int>(i)) : fmt::format("run {}", i + 1), text);
    }
}

void RunsFigure::writePictures(const std::vector<Chart>& charts, const Talk& talk) const {
    const DrawnPanels drawn = drawPanels(*panels_, charts);
    const Overlays& overlays = panels_->plans.front().panels.front().overlays;
    Caption caption(settings_.title + runsText() + ". " + timesText(drawn.facts) +
                    scalesText(overlays, drawn.facts) +
                    (settings_.chart ? "; below: " + plottedText(charts) : ""));
    const PictureSize size{drawn.image.width, drawn.image.height};
    addFiles({target_}, size, panels_->paper, caption);
    addLook(overlays, drawn.facts, caption);
    addShared(caption);
    caption.add("time", fmt::format("{:.3f} s", panels_->time));
    caption.add("set", fmt::format("{}", fmt::join(options_.overrides, " ")));
    addRuns(settings_.pictured, &drawn, caption);
    addProgram(options_, caption);
    writeFigure({{target_, render::encodePng(drawn.image, panels_->paper.dpi)}}, caption.text(),
                options_, existingFiles(options_.overwrite));
    talk.json(fmt::format(R"({{"event":"figure","file":{},"time":{},"size":[{},{}]}})",
                          jsonString(target_), numberText(panels_->time), size.width, size.height));
    talk.say(fmt::format("wrote {} ({} pictures, t = {:.3f} s, {}x{})", printable(target_),
                         drawn.facts.size(), panels_->time, size.width, size.height));
    reportLeftOut(drawn.facts, panels_->layout.picture, panels_->paper, talk);
    reportCaptions({target_}, options_, talk);
}

void RunsFigure::writeChart(const std::vector<Chart>& charts, const Talk& talk) const {
    const SceneDescription& scene = settings_.runs.front().scene;
    const Paper paper = paperOf(options_);
    const std::string theme = themeOf(scene, options_);
    const PictureSize size =
        paper.given() ? chartSize(charts, paper, chartOptions_.size) : chartSize(charts.size());
    const std::string what = capital(plottedText(charts));
    Caption caption(fmt::format("{}. {}{:g} s of simulated time", settings_.title,
                                what.empty() ? "" : what + "; ", scene.seconds));
    addFiles({options_.plot}, size, paper, caption);
    caption.add("theme", theme);
    addShared(caption);
    caption.add("set", fmt::format("{}", fmt::join(options_.overrides, " ")));
    addRuns(settings_.runs, nullptr, caption);
    addProgram(options_, caption);
    writeFigure({{options_.plot, chartBytes(options_.plot, charts, size, theme, paper)}},
                caption.text(), chartOptions_, existingPlots({options_.plot}, chartOptions_));
    talk.say(fmt::format("wrote {}", printable(options_.plot)));
    reportCaptions({options_.plot}, chartOptions_, talk);
}

}  // namespace demos
