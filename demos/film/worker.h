/// The main function of a drawing process.
#pragma once
#include "demos/film/film_plan.h"
#include "demos/processes/channel.h"

namespace demos {

struct WorkerTask {
    int index = 0, count = 1;  // draws the wanted frames number index, index + count, ...
    bool png = true, raw = false;
};

/// Reports frames and errors through the channel; throws nothing. `states`: of its frames, from a
/// simulating process (simulator.h); none: the worker simulates all frames.
void runWorker(const FilmPlan& plan, const WorkerTask& task, Channel& channel,
               Channel* states) noexcept;

}  // namespace demos
