/// A test's verdict in lines for people.
#pragma once
#include <string>
#include <vector>

#include "demos/regression/verdict.h"

namespace demos {

/// By how much a picture differs, and how much it may.
std::string differenceText(const render::Difference& difference, const PictureGate& gate);
/// "solver.sweeps 10 -> 12", baseline first; "-": none.
std::string settingText(const SettingChange& change);

/// "ok       stack  3 pictures, 2 expectations"
std::string headline(const SceneVerdict& scene);

/// What is wrong or worth knowing, physics first; nothing where all is as it was. Ends with what to
/// do, for a scene that `approve` can help.
std::vector<std::string> detailsOf(const SceneVerdict& scene);

/// "47 scenes: 45 passed, 2 failed"
std::string summaryOf(const TestVerdict& verdict);

}  // namespace demos
