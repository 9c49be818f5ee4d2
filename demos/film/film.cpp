#include "demos/film/film.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <utility>

#include "demos/film/film_needs.h"
#include "demos/film/frame_files.h"
#include "demos/film/outputs.h"
#include "demos/film/poster.h"
#include "demos/film/progress.h"
#include "demos/processes/signals.h"
#include "demos/text/complaints.h"
#include "demos/text/plural.h"
#include "demos/text/shell_word.h"
#include "demos/text/stop.h"
#include "demos/text/table.h"
#include "demos/text/text_hash.h"
#include "demos/text/version.h"
#include "render/driver_environment.h"
#include "render/encode/ffmpeg.h"
#include "render/encode/file.h"
#include "render/encode/video.h"
#include "render/error.h"

namespace demos {
namespace {

void writeRaw(const render::Image& image) {
    std::span<const std::uint8_t> bytes = image.pixels;
    while (!bytes.empty()) {
        const ssize_t wrote = write(STDOUT_FILENO, bytes.data(), bytes.size());
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote < 0)
            throw render::Error("cannot write to standard output: " + render::describeError(errno));
        bytes = bytes.subspan(static_cast<std::size_t>(wrote));
    }
}

struct Film {
    std::filesystem::path path;
    std::unique_ptr<render::VideoWriter> writer;
};

render::VideoSource sourceOf(const FilmPlan& plan) {
    return {plan.layout.width, plan.layout.height, plan.fps, plan.alpha()};
}

render::Fit fitOf(const FilmOptions& options, const Talk& talk) {
    return {options.maxSize.value_or(0), interrupted,
            [&talk](const std::string& line) { talk.mention(line); }};
}

/// All that one run writes.
class Writers {
public:
    Writers(const FilmPlan& plan, const std::vector<Output>& outputs, const RunRecord& record,
            Poster poster, const FilmOptions& options, const Talk& talk)
        : poster_(std::move(poster)), existing_(existingFiles(options.overwrite)) {
        for (const Output& output : outputs) {
            if (output.kind == OutputKind::raw) raw_ = true;
            if (output.kind == OutputKind::frames) {
                RunRecord own = record;
                own.pattern = output.pattern;
                files_.push_back(
                    std::make_unique<FrameFiles>(plan, output.path, own, options.overwrite));
            }
            if (output.kind == OutputKind::film) {
                render::makeFolder(output.path.parent_path());
                films_.push_back(
                    {output.path, std::make_unique<render::VideoWriter>(output.path, sourceOf(plan),
                                                                        fitOf(options, talk))});
            }
        }
    }

    /// A film or a stream needs every frame; a folder those that it has not.
    bool wants(int frame) const {
        bool wanted = raw_ || !films_.empty() || poster_.wants(frame);
        for (const auto& files : files_) wanted = wanted || !files->has(frame);
        return wanted;
    }

    void add(const DrawnFrame& frame) {
        for (const auto& files : files_) files->add(frame);
        for (const Film& film : films_) film.writer->add(frame.image);
        if (raw_) writeRaw(frame.image);
        poster_.add(frame);
    }

    void close(bool finished) {
        keepFrames(finished);
        for (const Film& film : films_)
            if (film.writer->frames() > 0) film.writer->close(existing_);
        if (finished) poster_.write();
    }

    /// The folders' records. A film that is not closed leaves nothing.
    void keepFrames(bool finished) {
        for (const auto& files : files_) files->close(finished);
    }

    /// After an error: the folders' records, as far as they can be written.
    void saveRecords() noexcept {
        for (const auto& files : files_) try {
                files->close(false);
            } catch (const std::exception&) {  // the first error is the one to tell
            }
    }

    void tell(const FilmPlan& plan, const FilmOptions& options, const Talk& talk) const {
        for (const auto& files : files_)
            talk.say(fmt::format("wrote {} ... {} ({}{})", printable(files->nameOf(0).string()),
                                 printable(files->nameOf(plan.frames - 1).filename().string()),
                                 plural(plan.frames, "frame"),
                                 files->kept() ? fmt::format(", {} kept", files->kept()) : ""));
        for (const auto& files : files_)
            if (!plan.passes.empty())
                talk.say(fmt::format("wrote {}: {}", printable(files->dataName().string()),
                                     fmt::join(passNamesOf(plan.passes), " ")));
        for (const Film& film : films_)
            talk.say(fmt::format("wrote {} ({})", printable(film.path.string()),
                                 options.maxSize
                                     ? film.writer->summary()
                                     : fmt::format("{}, {:.3g} s", plural(plan.frames, "frame"),
                                                   plan.timeOf(plan.frames))));
        poster_.tell(plan, talk);
    }

