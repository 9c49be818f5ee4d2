/// Drafts of a scene that is being written: each draws what the one before has not.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "demos/play/expect.h"
#include "demos/watch/draft_film.h"
#include "render/renderer.h"

namespace demos {

/// Both are in it.
struct FrameSpan {
    int first = 0, last = 0;
};

/// What became of a draft.
struct Draft {
    bool whole = false;  // false: given up, for a newer save or a signal
    int frames = 0;
    int framesBefore = 0;            // of the last whole one; 0: there was none
    int drawn = 0;                   // the others were there
    std::vector<FrameSpan> changed;  // against the last whole one, rising
    std::optional<long> firstStep;   // whose state differs from the last whole one's; 0: the start
    bool written = false;            // the film, or the frames, since the last whole one
    int pictured = -1;               // the frame of draft.png; -1: it was not written
    std::vector<ExpectationResult> failed;
    std::string trouble;  // of a run that diverged: its line
};

class DraftMaker {
public:
    /// Drafts are always replaced: they are nobody's work.
    explicit DraftMaker(DraftPlaces places) : places_(std::move(places)) {}

    /// `giveUp` is asked before every frame. Throws render::Error; then what was drawn is kept.
    Draft make(const FilmPlan& plan, const Options& options, const std::function<bool()>& giveUp);
    const DraftPlaces& places() const { return places_; }

private:
    class Run;
    void prepare(const FilmPlan& plan);
    /// Nothing where the store has this frame already.
    std::optional<render::Image> drawn(int frame, const render::Frame& shown, std::uint64_t sum,
                                       const FilmPlan& plan);
    void addFrame(int frame, Run& run, DraftFilm& film, Draft& draft);
    void writePicture(const Run& run, Draft& draft);
    void finish(Run& run, DraftFilm& film, const Options& options, Draft& draft);

    DraftPlaces places_;
    std::unique_ptr<FrameStore> store_;
    std::unique_ptr<render::Renderer> renderer_;
    PictureSize panel_;
    std::vector<std::uint64_t> stored_;  // by frame: FrameHasher's sum of what the store has
    std::vector<std::uint64_t> told_;    // the same, of the last whole draft
    DraftFiles files_;                   // what is on the disk, told or not
    std::vector<std::uint64_t> states_;  // by step: of the last whole draft's world
};

}  // namespace demos
