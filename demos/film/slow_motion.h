/// Slow motion: which step of a run each frame of its film shows where sections are slow. There the
/// run's time t passes at the section's share of the film's time T:
///
///   dt = slow dT
///
/// A span of the run from t0 to t1 lasts (t1 - t0) / slow in the film; above 1 the film is a time lapse.
#pragma once
#include <vector>

#include "demos/scene/description.h"

namespace demos {

/// Whether a section that the run reaches has another speed than 1.
bool hasSlowMotion(const SceneDescription& scene);

/// The time of the film, in s, at which the run is at `time`, s.
double filmTimeAt(double time, const SceneDescription& scene);

/// The step of each of `frames` frames at `fps` frames a second, then the run's last; ascending. There is
/// no picture between two steps: a frame shows the last step before its time, perhaps again.
std::vector<int> stepsOfFrames(const SceneDescription& scene, int fps, int frames);

/// A line for each section that shows steps in several frames, which looks jerky.
std::vector<std::string> jerkySections(const SceneDescription& scene, int fps);

}  // namespace demos
