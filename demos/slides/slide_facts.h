/// What a slide takes from its runs in addition to pictures: numbers, charts, tables.
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
    /// Requests from `runs` what the slide needs; all three must outlive it. Throws NumberError,
    /// and Stop (scene) for a number of a run that does not exist.
    SlideFacts(const Slide& slide, const LoadedRuns& loaded, DeckRuns& runs);

    /// Simulates the runs if necessary, and fills in the slide. `exhibit`: width over height of the
    /// picture next to the charts. `timing`: with processor times, which differ every time. Throws
    /// Stop: scene (valueOf), interrupted, and diverged if a step of the slide's only run or of the
    /// run of a number failed.
    void fill(MadeSlide& made, const std::string& theme, std::optional<double> exhibit,
              bool timing);
    /// After fill(): what happened in the first of the simulated runs that has an incident, of
    /// several with its label; "": nothing.
    std::string incident() const;

private:
    void addTables(MadeSlide& made, const std::vector<Measured>& all, bool timing);
    bool asksAll() const { return !slide_.plots.empty() || slide_.measures; }
    void askNumber(const NumberName& name);
    void askMoment(std::size_t run);
    std::string keyOf(std::size_t run) const { return runKey(slide_, loaded_.variants[run]); }
    const PlayedMoment& momentOf(std::size_t run) const;
    std::vector<Measured> measured() const;
    /// Throws if a step failed before the slide's moment or, with `toEnd`, its end; another slide
    /// may use more of the run.
    void checkFailed(std::size_t run, bool toEnd) const;
    std::string valueOf(const NumberName& name, NumberSetting setting) const;

    const Slide& slide_;
    const LoadedRuns& loaded_;
    DeckRuns& runs_;
    std::set<std::size_t> asked_;  // runs, from 0
};

}  // namespace demos
