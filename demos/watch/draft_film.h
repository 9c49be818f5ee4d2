/// The files of a draft: draft.mp4, or PNG frames and a strip if there is no ffmpeg.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "demos/film/film_plan.h"
#include "demos/watch/frame_store.h"
#include "render/encode/video.h"

namespace demos {

/// The paths of a scene's drafts.
struct DraftPlaces {
    std::filesystem::path folder;
    bool films = true;  // there is an ffmpeg

    std::filesystem::path film() const { return folder / "draft.mp4"; }
    std::filesystem::path picture() const { return folder / "draft.png"; }
    std::filesystem::path strip() const { return folder / "draft_strip.png"; }
    std::filesystem::path frame(int frame) const;
    /// How the names of its files in `folder` begin, including temporary files.
    static std::vector<std::string> names() {
        return {"draft.mp4", "draft.png", "draft_strip.png", "draft.tmp"};
    }
    /// The file for the user to open.
    std::filesystem::path toOpen() const { return films ? film() : strip(); }
};

/// What the files show. A draft that was given up may have changed them without a report.
struct DraftFiles {
    std::vector<std::uint64_t> sums;  // by frame, FrameHasher's; 0: not known
    bool untold = false;              // written since the last whole draft was reported

    /// Forgets files that no longer exist.
    void look(const DraftPlaces& places);
};

/// Takes frames in order. Writes nothing before the first frame that differs from what the files
/// show.
class DraftFilm {
public:
    /// `store` must have every frame before it is added; `files` is updated with what is written.
    DraftFilm(const DraftPlaces& places, const FilmPlan& plan, const FrameStore& store,
              DraftFiles& files);
    void add(int frame, const render::Image* image, std::uint64_t sum);
    /// `frames`: in all. A draft that differs only in length is written now.
    void close(int frames);

private:
    void open(int frames);
    void addFile(int frame, const render::Image* image, std::uint64_t sum);
    void closeFiles(int frames);
    void writeStrip(int frames) const;

    const DraftPlaces& places_;
    const FilmPlan& plan_;
    const FrameStore& store_;
    DraftFiles& files_;
    std::vector<std::uint64_t> sums_;  // of the frames so far
    std::unique_ptr<render::VideoWriter> writer_;
};

}  // namespace demos
