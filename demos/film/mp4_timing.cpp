#include "demos/film/mp4_timing.h"

#include <sys/resource.h>

#include <filesystem>
#include <memory>
#include <vector>

#include "demos/film/frame_source.h"
#include "demos/measures/clock.h"
#include "demos/processes/signals.h"
#include "demos/text/stop.h"
#include "render/encode/video.h"

namespace demos {
namespace {

/// s of processor time of the children that have ended.
double endedChildrenTime() {
    rusage used{};
    getrusage(RUSAGE_CHILDREN, &used);
    const auto secondsOf = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return secondsOf(used.ru_utime) + secondsOf(used.ru_stime);
}

}  // namespace

bool canBeMp4(const FilmPlan& plan) {
    const render::VideoFormat& mp4 = *render::videoFormatOf("film.mp4");
    return render::haveFfmpeg() && plan.layout.width % 2 == 0 && plan.layout.height % 2 == 0 &&
           plan.fps <= mp4.largestFps && !plan.alpha();
}

Mp4Timing timeMp4(const FilmPlan& plan, int workers, const std::filesystem::path& file) {
    const double start = seconds(CLOCK_MONOTONIC), own = processorTime();
    const double before = endedChildrenTime();
    auto source = std::make_unique<FrameSource>(plan, workers, false, true);
    render::VideoWriter film(file, {plan.layout.width, plan.layout.height, plan.fps, false});
    source->order(std::vector<bool>(static_cast<std::size_t>(plan.frames), true));
    for (DrawnFrame frame; source->next(frame);) {
        film.add(frame.image);
        if (interrupted()) throw Stop(Exit::interrupted, "interrupted");
    }
    source.reset();  // waits for the workers: their time counts from now on
    const double drawn = endedChildrenTime();
    film.close();
    const double perFrame = 1e3 / plan.frames;
    Mp4Timing timing;
    timing.workers = perFrame * (drawn - before);
    timing.encoder = perFrame * (endedChildrenTime() - drawn);
    timing.program = perFrame * (processorTime() - own);
    timing.framesASecond = plan.frames / (seconds(CLOCK_MONOTONIC) - start);
    timing.bytes = static_cast<double>(std::filesystem::file_size(file)) / plan.frames;
    return timing;
}

}  // namespace demos
