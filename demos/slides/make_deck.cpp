#include "demos/slides/make_deck.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>

#include "demos/processes/signals.h"
#include "demos/slides/crowding.h"
#include "demos/slides/slide_facts.h"
#include "demos/slides/slide_options.h"
#include "demos/slides/slide_pictures.h"
#include "demos/text/complaints.h"
#include "demos/text/stop.h"
#include "render/encode/ffmpeg.h"

namespace demos {
namespace {

/// A slide with everything that is known before anything is simulated.
struct Act {
    LoadedRuns loaded;
    std::optional<SlidePlan> plan;
    std::optional<SlideFacts> facts;
    MadeSlide made;
    std::string incident;  // of its runs, as far as the slide shows them
};

[[noreturn]] void stopAt(const Slide& slide, const Stop& stop, const DeckMaking& making) {
    const std::string id = printable(slide.id);
    if (stop.code() != Exit::interrupted)
        throw Stop(stop.code(), fmt::format("slide '{}': {}", id, stop.what()));
    throw Stop(Exit::interrupted,
               fmt::format("interrupted at slide '{}'{}", id, againLine(making.options)));
}

/// Adds the slide to the message of what stops the work on it.
template <class Work>
void at(const Slide& slide, const DeckMaking& making, const Work& work) {
    try {
        work();
    } catch (const Stop& stop) {
        stopAt(slide, stop, making);
    } catch (const NumberError& error) {
        stopAt(slide, Stop(Exit::scene, error.what()), making);
    }
}

bool hasFilm(const Deck& deck) {
    return std::any_of(deck.slides.begin(), deck.slides.end(), [](const Slide& slide) {
        return slide.runs.any() && slide.exhibit == Exhibit::film;
    });
}

/// Whether films are made. Adds a note if they are wanted but cannot be made.
bool filmsAreMade(const Deck& deck, const DeckMaking& making, MadeDeck& made) {
    if (!making.films || !hasFilm(deck)) return false;
    if (render::haveFfmpeg()) return true;
    made.diagnostics.push_back(
        "no ffmpeg, so films cannot be made (apt install ffmpeg); each film is replaced by its "
        "poster, everything else is made");
    return false;
}

/// Adds the notes of the scenes, each once.
void addNotes(const LoadedRuns& loaded, std::vector<std::string>& diagnostics) {
    for (const Variant& variant : loaded.variants)
        for (const std::string& note : variant.scene.notes)
            if (std::find(diagnostics.begin(), diagnostics.end(), note) == diagnostics.end())
                diagnostics.push_back(note);
}

class Making {
public:
    Making(const Deck& deck, const DeckMaking& making) : deck_(deck), making_(making) {
        made_.deck = deck;
        moving_ = filmsAreMade(deck, making, made_);
        for (const Slide& slide : deck.slides) at(slide, making, [&] { prepare(slide); });
    }

    MadeDeck make() {
        const Talk talk(making_.options, false);
        for (const std::string& note : made_.diagnostics) talk.mention(note);
        for (Act& act : acts_) at(act.made.slide, making_, [&] { fill(act); });
        Progress progress(making_.options, frames_, 0);
        try {
            for (Act& act : acts_) at(act.made.slide, making_, [&] { draw(act, progress); });
        } catch (...) {
            progress.finish();
            throw;
        }
        progress.finish();
        for (Act& act : acts_) {
            keepIncident(act);
            made_.slides.push_back(std::move(act.made));
        }
        return std::move(made_);
    }

private:
    void prepare(const Slide& slide) {
        const Options options = optionsOf(slide, deck_, making_);
        Act& act = acts_.emplace_back();
        act.loaded = loadRuns(slide, options);
        act.plan = planSlide(slide, deck_, act.loaded, options, moving_);
        act.facts.emplace(slide, act.loaded, runs_);
        act.made.slide = slide;
        act.made.command = commandOf(slide, deck_, act.loaded);
        if (act.plan) frames_ += static_cast<int>(act.plan->frames.size());
        addNotes(act.loaded, made_.diagnostics);
        const std::string crowding = crowdingOf(deck_, slide, acts_.size());
        if (!crowding.empty()) made_.diagnostics.push_back(crowding);
    }

    void fill(Act& act) {
        std::optional<double> exhibit;
        if (act.plan) exhibit = act.plan->aspect();
        act.facts->fill(act.made, deck_.theme, exhibit, !making_.options.reproducible);
        act.incident = act.facts->incident();
    }

    /// Keeps the deck's first incident.
    void keepIncident(const Act& act) {
        std::string& kept = act.loaded.several ? made_.compared : made_.incident;
        if (kept.empty() && !act.incident.empty())
            kept = fmt::format("slide '{}': {}", printable(act.made.slide.id), act.incident);
    }

    void draw(Act& act, Progress& progress) {
        if (!act.plan) return;
        std::string incident;
        const Studio studio{making_.options.jobs, progress, incident};
        const std::string& id = act.made.slide.id;
        std::vector<MadePicture>& pictures = act.made.pictures;
        if (act.made.slide.exhibit == Exhibit::film)
            act.made.film = madeFilm(
                *act.plan, moving_ ? making_.folder / (id + ".mp4") : std::filesystem::path(),
                studio);
        else  // before the charts
            pictures.insert(pictures.begin(), act.made.slide.exhibit == Exhibit::still
                                                  ? madeStill(*act.plan, studio)
                                                  : madeStrip(*act.plan, studio));
        act.plan.reset();  // its scenes may be large
        if (act.incident.empty()) act.incident = incident;
        Talk(making_.options, false)
            .json(fmt::format(R"({{"event":"slide","slide":{}}})", jsonString(id)));
    }

    const Deck& deck_;
    const DeckMaking& making_;
    MadeDeck made_;
    bool moving_ = false;
    DeckRuns runs_;
    std::deque<Act> acts_;  // a deque does not move them: facts refer to their runs
    int frames_ = 0;
};

}  // namespace

std::string againLine(const Options& options) {
    return options.commandLine.empty() ? "" : "; to make the deck again: " + options.commandLine;
}

MadeDeck makeDeck(const Deck& deck, const DeckMaking& making) {
    watchSignals();
    return Making(deck, making).make();
}

}  // namespace demos
