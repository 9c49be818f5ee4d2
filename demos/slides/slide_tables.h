/// Tables of a slide's runs.
#pragma once
#include <vector>

#include "demos/comparisons/measure_table.h"
#include "demos/play/expect.h"
#include "demos/slides/made_deck.h"

namespace demos {

/// A row a run, named where there are several; without what is 0 in all of them. `timing`: with the
/// measure ms, which is another in every run of the program.
MadeTable measuresTable(const std::vector<Measured>& runs, bool several, bool timing);

/// What came out for one run, or for each of several.
struct RunExpectations {
    std::string label;
    const SceneDescription* scene;           // which expects
    std::vector<ExpectationResult> results;  // in the order of the scene
};

/// A row an expectation: what, of, asked, came out, ok; numbers as quantityText() writes them.
MadeTable expectationsTable(const std::vector<RunExpectations>& runs);

}  // namespace demos
