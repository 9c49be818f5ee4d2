#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "demos/commands/commands.h"
#include "demos/commands/table.h"
#include "demos/export/export_file.h"
#include "demos/export/recording.h"
#include "demos/export/replay_page.h"
#include "demos/film/film_plan.h"
#include "demos/film/progress.h"
#include "demos/film/signals.h"
#include "demos/scene/complaints.h"

namespace demos {
namespace {

constexpr double kMostPoses = 1e7;  // of all bodies and frames: a gigabyte of memory

FilmPlan planOf(const Options& options) {
    Panel panel;
    panel.scene = sceneOf(options);
    return planFilm({std::move(panel)}, false, options);
}

void checkLength(const FilmPlan& plan) {
    const std::size_t bodies = plan.scene().bodies.size();
    if (static_cast<double>(bodies) * plan.frames > kMostPoses)
        throw Stop(
            Exit::usage,
            fmt::format("{} bodies in {} frames; an export holds at most {:.0f} million poses: "
                        "lower --fps or --seconds",
                        bodies, plan.frames, kMostPoses / 1e6));
}

/// One run from time 0 to the end of the film.
class Exporting {
public:
    Exporting(const Options& options, const FilmPlan& plan, std::vector<ExportFile> files)
        : options_(options),
          files_(std::move(files)),
          talk_(options, false),
          player_(plan.scene(), plan.panels.front().overlays),
          recorder_(plan.stepsPerFrame, plan.panels.front().overlays) {
        const auto isEvents = [](const ExportFile& f) { return f.kind == ExportKind::events; };
        if (std::any_of(files_.begin(), files_.end(), isEvents)) player_.watchTouches();
    }

    void play() {
        watchSignals();
        const Stage& stage = player_.stage();
        const long steps = std::max(std::lround(stage.scene.seconds * stage.scene.hz), 1L);
        recorder_.look(player_, 0);
        for (long step = 1; step <= steps; ++step) {
            advance(step);
            if (interrupted()) stopInterrupted(step);
        }
        writeAll();
        talk_.json(fmt::format(R"({{"event":"done","steps":{},"state":"{}"}})", steps,
                               hexText(stage.world.hash())));
    }

private:
    /// A run that diverges is worth a look all the more.
    void advance(long step) try {
        player_.step();
        recorder_.look(player_, step);
    } catch (const Stop&) {
        writeAll();
        throw;
    }

    [[noreturn]] void stopInterrupted(long step) {
        writeAll();
        throw Stop(Exit::interrupted, fmt::format("interrupted after step {}; to run it again: {}",
                                                  step, options_.commandLine));
    }

    void writeAll() {
        const Trajectory& run = recorder_.finished();
        const std::size_t frames = run.frames.size(), bodies = player_.stage().bodies.size();
        for (const ExportFile& file : files_) {
            const std::size_t bytes = writeExport(file, player_.stage(), run);
            if (file.kind == ExportKind::events)
                talk_.say(
                    fmt::format("wrote {} ({} events)", printable(file.name), run.events.size()));
            else
                talk_.say(fmt::format("wrote {} ({} frames, {} bodies)", printable(file.name),
                                      frames, bodies));
            talk_.json(fmt::format(
                R"({{"event":"export","file":{},"frames":{},"bodies":{},"events":{},"bytes":{}}})",
                jsonString(file.name), frames, bodies, run.events.size(), bytes));
        }
    }

    const Options& options_;
    std::vector<ExportFile> files_;
    Talk talk_;
    Player player_;
    TrajectoryRecorder recorder_;
};

/// What is a page of its own takes more from a run than the files do, and plays it itself.
void writeReplays(const FilmPlan& plan, const std::vector<ExportFile>& files, const Talk& talk) {
    const Recording recording = recordingOf(plan);
    const ReplayPage page = replayPage(recording);
    for (const ExportFile& file : files) {
        writeResult(file.name, {reinterpret_cast<const std::uint8_t*>(page.html.data()),
                                page.html.size()});
        talk.say(fmt::format("wrote {} ({} frames, {} kB)", printable(file.name),
                             recording.frames.size(), page.html.size() / 1000));
        talk.json(fmt::format(
            R"({{"event":"export","file":{},"frames":{},"bodies":{},"bytes":{}}})",
            jsonString(file.name), recording.frames.size(), recording.bodies.size(),
            page.html.size()));
    }
    if (!page.left.empty()) talk.mention(page.left);
    if (!recording.trouble.empty()) throw Stop(Exit::diverged, recording.trouble);
}

}  // namespace

Exit exportCommand(const Options& options) {
    const FilmPlan plan = planOf(options);
    checkLength(plan);
    const Talk talk(options, false);
    std::vector<ExportFile> files = exportFilesOf(options, plan.scene()), replays;
    const auto isReplay = [](const ExportFile& file) { return file.kind == ExportKind::replay; };
    std::copy_if(files.begin(), files.end(), std::back_inserter(replays), isReplay);
    std::erase_if(files, isReplay);
    if (!replays.empty()) writeReplays(plan, replays, talk);
    if (!files.empty()) Exporting(options, plan, std::move(files)).play();
    talk.say(fmt::format("next: impulse render {}", printable(options.scene())));
    return Exit::ok;
}

}  // namespace demos
