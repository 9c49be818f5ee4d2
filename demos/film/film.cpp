#include "demos/film/film.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <utility>

#include "demos/film/caption_track.h"
#include "demos/film/chapters.h"
#include "demos/film/composite.h"
#include "demos/film/film_needs.h"
#include "demos/film/frame_files.h"
#include "demos/film/outputs.h"
#include "demos/film/parts.h"
#include "demos/film/poster.h"
#include "demos/film/progress.h"
#include "demos/film/resume_states.h"
#include "demos/film/slow_motion.h"
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
    std::optional<RunRecord> part;  // for a --shard
};

/// `chosen`: the frames of the film. A part has no chapters: they are the whole film's.
render::VideoSource sourceOf(const FilmPlan& plan, const std::vector<bool>& chosen, bool part) {
    render::VideoSource source{plan.layout.width, plan.layout.height, plan.fps, plan.alpha()};
    if (!part) source.chapters = chaptersOf(plan, chosen);
    return source;
}

render::Fit fitOf(const FilmOptions& options, const Talk& talk) {
    return {options.maxSize.value_or(0), interrupted,
            [&talk](const std::string& line) { talk.mention(line); }};
}

int lastOf(const std::vector<bool>& chosen) {
    return static_cast<int>(chosen.rend() - std::find(chosen.rbegin(), chosen.rend(), true)) - 1;
}

/// All that one run writes.
class Writers {
public:
    Writers(const FilmPlan& plan, const std::vector<Output>& outputs,
            const std::vector<bool>& chosen, const RunRecord& record, Poster poster,
            CaptionTrack captions, const FilmOptions& options, const Talk& talk)
        : poster_(std::move(poster)),
          captions_(std::move(captions)),
          existing_(existingFiles(options.overwrite)) {
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
                films_.push_back({output.path,
                                  std::make_unique<render::VideoWriter>(
                                      output.path, sourceOf(plan, chosen, output.part),
                                      fitOf(options, talk)),
                                  {}});
                if (output.part) films_.back().part = record;
            }
        }
    }

    /// A film or a stream needs every frame; a folder those that it lacks.
    bool wants(int frame) const {
        bool wanted = raw_ || !films_.empty() || poster_.wants(frame);
        for (const auto& files : files_) wanted = wanted || !files->has(frame);
        return wanted;
    }

    void add(const DrawnFrame& frame) {
        incident_ = frame.incident;
        notes_ = frame.notes;
        for (const auto& files : files_) files->add(frame);
        for (Film& film : films_) {
            film.writer->add(frame.image);
            if (!film.part) continue;
            film.part->frames[frame.frame] = {true, frame.stateHash, 0, 0};
            film.part->addIncident(frame.incident, frame.frame);
        }
        if (raw_) writeRaw(frame.image);
        poster_.add(frame);
    }

    void close(bool finished) {
        keepFrames(finished);
        for (Film& film : films_) {
            if (film.writer->frames() == 0 || (film.part && !finished)) continue;
            film.writer->close(film.part ? render::Existing::replaced : existing_);
            if (film.part) writePartRecord(film.path, *film.part);
        }
        if (!finished) return;
        poster_.write();
        captions_.write();
    }

    /// Writes the folders' records. A film that is not closed leaves no file.
    void keepFrames(bool finished) {
        for (const auto& files : files_) files->close(finished);
    }

    /// After an error: the folders' records, as far as they can be written.
    void saveRecords() noexcept {
        for (const auto& files : files_) try {
                files->close(false);
            } catch (const std::exception&) {  // the first error is reported
            }
    }

    void tell(const FilmPlan& plan, const std::vector<bool>& chosen, const FilmOptions& options,
              const Talk& talk) const {
        const int count = static_cast<int>(std::count(chosen.begin(), chosen.end(), true));
        const int first =
            static_cast<int>(std::find(chosen.begin(), chosen.end(), true) - chosen.begin());
        const int last = lastOf(chosen);
        for (const auto& files : files_)
            talk.say(fmt::format("wrote {} ... {} ({}{})", printable(files->nameOf(first).string()),
                                 printable(files->nameOf(last).filename().string()),
                                 plural(count, "frame"),
                                 files->kept() ? fmt::format(", {} kept", files->kept()) : ""));
        for (const auto& files : files_)
            if (!plan.passes.empty())
                talk.say(fmt::format("wrote {}: {}", printable(files->dataName().string()),
                                     fmt::join(passNamesOf(plan.passes), " ")));
        for (const Film& film : films_)
            talk.say(fmt::format("wrote {} ({})", printable(film.path.string()),
                                 options.maxSize
                                     ? film.writer->summary()
                                     : fmt::format("{}, {:.3g} s",
                                                   plural(film.writer->frames(), "frame"),
                                                   static_cast<double>(film.writer->frames()) / plan.fps)));
        poster_.tell(plan, talk);
        captions_.tell(talk);
        for (std::size_t at = 0; at < notes_.size(); at = notes_.find('\n', at) + 1)
            talk.mention("warning: " + printable(notes_.substr(at, notes_.find('\n', at) - at)));
    }

    /// The simulation's incident up to the last chosen frame, drawn now or kept; "": none.
    std::string incident(const std::vector<bool>& chosen) const {
        std::string longest = incident_;  // counts the most
        for (const auto& files : files_) {
            const std::string line = files->record().incidentUntil(lastOf(chosen));
            if (line.size() > longest.size()) longest = line;
        }
        return longest;
    }

    bool hasFilms() const { return !films_.empty(); }
    bool hasFolders() const { return !files_.empty(); }

