/// Tables of a slide's runs.
#pragma once
#include <vector>

#include "demos/comparisons/measure_table.h"
#include "demos/play/expect.h"
#include "demos/slides/made_deck.h"

namespace demos {

/// A row per run, with its name if there are several; without measures that are 0 in all runs.
/// `timing`: with the measure ms, which differs in every run of the program.
MadeTable measuresTable(const std::vector<Measured>& runs, bool several, bool timing);

/// The results of one run's expectations.
struct RunExpectations {
    std::string label;
    const SceneDescription* scene;           // its expectations
    std::vector<ExpectationResult> results;  // in the order of the scene
};

/// A row per expectation: what, of, expected, measured, ok; numbers as of quantityText().
MadeTable expectationsTable(const std::vector<RunExpectations>& runs);

}  // namespace demos
