/// Compares a run with its baseline.
#pragma once
#include <filesystem>

#include "demos/regression/baseline.h"
#include "demos/regression/scene_choice.h"
#include "demos/regression/test_run.h"
#include "demos/regression/verdict.h"

namespace demos {

/// The results of a run, with pictures as bytes of PNG files: what is compared, kept and approved.
struct Actual {
    Baseline baseline;                           // as it would be kept
    std::vector<std::vector<std::uint8_t>> png;  // by index in baseline.pictures
};

/// `overrides`: those of --set.
Actual actualOf(const TestRun& played, const FilmPlan& plan, const ChosenScene& chosen,
                const std::vector<std::string>& overrides);

/// Fills in physics, pictures, settings, expectations and the resulting state. `folder`: of the
/// baseline. Problems with the baseline are reported in the verdict, not thrown.
void judge(const TestRun& played, const Actual& actual, const std::filesystem::path& folder,
           SceneVerdict& verdict);

/// Whether the gate passes a difference that was measured with its levels.
bool letsPass(const PictureGate& gate, const render::Difference& difference);

/// Compares a picture with the file of its baseline, by the scene's gate.
void judgePicture(const render::Image& actual, const std::vector<std::uint8_t>& png,
                  const std::vector<std::uint8_t>& baseline, const PictureGate& gate,
                  PictureVerdict& verdict);

/// Writes pictures first, then baseline.json: until that is written, a reader detects that they do
/// not match. Throws render::Error.
void writeBaseline(const Actual& actual, const Tolerance& tolerance,
                   const std::filesystem::path& folder);

}  // namespace demos
