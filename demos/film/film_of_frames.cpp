#include "demos/film/film_of_frames.h"

#include <fmt/format.h>

#include <cstdint>

#include "demos/film/outputs.h"
#include "demos/film/parts.h"
#include "demos/processes/signals.h"
#include "demos/text/complaints.h"
#include "demos/text/file_content.h"
#include "demos/text/stop.h"
#include "render/encode/png_read.h"
#include "render/encode/video.h"

namespace demos {
namespace {

constexpr std::int64_t kMostFramePixels = 134'217'728;  // of a frame: read, it takes 1 GB

render::VideoSource sourceOf(const RunRecord& record) {
    render::VideoSource source{record.width, record.height, record.fps, record.theme == "transparent"};
    source.chapters = record.chapters;
    return source;
}

render::Image frameOf(const FramesToFilm& job, int frame) try {
    return render::decodePng(contentOf(frameFile(job.record, job.folder, frame)), job.record.width,
                             job.record.height);
} catch (const render::Error& error) {
    throw render::Error(fmt::format("frame {}: {}", frame, error.what()));
}

}  // namespace

void checkFramesToFilm(const FramesToFilm& job) {
    if (!render::isVideoName(job.film))
        refuse(fmt::format("--output '{}': must end in .mp4, .webm, .gif, .webp or .apng",
                           printable(job.film.string())));
    if (job.record.width < 1 || job.record.height < 1 || job.record.fps < 1)
        throw render::Error(fmt::format("'{}': the record of its frames has no size or rate",
                                        printable(job.folder.string())));
    if (std::int64_t{job.record.width} * job.record.height > kMostFramePixels)
        throw render::Error(fmt::format("'{}': its frames have {}x{} pixels; a film should have at most {} in all",
                                        printable(job.folder.string()), job.record.width, job.record.height,
                                        kMostFramePixels));
    checkFilm(job.film, sourceOf(job.record));
    checkPlace(job.film, job.existing == render::Existing::replaced);
}

std::string encodeFrames(const FramesToFilm& job, const render::Fit& fit, const std::function<void()>& advance) try {
    render::makeFolder(job.film.parent_path());
    render::VideoWriter writer(job.film, sourceOf(job.record), fit);
    const int frames = static_cast<int>(job.record.frames.size());
    for (int frame = 0; frame < frames; ++frame) {
        if (interrupted()) throw Stop(Exit::interrupted, "interrupted, no film was written");
        writer.add(frameOf(job, frame));
        advance();
    }
    writer.close(job.existing);
    return fit.largestFile != 0 ? writer.summary() : "";
} catch (const render::Cancelled&) {
    throw Stop(Exit::interrupted, "interrupted, no film was written");
}

}  // namespace demos
