/// Drafts of a scene that is being edited: each draws only what has changed since the last one.
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

/// Inclusive.
struct FrameSpan {
    int first = 0, last = 0;
};

/// The result of a draft.
struct Draft {
    bool whole = false;  // false: given up for a newer save or a signal
    int frames = 0;
    int framesBefore = 0;            // of the last whole one; 0: there was none
    int drawn = 0;                   // the others were unchanged
    std::vector<FrameSpan> changed;  // against the last whole one, rising
    std::optional<long> firstStep;   // with another state than in the last whole one; 0: the start
    bool written = false;            // the film or the frames, since the last whole one
    int pictured = -1;               // the frame of draft.png; -1: it was not written
    std::vector<ExpectationResult> failed;
    std::string trouble;  // an incident (Player::incident), or the step that failed; or empty
};

class DraftMaker {
public:
    /// Drafts always replace older ones.
    explicit DraftMaker(DraftPlaces places) : places_(std::move(places)) {}

    /// Calls `giveUp` before every frame. Throws render::Error; what was drawn is then kept.
    Draft make(const FilmPlan& plan, const Options& options, const std::function<bool()>& giveUp);
    const DraftPlaces& places() const { return places_; }

private:
    class Run;
    void prepare(const FilmPlan& plan);
    /// nullopt if the store has this frame already.
    std::optional<render::Image> drawn(int frame, const render::Frame& shown, std::uint64_t sum,
                                       const FilmPlan& plan);
    void addFrame(int frame, Run& run, DraftFilm& film, Draft& draft);
    void writePicture(const Run& run, Draft& draft);
    void finish(Run& run, DraftFilm& film, const Options& options, Draft& draft);

    DraftPlaces places_;
    std::unique_ptr<FrameStore> store_;
    std::unique_ptr<render::Renderer> renderer_;
    PictureSize panel_;
    std::vector<std::uint64_t> stored_;  // by frame: FrameHasher's sum of the store's picture
    std::vector<std::uint64_t> told_;    // the same, of the last whole draft
    DraftFiles files_;                   // what is on the disk, reported or not
    std::vector<std::uint64_t> states_;  // by step: the last whole draft's world
};

}  // namespace demos
