#include "demos/watch/draft.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "demos/film/composite.h"
#include "demos/film/framing.h"
#include "demos/film/outputs.h"
#include "demos/film/poster.h"
#include "demos/snapshot/player.h"
#include "demos/text/stop.h"
#include "demos/text/text_hash.h"
#include "demos/watch/frame_hash.h"
#include "render/encode/file.h"
#include "render/encode/png.h"

namespace demos {
namespace {

/// What determines a picture besides its frame.
std::uint64_t sumOf(const FilmPlan& plan) {
    TextHash hash;
    for (const int number : {plan.layout.width, plan.layout.height, plan.picture.width,
                             plan.picture.height, plan.picture.samples})
        hash.add(std::to_string(number));
    hash.add(plan.strip.pixels);
    return hash.value();
}

void note(int frame, std::vector<FrameSpan>& spans) {
    if (spans.empty() || spans.back().last + 1 < frame) spans.push_back({frame, frame});
    spans.back().last = frame;
}

}  // namespace

/// One simulation of the scene.
class DraftMaker::Run {
public:
    explicit Run(const FilmPlan& plan)
        : plan_(plan),
          player_(plan.scene(), plan.panels.front().overlays),
          checker_(player_.stage()),
          planSum_(sumOf(plan)) {
        look();
    }

    /// False: a step failed.
    bool step(int count) {
        try {
            for (int i = 0; i < count; ++i) {
                player_.step();
                look();
            }
        } catch (const Stop& stop) {
            if (stop.code() != Exit::diverged) throw;
            failure_ = stop.what();
        }
        return failure_.empty();
    }

    render::Frame frame(int frame) const {
        render::Frame shown = player_.frame(plan_.timeOf(frame));
        fitCamera(plan_.picture.width, plan_.picture.height, shown);
        return shown;
    }
    /// A strip's cursor depends on the frame.
    std::uint64_t sumOfPicture(int frame, const render::Frame& shown) {
        TextHash hash;
        hash.add(std::to_string(planSum_));
        hash.add(std::to_string(hasher_.of(shown)));
        if (!plan_.strip.pixels.empty()) hash.add(std::to_string(frame));
        return hash.value();
    }
    const FilmPlan& plan() const { return plan_; }
    const std::vector<std::uint64_t>& states() const { return states_; }
    bool failed() const { return !failure_.empty(); }
    /// Why a step failed, or an incident; empty: neither.
    std::string trouble() const { return failed() ? failure_ : player_.incident(); }

    /// The failed expectations; `cut`: the run was cut short, so only those that were measured.
    std::vector<ExpectationResult> failures(bool cut) const {
        std::vector<ExpectationResult> results = checker_.results();
        std::erase_if(results, [cut](const ExpectationResult& result) {
            return result.passed || (cut && !std::isfinite(result.value));
        });
        return results;
    }

private:
    void look() {
        checker_.look(player_.stage());
        states_.push_back(player_.stage().world.hash());
    }

    const FilmPlan& plan_;
    Player player_;
    ExpectationChecker checker_;
    FrameHasher hasher_;
    std::uint64_t planSum_;
    std::vector<std::uint64_t> states_;
    std::string failure_;
};

void DraftMaker::prepare(const FilmPlan& plan) {
    render::makeFolder(places_.folder);
    files_.look(places_);
    if (!store_ || store_->width() != plan.layout.width || store_->height() != plan.layout.height) {
        store_ =
            std::make_unique<FrameStore>(places_.film(), plan.layout.width, plan.layout.height);
        stored_.clear();
    }
    if (!renderer_ || panel_.width != plan.picture.width || panel_.height != plan.picture.height) {
        renderer_.reset();
        renderer_ = std::make_unique<render::Renderer>(plan.picture);
        panel_ = {plan.picture.width, plan.picture.height};
    }
}

std::optional<render::Image> DraftMaker::drawn(int frame, const render::Frame& shown,
                                               std::uint64_t sum, const FilmPlan& plan) {
    const auto place = static_cast<std::size_t>(frame);
    if (place < stored_.size() && stored_[place] == sum) return std::nullopt;
    render::Image image = withStrip(renderer_->draw(shown), plan, plan.timeOf(frame));
    stored_.resize(std::max(stored_.size(), place + 1));
    stored_[place] = 0;  // while it is half written
    store_->put(frame, image);
    stored_[place] = sum;
    return image;
}

void DraftMaker::addFrame(int frame, Run& run, DraftFilm& film, Draft& draft) {
    const render::Frame shown = run.frame(frame);
    const std::uint64_t sum = run.sumOfPicture(frame, shown);
    const std::optional<render::Image> image = drawn(frame, shown, sum, run.plan());
    draft.drawn += image ? 1 : 0;
    const auto place = static_cast<std::size_t>(frame);
    if (place >= told_.size() || told_[place] != sum) note(frame, draft.changed);
    film.add(frame, image ? &*image : nullptr, sum);
    ++draft.frames;
}

Draft DraftMaker::make(const FilmPlan& plan, const Options& options,
                       const std::function<bool()>& giveUp) {
    prepare(plan);
    Draft draft;
    draft.framesBefore = static_cast<int>(told_.size());
    Run run(plan);
    DraftFilm film(places_, plan, *store_, files_);
    for (int frame = 0; frame < plan.frames; ++frame) {
        if (giveUp()) return draft;
        if (frame > 0 && !run.step(plan.stepOf(frame) - plan.stepOf(frame - 1))) break;
        addFrame(frame, run, film, draft);
    }
    const long steps = std::max(std::lround(plan.scene().seconds * plan.scene().hz), 1L);
    if (!run.failed())
        run.step(static_cast<int>(steps - static_cast<long>(run.states().size()) + 1));
    finish(run, film, options, draft);
    return draft;
}

/// Writes the first frame that has changed, or the poster if there was no picture.
void DraftMaker::writePicture(const Run& run, Draft& draft) {
    std::error_code ignored;
    if (draft.framesBefore == 0 || !std::filesystem::exists(places_.picture(), ignored))
        draft.pictured = std::min(posterFrame(run.plan()), draft.frames - 1);
    else if (!draft.changed.empty())
        draft.pictured = draft.changed.front().first;
    if (draft.pictured >= 0)
        render::writeFileAtomically(places_.picture(),
                                    render::encodePng(store_->get(draft.pictured)));
}

void DraftMaker::finish(Run& run, DraftFilm& film, const Options& options, Draft& draft) {
    film.close(draft.frames);
    writePicture(run, draft);
    const std::vector<std::uint64_t>& states = run.states();
    const auto [here, there] =
        std::mismatch(states.begin(), states.end(), states_.begin(), states_.end());
    if (draft.framesBefore > 0 && here != states.end() && there != states_.end())
        draft.firstStep = here - states.begin();
    draft.failed = run.failures(options.seconds.has_value());
    draft.trouble = run.trouble();
    told_.assign(stored_.begin(), stored_.begin() + draft.frames);
    states_ = states;
    draft.written = std::exchange(files_.untold, false);
    draft.whole = true;
}

}  // namespace demos
