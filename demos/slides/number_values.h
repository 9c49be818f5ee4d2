/// The values of @{...}.
#pragma once
#include <string>
#include <vector>

#include "demos/measures/summary.h"
#include "demos/play/expect.h"
#include "demos/slides/numbers.h"
#include "demos/slides/quantity.h"
#include "demos/slides/run_moment.h"

namespace demos {

/// One run up to a moment.
struct RunNumbers {
    const SceneDescription& scene;
    const Summary& summary;  // up to the moment
    const RunMoment& moment;
    const std::vector<ExpectationResult>& expectations;  // of the whole run
};

/// Throws Stop (scene) if the scene has no body, joint or [[expect]] of that name.
std::string valueOf(const NumberName& name, const RunNumbers& run, NumberSetting setting);

}  // namespace demos
