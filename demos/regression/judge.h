/// A run against its baseline.
#pragma once
#include <filesystem>

#include "demos/regression/baseline.h"
#include "demos/regression/test_run.h"
#include "demos/regression/verdict.h"

namespace demos {

/// What a run has shown, with its pictures as files are: what is compared, kept and approved.
struct Actual {
    Baseline baseline;  // as it would be kept
    std::vector<std::vector<std::uint8_t>> png;  // by place in baseline.pictures
};

Actual actualOf(const TestRun& played, const FilmPlan& plan, const std::string& scene);

/// Fills in physics, pictures, settings, expectations and the state they lead to. `folder`: of the
/// baseline. What is wrong with it is told in the verdict, not thrown.
void judge(const TestRun& played, const Actual& actual, const std::filesystem::path& folder,
           SceneVerdict& verdict);

/// Whether a difference, measured with the gate's levels, is let through.
bool letsPass(const PictureGate& gate, const render::Difference& difference);

/// A picture against the file of its baseline, by the scene's gate.
void judgePicture(const render::Image& actual, const std::vector<std::uint8_t>& png,
                  const std::vector<std::uint8_t>& baseline, const PictureGate& gate,
                  PictureVerdict& verdict);

/// Both files, pictures first: until baseline.json is there, a reader sees that it does not fit.
/// Throws render::Error.
void writeBaseline(const Actual& actual, const Tolerance& tolerance,
                   const std::filesystem::path& folder);

}  // namespace demos