    bool hasFilms() const { return !films_.empty(); }
    bool hasFolders() const { return !files_.empty(); }

private:
    std::vector<std::unique_ptr<FrameFiles>> files_;
    std::vector<Film> films_;
    Poster poster_;
    render::Existing existing_;
    bool raw_ = false;
};

RunRecord recordOf(const FilmPlan& plan, const FilmOptions& options, const std::string& renderer) {
    TextHash hash;
    hash.add(hexText(fingerprintOf(plan, options)));
    hash.add(renderer);
    RunRecord record;
    record.fingerprint = hash.value();
    record.version = kVersion;
    record.renderer = renderer;
    record.scene = plan.name;
    record.quality = plan.quality;
    record.theme = plan.panels.front().overlays.theme;
    record.show = plan.scene().look.show;
    record.show.insert(record.show.end(), options.show.begin(), options.show.end());
    record.settings = options.overrides;
    record.command = options.commandLine;
    record.pixels = render::pixelClass(plan.picture.reproducible);
    record.width = plan.layout.width;
    record.height = plan.layout.height;
    record.samples = plan.picture.samples;
    record.fps = plan.fps;
    record.hz = plan.scene().hz;
    record.passes = passNamesOf(plan.passes);
    return record;
}

[[noreturn]] void stopInterrupted(const Writers& writers, const FilmOptions& options,
                                  const std::string& what) {
    const char* next = writers.hasFolders() ? "to go on" : "to run it again";
    throw Stop(Exit::interrupted, fmt::format("{}{}; {}: {}", what,
                                              writers.hasFilms() ? ", no film is written" : "",
                                              next, options.commandLine));
}

/// Frame by frame, until the last one or a signal.
void drawAll(FrameSource& source, Writers& writers, const FilmOptions& options, const Talk& talk,
             Progress& progress) {
    DrawnFrame frame;
    while (source.next(frame)) {
        writers.add(frame);
        talk.json(fmt::format(R"({{"event":"frame","frame":{},"state":"{}"}})", frame.frame,
                              hexText(frame.stateHash)));
        progress.advance();
        if (!interrupted()) continue;
        progress.finish();
        writers.keepFrames(false);
        stopInterrupted(writers, options, fmt::format("interrupted after frame {}", frame.frame));
    }
}

std::vector<bool> wantedFrames(const Writers& writers, int frames) {
    std::vector<bool> wanted(static_cast<std::size_t>(frames));
    for (int frame = 0; frame < frames; ++frame) wanted[frame] = writers.wants(frame);
    return wanted;
}

void tellNext(const Writers& writers, const FilmOptions& options, const Talk& talk) {
    if (writers.hasFilms())
        talk.say(fmt::format("next: impulse sim {} --hash", printable(shellWord(options.scene()))));
    else
        talk.say(fmt::format("next: impulse render {} -o film.mp4",
                             printable(shellWord(options.scene()))));
}

void tellPlan(const FilmNeeds& needs, const FilmPlan& plan, const std::vector<Output>& outputs,
              const Talk& talk) {
    talk.json(needsJson(needs, plan));
    talk.say(needsText(needs, plan, outputs));
}

}  // namespace

void checkFilmPlan(const FilmPlan& plan, const FilmOptions& options) {
    const std::vector<Output> outputs = outputsOf(plan, options);
    checkOutputs(outputs, plan, options.overwrite);
    checkNeeds(needsOf(plan, workerCount(options.jobs, plan.frames), outputs), plan);
}

void makeFilm(const FilmPlan& plan, const FilmOptions& options) {
    checkFilmPlan(plan, options);
    const std::vector<Output> outputs = outputsOf(plan, options);
    Poster poster(plan, options);
    const bool raw = has(outputs, OutputKind::raw);
    const bool moving = raw || has(outputs, OutputKind::film);
    const Talk talk(options, raw);
    const int workers = workerCount(options.jobs, plan.frames);
    if (options.dryRun) return tellPlan(needsOf(plan, workers, outputs), plan, outputs, talk);
    watchSignals();
    FrameSource source(plan, workers, has(outputs, OutputKind::frames), moving);
    RunRecord record = recordOf(plan, options, source.renderer());
    if (has(outputs, OutputKind::film)) record.ffmpeg = render::ffmpegVersion();
    Writers writers(plan, outputs, record, std::move(poster), options, talk);
    const std::vector<bool> wanted = wantedFrames(writers, plan.frames);
    const int missing = static_cast<int>(std::count(wanted.begin(), wanted.end(), true));
    talk.json(fmt::format(R"({{"event":"start","scene":{},"frames":{},"kept":{},"fps":{}}})",
                          jsonString(plan.name), plan.frames, plan.frames - missing, plan.fps));
    source.order(wanted);
    Progress progress(options, plan.frames, plan.frames - missing);
    try {
        drawAll(source, writers, options, talk, progress);
        progress.finish();
        writers.close(true);
    } catch (const Stop& stop) {
        progress.finish();
        if (stop.code() == Exit::diverged) writers.close(false);  // the last good frame is kept
        throw;
    } catch (const render::Cancelled& cancelled) {
        stopInterrupted(writers, options, cancelled.what());
    } catch (...) {
        progress.finish();
        writers.saveRecords();
        throw;
    }
    writers.tell(plan, options, talk);
    talk.json(fmt::format(R"({{"event":"done","frames":{}}})", plan.frames));
    tellNext(writers, options, talk);
}

}  // namespace demos
