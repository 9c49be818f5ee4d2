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

void DraftFiles::look(const DraftPlaces& places) {
    std::error_code ignored;
    if (places.films) {
        if (!fs::exists(places.film(), ignored)) sums.clear();
        return;
    }
    for (std::size_t frame = 0; frame < sums.size(); ++frame)
        if (!fs::exists(places.frame(static_cast<int>(frame)), ignored)) sums[frame] = 0;
}

DraftFilm::DraftFilm(const DraftPlaces& places, const FilmPlan& plan, const FrameStore& store,
                     DraftFiles& files)
    : places_(places), plan_(plan), store_(store), files_(files) {}

/// Starts the film with its first `frames` frames.
void DraftFilm::open(int frames) {
    const render::VideoSource source{plan_.layout.width, plan_.layout.height, plan_.fps, false};
    writer_ = std::make_unique<render::VideoWriter>(places_.film(), source);
    for (int frame = 0; frame < frames; ++frame) writer_->add(store_.get(frame));
}

void DraftFilm::add(int frame, const render::Image* image, std::uint64_t sum) {
    const auto place = static_cast<std::size_t>(frame);
    const bool differs = place >= files_.sums.size() || files_.sums[place] != sum;
    sums_.push_back(sum);
    if (!places_.films) {
        if (differs) addFile(frame, image, sum);
        return;
    }
    if (differs && !writer_) open(frame);
    if (writer_) writer_->add(image ? *image : store_.get(frame));
}

void DraftFilm::addFile(int frame, const render::Image* image, std::uint64_t sum) {
    const auto place = static_cast<std::size_t>(frame);
    render::makeFolder(places_.frame(frame).parent_path());
    files_.sums.resize(std::max(files_.sums.size(), place + 1));
    files_.untold = true;
    render::writeFrameFile(places_.frame(frame),
                                render::encodePng(image ? *image : store_.get(frame)));
    files_.sums[place] = sum;
}

void DraftFilm::close(int frames) {
    if (!places_.films) return closeFiles(frames);
    if (!writer_ && sums_ != files_.sums) open(frames);
    if (!writer_) return;
    writer_->close();
    files_.sums = sums_;
    files_.untold = true;
}

/// Removes frames past the end, left by any draft or session: they would seem to be this film's.
void DraftFilm::closeFiles(int frames) {
    std::error_code ignored;
    std::vector<fs::path> outdated;
    for (const fs::directory_entry& entry :
         fs::directory_iterator(places_.frame(0).parent_path(), ignored)) {
        const std::string name = entry.path().filename().string();
        const bool isFrame = name.starts_with("frame_") && name.ends_with(".png") &&
                             name.size() == places_.frame(0).filename().string().size();
        if (isFrame && name >= places_.frame(frames).filename().string())
            outdated.push_back(entry.path());
    }
    for (const fs::path& frame : outdated) files_.untold |= fs::remove(frame, ignored);
    files_.untold |= files_.sums.size() != sums_.size() || !fs::exists(places_.strip(), ignored);
    files_.sums.resize(sums_.size());
    if (files_.untold) writeStrip(frames);
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
