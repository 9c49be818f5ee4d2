/// States of an unfinished film, in the folder of its frames: .impulse-resume/000240.state. A killed run then
/// continues from one of them instead of simulating from the beginning. Where simulating takes less than three
/// seconds nothing is written; when the film is complete, they are removed.
#pragma once
#include <cstdint>
#include <vector>

#include "demos/film/composite.h"
#include "demos/film/film_options.h"
#include "demos/film/film_plan.h"
#include "demos/film/outputs.h"

namespace demos {

/// s: a run's frames are recorded, and its states are written, about so often.
inline constexpr double kResumeEvery = 3.0;

/// Names the folder in the plan, and starts from what is there unless other states were named. Nothing for films
/// without PNG frames, for those that need all steps, and with --frames: states are removed as frames are recorded
/// from the first one on.
void planToResume(const std::vector<Output>& outputs, const FilmOptions& options, FilmPlan& plan);

/// fitCameras. Returns whether it has simulated for so long that keepCamera() saves time. Throws Stop (interrupted).
bool fitForLong(FilmPlan& plan, const FilmOptions& options);
/// To be called when the folder of the frames is this run's.
void keepCamera(const FilmPlan& plan);

/// Removes the states that are not needed to go on from `frame`.
void removeStatesBefore(int frame, const FilmPlan& plan);
/// Removes all, and the folder unless it has other files.
void clearStates(const FilmPlan& plan);

/// Used by the process that simulates.
class ResumeStates {
public:
    /// `every`: s of processor time between two states.
    explicit ResumeStates(const FilmPlan& plan, double every = kResumeEvery) : plan_(plan), every_(every) {}

    /// To be called before and after a part of the simulation. A state that cannot be written is left out.
    void begin();
    void end(const Composite& composite);

private:
    const FilmPlan& plan_;
    double every_;
    double begin_ = 0.0, unsaved_ = 0.0;  // s, of processor time
    std::vector<std::uint8_t> memory_;    // of the last state
};

}  // namespace demos
