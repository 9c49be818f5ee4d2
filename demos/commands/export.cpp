#include <fmt/format.h>

#include <algorithm>

#include "demos/commands/commands.h"
#include "demos/commands/play_through.h"
#include "demos/commands/shared_options.h"
#include "demos/export/export_file.h"
#include "demos/export/recording.h"
#include "demos/film/film_plan.h"
#include "demos/film/progress.h"
#include "demos/processes/signals.h"
#include "demos/text/complaints.h"
#include "demos/text/hex_text.h"
#include "demos/text/plural.h"
#include "demos/text/shell_word.h"
#include "demos/text/table.h"

namespace demos {
namespace {

FilmPlan planOf(const Options& options) {
    Panel panel;
    panel.scene = sceneOf(options);
    return planFilm({std::move(panel)}, false, options);
}

/// Warns where the film is shorter than one frame.
void tellShort(const FilmPlan& plan, const Options& options) {
    if (options.seconds && *options.seconds * plan.fps < 1.0)
        Talk(options, false)
            .mention(fmt::format("--seconds {}: less than one frame ({:.3g} s); only the first "
                                 "frame is written",
                                 *options.seconds, 1.0 / plan.fps));
}

std::string contentText(ExportKind kind, const Recording& run, std::size_t bytes) {
    if (kind == ExportKind::events) return plural(run.events.size(), "event");
    if (kind == ExportKind::replay)
        return fmt::format("{}, {} kB", plural(run.frames.size(), "frame"), bytes / 1000);
    return fmt::format("{}, {}", plural(run.frames.size(), "frame"),
                       plural(run.bodies.size(), "body", "bodies"));
}

/// One run from time 0 to the end of the film.
class Exporting {
public:
    Exporting(const Options& options, const FilmPlan& plan, std::vector<ExportFile> files)
        : options_(options),
          files_(std::move(files)),
          talk_(options, false),
          player_(plan.scene(), plan.panels.front().overlays),
          recorder_(plan) {
        const auto isEvents = [](const ExportFile& f) { return f.kind == ExportKind::events; };
        if (std::any_of(files_.begin(), files_.end(), isEvents)) player_.watchTouches();
    }

    void play() {
        playThrough(
            player_, options_, [this](long step) { recorder_.look(player_, step); },
            [this] {
                if (!interrupted()) writeAll();  // to the last good step, if the run ended early
            });
        writeAll();
        const Stage& stage = player_.stage();
        talk_.json(fmt::format(R"({{"event":"done","steps":{},"state":"{}"}})",
                               stepsOf(stage.scene), hexText(stage.world.hash())));
        player_.stopIfIncident();
    }

private:
    void writeAll() {
        const Recording& run = recorder_.finished(player_.stage());
        render::FilesTogether together(existingFiles(options_.overwrite));
        std::vector<WrittenExport> written;
        for (const ExportFile& file : files_)
            written.push_back(writeExport(file, player_.stage(), run, together));
        together.publish();
        for (std::size_t i = 0; i < files_.size(); ++i) tell(files_[i], written[i], run);
    }

    void tell(const ExportFile& file, const WrittenExport& written, const Recording& run) const {
        talk_.say(fmt::format("wrote {} ({})", printable(file.name),
                              contentText(file.kind, run, written.bytes)));
        if (!written.left.empty()) talk_.mention(written.left);
        talk_.json(fmt::format(
            R"({{"event":"export","file":{},"frames":{},"bodies":{},"events":{},"bytes":{}}})",
            jsonString(file.name), run.frames.size(), run.bodies.size(), run.events.size(),
            written.bytes));
    }

    const Options& options_;
    std::vector<ExportFile> files_;
    Talk talk_;
    Player player_;
    RunRecorder recorder_;
};

bool hasCamera(const ExportFile& file) {
    return file.kind == ExportKind::glb || file.kind == ExportKind::replay;
}

Exit exportRun(const Options& options) {
    FilmPlan plan = planOf(options);
    checkLength(plan);
    tellShort(plan, options);
    const std::vector<ExportFile> files = exportFilesOf(options, plan.scene());
    if (std::any_of(files.begin(), files.end(), hasCamera)) fitCameras(plan);
    Exporting(options, plan, files).play();
    Talk(options, false)
        .say(fmt::format("next: impulse render {}", printable(shellWord(options.scene()))));
    return Exit::ok;
}

Run addExport(CLI::App& app) {
    const auto asked = std::make_shared<Asked<Options>>();
    auto& options = asked->options;
    auto& texts = asked->texts;
    addSceneChoice(app, options, texts);
    takesAgain(
        app.add_option(
               "-o,--output", options.outputs,
               ".glb: bodies, colours and camera with their motion; .csv: poses, one row per frame "
               "and body, with the columns of 'sim --bodies'; .npz: the same, energies and "
               "contacts as numpy arrays; .json: the events of 'sim --events'; .html: a page that "
               "shows the run from all sides, without a network; may be given again; "
               "default: output/<scene>.glb")
            ->type_name("FILE"));
    app.add_option("--fps", options.fps,
                   "frames per second; must divide the scene's steps per second; default: 30")
        ->type_name("N");
    addSeconds(app, options);
    app.add_flag("--overwrite", options.overwrite, "replace existing files; default: off");
    addFeedback(app, options);
    return
        [asked](const std::string& commandLine) { return exportRun(settled(*asked, commandLine)); };
}

}  // namespace

Command exportCommand() {
    return {"export",
            "how the bodies move, for other programs: glTF, CSV, numpy, events",
            {"impulse export wall -o wall.glb -o replay.html",
             "impulse export stack -o stack.csv -o stack.npz --fps 60",
             "impulse export my.toml -o events.json --seconds 2"},
            addExport};
}

}  // namespace demos