private:
    std::vector<std::unique_ptr<FrameFiles>> files_;
    std::vector<Film> films_;
    Poster poster_;
    CaptionTrack captions_;
    render::Existing existing_;
    bool raw_ = false;
    std::string incident_;  // until the last frame that was added
    std::string notes_;     // of the last frame that was added
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
    record.frames.assign(static_cast<std::size_t>(plan.frames), {});
    if (!options.shard) return record;
    record.shard = options.shard->name();
    record.poster = posterFrame(plan);
    record.captions = captionTrackText(plan);
    record.chapters = chaptersOf(plan, std::vector<bool>(record.frames.size(), true));
    return record;
}

[[noreturn]] void stopInterrupted(const Writers& writers, const FilmOptions& options,
                                  const std::string& what) {
    const char* next = writers.hasFolders() ? "to resume" : "to run it again";
    throw Stop(Exit::interrupted, fmt::format("{}{}; {}: {}", what,
                                              writers.hasFilms() ? ", no film was written" : "",
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

/// Draws what is missing and ends all outputs: whole, or with what was drawn where the run has to end.
void writeFilm(FrameSource& source, Writers& writers, const FilmPlan& plan, const FilmOptions& options,
               const Talk& talk, Progress& progress) {
    try {
        drawAll(source, writers, options, talk, progress);
        progress.finish();
        writers.close(true);
        clearStates(plan);
    } catch (const Stop& stop) {
        progress.finish();
        if (stop.code() == Exit::diverged) writers.close(false), clearStates(plan);  // the last good frame is kept
        throw;
    } catch (const render::Cancelled& cancelled) {
        stopInterrupted(writers, options, cancelled.what());
    } catch (...) {
        progress.finish();
        writers.saveRecords();
        throw;
    }
}

/// The chosen frames that an output still needs.
std::vector<bool> wantedFrames(const Writers& writers, const std::vector<bool>& chosen) {
    std::vector<bool> wanted = chosen;
    for (std::size_t frame = 0; frame < wanted.size(); ++frame)
        wanted[frame] = wanted[frame] && writers.wants(static_cast<int>(frame));
    return wanted;
}

int countOf(const std::vector<bool>& frames) {
    return static_cast<int>(std::count(frames.begin(), frames.end(), true));
}

/// Whether the part of a film is complete. Another run's part is replaced with --overwrite only.
bool isDone(const std::vector<Output>& outputs, const RunRecord& record, const FilmOptions& options,
            const Talk& talk) {
    const Output& output = outputs.front();
    if (!output.part) return false;
    const auto [state, incident, pixels] = stateOfPart(output.path, record);
    if (state == PartState::another && !options.overwrite)
        refuseToReplace(output.path,
                        "is a part of another run (other settings, scene or program); --overwrite "
                        "replaces it");
    const bool replaced = options.overwrite && pixels != record.pixels;
    if (state != PartState::done || replaced) return false;
    talk.say(fmt::format("{} is complete already", printable(output.path.string())));
    talk.json(R"({"event":"done","frames":0})");
    if (!incident.empty()) throw Stop(Exit::diverged, incident);
    return true;
}

/// Jerky slow motion, and where the simulation of the first frame starts, if states were named.
void tellStart(const FilmPlan& plan, const std::vector<bool>& wanted, const Talk& talk) {
    if (!plan.slowSteps.empty())
        for (const std::string& line : jerkySections(plan.scene(), plan.fps))
            talk.mention("note: " + line);
    const auto first = std::find(wanted.begin(), wanted.end(), true);
    if (plan.states.empty() || first == wanted.end()) return;
    const int frame = static_cast<int>(first - wanted.begin());
    if (const std::optional<ReadState> state = stateBefore(frame, plan))
        talk.say(fmt::format("starts from the state of step {}", state->step));
    else if (plan.states != plan.resume)
        talk.mention(fmt::format("note: no state in '{}' fits before frame {}; the simulation "
                                 "starts from time 0",
                                 printable(plan.states), frame));
}

void tellNext(const Writers& writers, const std::vector<Output>& outputs,
              const FilmOptions& options, const Talk& talk) {
    if (options.shard)
        return talk.say(fmt::format(
            "next, when all {} parts are there: impulse join {}", options.shard->count,
            printable(shellWord((writers.hasFilms() ? outputs.front().path.parent_path()
                                                    : outputs.front().path)
                                    .string()))));
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
    const int chosen = countOf(chosenFrames(options.frames, options.shard, plan.frames));
    checkNeeds(needsOf(plan, workerCount(options.jobs, chosen), outputs), plan);
}

void makeFilm(FilmPlan plan, const FilmOptions& options) {
    checkFilmPlan(plan, options);
    const std::vector<Output> outputs = outputsOf(plan, options);
    Poster poster(plan, options);
    CaptionTrack captions(plan, options);
    const bool raw = has(outputs, OutputKind::raw);
    const bool moving = raw || has(outputs, OutputKind::film);
    const Talk talk(options, raw);
    const std::vector<bool> chosen = chosenFrames(options.frames, options.shard, plan.frames);
    const int frames = countOf(chosen), workers = workerCount(options.jobs, frames);
    if (options.dryRun) return tellPlan(needsOf(plan, workers, outputs), plan, outputs, talk);
    watchSignals();
    planToResume(outputs, options, plan);
    const bool fitted = fitForLong(plan, options);
    FrameSource source(plan, workers, has(outputs, OutputKind::frames), moving);
    RunRecord record = recordOf(plan, options, source.renderer());
    const bool stored = options.shard || has(outputs, OutputKind::frames);  // asking takes ffmpeg a while
    if (stored && has(outputs, OutputKind::film)) record.ffmpeg = render::ffmpegVersion();
    if (isDone(outputs, record, options, talk)) return;
    Writers writers(plan, outputs, chosen, record, std::move(poster), std::move(captions), options,
                    talk);
    if (options.overwrite) clearStates(plan);
    if (fitted) keepCamera(plan);
    const std::vector<bool> wanted = wantedFrames(writers, chosen);
    const int missing = countOf(wanted);
    tellStart(plan, wanted, talk);
    talk.json(fmt::format(R"({{"event":"start","scene":{},"frames":{},"kept":{},"fps":{}}})",
                          jsonString(plan.name), frames, frames - missing, plan.fps));
    source.order(wanted);
    Progress progress(options, frames, frames - missing);
    writeFilm(source, writers, plan, options, talk, progress);
    writers.tell(plan, chosen, options, talk);
    talk.json(fmt::format(R"({{"event":"done","frames":{}}})", frames));
    tellNext(writers, outputs, options, talk);
    const std::string incident = writers.incident(chosen);
    // Several panels say so themselves.
    if (!incident.empty() && plan.panels.size() == 1) throw Stop(Exit::diverged, incident);
}

}  // namespace demos
