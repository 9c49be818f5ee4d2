/// What a draft is written to: draft.mp4, or PNG frames and a strip where there is no ffmpeg.
#pragma once
#include <filesystem>
#include <memory>

#include "demos/film/film_plan.h"
#include "demos/watch/frame_store.h"
#include "render/encode/video.h"

namespace demos {

/// Where the drafts of a scene go.
struct DraftPlaces {
    std::filesystem::path folder;
    bool films = true;  // there is an ffmpeg

    std::filesystem::path film() const { return folder / "draft.mp4"; }
    std::filesystem::path picture() const { return folder / "draft.png"; }
    std::filesystem::path strip() const { return folder / "draft_strip.png"; }
    std::filesystem::path frame(int frame) const;
    /// What to open.
    std::filesystem::path toOpen() const { return films ? film() : strip(); }
};

/// Frames come one after the other; nothing is written before the first one that differs.
class DraftFilm {
public:
    /// `store` has every frame before it is added; `framesBefore`: of the draft that is replaced.
    DraftFilm(const DraftPlaces& places, const FilmPlan& plan, const FrameStore& store,
              int framesBefore);
    void add(int frame, const render::Image* image, bool differs);
    /// Of so many frames: a draft that differs by its length alone is written now. True: one was.
    bool close(int frames);

private:
    void open(int frames);
    void writeStrip(int frames) const;

    const DraftPlaces& places_;
    const FilmPlan& plan_;
    const FrameStore& store_;
    int framesBefore_;
    bool open_ = false;
    std::unique_ptr<render::VideoWriter> writer_;
};

}  // namespace demos
