#include "demos/film/film_timing.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <limits>
#include <numeric>
#include <vector>

#include "demos/film/composite.h"
#include "demos/film/frame_source.h"
#include "demos/measures/clock.h"
#include "demos/processes/own_process.h"
#include "demos/processes/signals.h"
#include "demos/text/stop.h"
#include "render/encode/file.h"
#include "render/encode/png.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

class TemporaryFolder {
public:
    TemporaryFolder()
        : path_(fs::temp_directory_path() / fmt::format("impulse-bench-{}", getpid())) {
        fs::create_directory(path_);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    fs::path file(int frame) const { return path_ / fmt::format("frame_{:06}.png", frame); }
    fs::path film() const { return path_ / "film.mp4"; }

private:
    fs::path path_;
};

void checkInterrupted() {
    if (interrupted()) throw Stop(Exit::interrupted, "interrupted");
}

/// 1 if there are none: a film of one frame is drawn as a whole.
double meanOf(const std::vector<double>& shares) {
    if (shares.empty()) return 1.0;
    return std::accumulate(shares.begin(), shares.end(), 0.0) / static_cast<double>(shares.size());
}

double framesASecond(const FilmPlan& plan, int workers, const TemporaryFolder& folder) {
    FrameSource source(plan, workers, true, false);
    const double start = seconds(CLOCK_MONOTONIC);
    source.order(std::vector<bool>(static_cast<std::size_t>(plan.frames), true));
    for (DrawnFrame frame; source.next(frame);) {
        render::writeFrameFile(folder.file(frame.frame), frame.png);
        checkInterrupted();
    }
    return plan.frames / (seconds(CLOCK_MONOTONIC) - start);
}

/// Adds up the processor time of one frame by stages.
class StageClock {
public:
    void begin(std::size_t stage) {
        const double now = processorTime();
        if (stage_ < kFilmStages.size()) frame_[stage_] += 1e3 * (now - since_);
        stage_ = stage;
        since_ = processorTime();
    }
    void endFrame(bool counts) {
        begin(kFilmStages.size());
        for (std::size_t i = 0; i < frame_.size() && counts; ++i) all_[i].push_back(frame_[i]);
        frame_.fill(0.0);
    }
    void medians(FilmTiming& timing) const {
        for (std::size_t i = 0; i < all_.size(); ++i) timing.ms[i] = medianOf(all_[i]);
    }

private:
    std::size_t stage_ = kFilmStages.size();  // none
    double since_ = 0.0;
    std::array<double, kFilmStages.size()> frame_{};
    std::array<std::vector<double>, kFilmStages.size()> all_;
};

/// `most`: s of processor time, after which it ends with the fifth frame or a later one.
void timeStages(const FilmPlan& plan, const TemporaryFolder& folder, double most,
                FilmTiming& timing) {
    constexpr std::size_t kDrawing = 1, kEncode = 8, kWrite = 9;  // places in kFilmStages
    const double begun = processorTime();
    render::RendererSettings settings = plan.picture;
    settings.threads = 0;
    render::Renderer renderer(settings);
    Composite composite(plan);
    StageClock clock;
    std::vector<double> bytes, drawn;
    renderer.observe([&](render::Stage stage) {
        const bool done = stage == render::Stage::done;
        clock.begin(done ? kEncode : kDrawing + static_cast<std::size_t>(stage));
        if (done && !bytes.empty()) drawn.push_back(renderer.drawnShare());
    });
    const auto isEnough = [&](int frame) { return frame >= 5 && processorTime() - begun > most; };
    for (int frame = 0; frame < timing.frames && !isEnough(frame); ++frame) {
        clock.begin(0);
        if (frame > 0) composite.advance(true);
        const render::Image image = composite.draw(frame, renderer);
        clock.begin(kEncode);
        const std::vector<std::uint8_t> png = render::encodePng(image);
        clock.begin(kWrite);
        render::writeFrameFile(folder.file(frame), png);
        clock.endFrame(frame > 0);  // the first one compiles shaders
        if (frame == 0) timing.start = processorTime() - begun;
        bytes.push_back(static_cast<double>(png.size()));
        checkInterrupted();
    }
    clock.medians(timing);
    for (const double ms : timing.ms) timing.start -= 1e-3 * ms;  // the first frame itself
    timing.start = std::max(timing.start, 0.0);
    timing.frames = static_cast<int>(bytes.size());
    timing.pngBytes = medianOf(bytes);
    timing.drawn = meanOf(drawn);
    timing.incident = composite.incidentAtEnd();
}

/// timeStages() in a process of its own, because the next scene's workers will be forked from this one.
void timeStagesApart(const FilmPlan& plan, const TemporaryFolder& folder, double most, FilmTiming& timing) {
    const std::string found = inOwnProcess("the process that measures", [&] {
        timeStages(plan, folder, most, timing);
        const StageTimes& times = timing;
        return std::string(reinterpret_cast<const char*>(&times), sizeof times) + timing.incident;
    });
    StageTimes& times = timing;
    std::memcpy(&times, found.data(), sizeof times);
    timing.incident = found.substr(sizeof times);
}

}  // namespace

double FilmTiming::drawing() const {
    double sum = 0.0;
    for (std::size_t i = 1; i <= 6; ++i) sum += ms[i];
    return sum;
}

double FilmTiming::goal() const { return 0.88 * workers / (1e-3 * drawing()); }

FilmTiming timeFrames(const FilmPlan& plan, int frames, double seconds) {
    const TemporaryFolder folder;
    FilmTiming timing;
    timing.frames = std::min(frames, plan.frames);
    timeStagesApart(plan, folder, seconds, timing);
    return timing;
}

FilmTiming timeFilm(const FilmPlan& plan, int jobs) {
    const TemporaryFolder folder;
    FilmTiming timing;
    timing.frames = plan.frames;
    timing.workers = workerCount(jobs, plan.frames);
    timing.framesASecond = framesASecond(plan, timing.workers, folder);
    if (canBeMp4(plan)) timing.mp4 = timeMp4(plan, timing.workers, folder.film());
    timeStagesApart(plan, folder, std::numeric_limits<double>::infinity(), timing);
    return timing;
}

}  // namespace demos
