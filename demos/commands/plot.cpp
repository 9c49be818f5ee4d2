#include <fmt/format.h>

#include "demos/commands/commands.h"
#include "demos/commands/input_protection.h"
#include "demos/commands/play_through.h"
#include "demos/commands/shared_options.h"
#include "demos/figure/caption.h"
#include "demos/figure/figure_file.h"
#include "demos/film/film_plan.h"
#include "demos/film/progress.h"
#include "demos/look/measure_names.h"
#include "demos/measures/plot_file.h"
#include "demos/snapshot/player.h"
#include "demos/text/complaints.h"
#include "demos/text/shell_word.h"
#include "demos/text/table.h"

namespace demos {
namespace {

struct PlotOptions : Options {
    std::vector<std::string> what;  // charts; empty = the most telling ones that have data
};

std::vector<std::string> filesOf(const PlotOptions& options, const SceneDescription& scene) {
    if (options.outputs.empty()) return {"output/" + scene.name + ".svg"};
    for (std::size_t i = 0; i < options.outputs.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (placeOf(options.outputs[k]) == placeOf(options.outputs[i]))
                throw Stop(Exit::usage, fmt::format("two plots go to '{}'; name another --output",
                                                    printable(options.outputs[i])));
    return options.outputs;
}

/// One run from time 0 to the end of the film.
class Plotting {
public:
    Plotting(const PlotOptions& options, const SceneDescription& scene)
        : options_(options),
          choice_(plotChoiceOf(options, options.what, scene)),
          files_(filesOf(options, scene)),
          talk_(options, false),
          player_(scene, Overlays{.trails = false}) {
        for (const std::string& file : files_) checkPlotFile(file, choice_);
        if (!captionFiles(files_, options_).empty()) checkFigure(files_, options_);
    }

    /// Writes the charts even if the run diverges: they help to find out why.
    Exit play() {
        playThrough(
            player_, options_, [this](long) { recorder_.look(player_.stage()); },
            [this] { writeAll(); });
        writeAll();
        talk_.say(fmt::format("next: impulse render {}", printable(shellWord(options_.scene()))));
        player_.stopIfIncident();
        return Exit::ok;
    }

private:
    void writeAll() const {
        const std::vector<Chart> charts = chartsOf(recorder_, choice_);
        const PictureSize size = sizeOf(charts, choice_);
        std::vector<FigurePicture> pictures;
        for (const std::string& file : files_)
            pictures.push_back(
                {file, chartBytes(file, charts, size, choice_.theme, choice_.paper)});
        writeFigure(pictures, captionOf(charts, size).text(), options_,
                    existingPlots(files_, options_));
        for (const std::string& file : files_) {
            talk_.say(fmt::format("wrote {} ({} {})", printable(file), charts.size(),
                                  charts.size() == 1 ? "chart" : "charts"));
            talk_.json(fmt::format(R"({{"event":"plot","file":{},"charts":{}}})", jsonString(file),
                                   charts.size()));
        }
        reportCaptions(files_, options_, talk_);
    }

    Caption captionOf(const std::vector<Chart>& charts, PictureSize size) const {
        const Stage& stage = player_.stage();
        std::string what;  // the charts' titles without the scene's name
        for (const Chart& chart : charts)
            what += (what.empty() ? "" : "; ") + chart.title.substr(stage.scene.name.size() + 2);
        const long step = stage.world.report().step;
        const double end = static_cast<double>(step) / stage.scene.hz;
        Caption caption(fmt::format("{}. Over {:g} s: {}", titleOf(stage.scene), end, what));
        addFiles(files_, size, choice_.paper, caption);
        caption.add("theme", choice_.theme);
        addPhysics(stage.scene, options_, caption);
        caption.add("steps", std::to_string(step));
        caption.add("state", hexText(stage.world.hash()));
        addProgram(options_, caption);
        return caption;
    }

    const PlotOptions& options_;
    PlotChoice choice_;
    std::vector<std::string> files_;
    Talk talk_;
    Player player_;
    Recorder recorder_;
};

Exit plot(const PlotOptions& options) { return Plotting(options, sceneOf(options)).play(); }

Run addPlot(CLI::App& app) {
    const auto asked = std::make_shared<Asked<PlotOptions>>();
    auto& options = asked->options;
    auto& texts = asked->texts;
    addSceneChoice(app, options, texts);
    takesAgain(app.add_option("-o,--output", options.outputs,
                              "a .svg or a .png; may be given again; default: output/<scene>.svg")
                   ->type_name("FILE"));
    takesList(
        app.add_option(
               "--what", texts.what,
               "charts, with commas: energy penetration separation contacts impulse residual; "
               "default: those of energy,penetration,separation,residual that have data")
            ->type_name("NAMES"));
    app.add_option("--size", texts.size,
                   "pixels, 1..16384 a side; default: 1280 wide, 360 high per chart, at least 720")
        ->type_name("WxH");
    app.add_option("--theme", options.theme,
                   "studio, dark, print, transparent or lab; default: the scene's")
        ->type_name("NAME");
    addFigure(app, options, texts);
    app.add_flag("--overwrite", options.overwrite,
                 "replace a figure and its caption; a plot without a caption is always replaced; "
                 "default: off");
    addSeconds(app, options);
    addFeedback(app, options);
    return [asked](const std::string& commandLine) {
        PlotOptions& given = settled(*asked, commandLine);
        if (!given.overwrite) spareOthers(ResultKind::chart, given.outputs);
        given.what = asked->texts.what;
        for (const std::string& name : given.what) checkName("--what", name, measureNames());
        return plot(given);
    };
}

}  // namespace

Command plotCommand() {
    return {
        "plot",
        "physics only: charts of energy, penetration, impulses, residuals",
        {"impulse plot stack", "impulse plot stack -o stack.png --what energy,impulse --theme dark",
         "impulse plot my.toml -o a.svg -o a.png --size 1920x1080 --set solver.sweeps=4"},
        addPlot};
}

}  // namespace demos
