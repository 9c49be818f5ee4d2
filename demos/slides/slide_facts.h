/// What a slide takes of its runs besides pictures of them: numbers, charts, tables.
#pragma once
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "demos/comparisons/measure_table.h"
#include "demos/slides/deck_runs.h"
#include "demos/slides/loaded_runs.h"
#include "demos/slides/made_deck.h"
#include "demos/slides/number_values.h"

namespace demos {

class SlideFacts {
public:
    /// Asks `runs` for what the slide needs; all three have to stay. Throws NumberError, and Stop
    /// (scene) for a number of a run that is not there.
    SlideFacts(const Slide& slide, const LoadedRuns& loaded, DeckRuns& runs);

    /// Plays that, if nobody did, and puts it into the slide. `exhibit`: width over height of the
    /// picture that is drawn besides. `timing`: with processor times, which are others every time.
    /// Throws Stop: scene (valueOf), interrupted, and diverged where the slide has one run alone or
    /// a number of a run that diverged.
    void fill(MadeSlide& made, const std::string& theme, std::optional<double> exhibit,
              bool timing);

private:
    void addTables(MadeSlide& made, const std::vector<Measured>& all, bool timing);
    bool asksAll() const { return !slide_.plots.empty() || slide_.measures; }
    void askNumber(const NumberName& name);
    void askMoment(std::size_t run);
    std::string keyOf(std::size_t run) const { return runKey(slide_, loaded_.variants[run]); }
    const PlayedMoment& momentOf(std::size_t run) const;
    std::vector<Measured> measured() const;
    /// Before the slide's moment, or the run's end: another slide of it may go on for longer.
    void checkDiverged(std::size_t run, bool toEnd) const;
    std::string valueOf(const NumberName& name, NumberSetting setting) const;

    const Slide& slide_;
    const LoadedRuns& loaded_;
    DeckRuns& runs_;
    std::set<std::size_t> asked_;  // runs, from 0
};

}  // namespace demos
