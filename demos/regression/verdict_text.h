/// A test's verdict as lines of text for people.
#pragma once
#include <string>
#include <vector>

#include "demos/regression/verdict.h"

namespace demos {

/// By how much a picture differs, and how much it may.
std::string differenceText(const render::Difference& difference, const PictureGate& gate);
/// "solver.sweeps 10 -> 12", baseline first; "-": none; "body.box is gone".
std::string settingText(const SettingChange& change);

/// "ok       stack  3 pictures, 2 expectations"
std::string headline(const SceneVerdict& scene);

/// Failures and remarks, physics first; empty if nothing differs. The last line is the command to
/// accept it, if `approve` can make the scene pass.
std::vector<std::string> detailsOf(const SceneVerdict& scene);

/// "47 scenes: 45 passed, 2 failed"
std::string summaryOf(const TestVerdict& verdict);

}  // namespace demos
