/// A draft in lines for people, and as JSON.
#pragma once
#include <string>
#include <vector>

#include "demos/watch/draft.h"

namespace demos {

/// "frames 43 to 74 (2.87 to 4.93 s, section 'impact') changed"
std::string changeText(const Draft& draft, const FilmPlan& plan);

/// All that there is to say of a whole one, but what went wrong.
std::vector<std::string> draftLines(const Draft& draft, const FilmPlan& plan,
                                    const DraftPlaces& places);

/// What went wrong: expectations that were not kept, and a run that diverged.
std::vector<std::string> failureLines(const Draft& draft, const FilmPlan& plan);

/// {"event":"draft",...}
std::string draftJson(const Draft& draft, const FilmPlan& plan, const DraftPlaces& places);

}  // namespace demos
