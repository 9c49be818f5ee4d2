/// A draft as lines of text and as JSON.
#pragma once
#include <string>
#include <vector>

#include "demos/watch/draft.h"

namespace demos {

/// "frames 43 to 74 (2.87 to 4.93 s, section 'impact') changed"
std::string changeText(const Draft& draft, const FilmPlan& plan);

/// The report of a whole draft, without failures.
std::vector<std::string> draftLines(const Draft& draft, const FilmPlan& plan,
                                    const DraftPlaces& places);

/// The failures: expectations that failed, and an incident of the run.
std::vector<std::string> failureLines(const Draft& draft, const FilmPlan& plan);

/// {"event":"draft",...}
std::string draftJson(const Draft& draft, const FilmPlan& plan, const DraftPlaces& places);

}  // namespace demos
