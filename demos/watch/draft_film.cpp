#include "demos/watch/draft_film.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/film/film_strip.h"
#include "demos/film/outputs.h"
#include "render/encode/file.h"
#include "render/encode/png.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

constexpr int kMoments = 6;  // of the strip

}  // namespace

fs::path DraftPlaces::frame(int frame) const {
    return folder / "draft" / fmt::format("frame_{:06}.png", frame);
}

DraftFilm::DraftFilm(const DraftPlaces& places, const FilmPlan& plan, const FrameStore& store,
                     int framesBefore)
    : places_(places), plan_(plan), store_(store), framesBefore_(framesBefore) {}

/// With all frames before this one.
void DraftFilm::open(int frames) {
    open_ = true;
    if (!places_.films) return makeFolder(places_.frame(0).parent_path());
    const render::VideoSource source{plan_.layout.width, plan_.layout.height, plan_.fps, false};
    writer_ = std::make_unique<render::VideoWriter>(places_.film(), source);
    for (int frame = 0; frame < frames; ++frame) writer_->add(store_.get(frame));
}

void DraftFilm::add(int frame, const render::Image* image, bool differs) {
    if (differs && !open_) open(frame);
    if (writer_) writer_->add(image ? *image : store_.get(frame));
    if (!places_.films && differs)
        render::writeFileAtomically(places_.frame(frame),
                                    render::encodePng(image ? *image : store_.get(frame)));
}

bool DraftFilm::close(int frames) {
    std::error_code ignored;
    if (!open_ && (frames < framesBefore_ || !fs::exists(places_.toOpen(), ignored))) open(frames);
    if (!open_) return false;
    if (writer_) writer_->close();
    if (places_.films) return true;
    for (int frame = frames; frame < framesBefore_; ++frame)
        fs::remove(places_.frame(frame), ignored);
    writeStrip(frames);
    return true;
}

void DraftFilm::writeStrip(int frames) const {
    const int count = std::min(kMoments, frames);
    const StripLayout layout = stripLayout(count, 0, {store_.width(), store_.height()}, true);
    const Inks inks = inksOf(plan_.panels.front().overlays.theme);
    render::Image paper = stripPaper(layout, inks.ground);
    for (int i = 0; i < count; ++i) {
        const int frame = count > 1 ? i * (frames - 1) / (count - 1) : 0;
        placeMoment(layout, i, store_.get(frame), fmt::format("t = {:.2f} s", plan_.timeOf(frame)),
                    inks.ink, paper);
    }
    render::writeFileAtomically(places_.strip(), render::encodePng(paper));
}

}  // namespace demos
