/// Simulates a film once for all its drawing processes, in a process of its own.
#pragma once
#include <vector>

#include "demos/film/film_plan.h"
#include "demos/processes/channel.h"

namespace demos {

/// Whether a frame can be drawn from a state of the simulation alone: not with several panels, nor with
/// data passes that watch every step or look ahead.
bool canDrawFromStates(const FilmPlan& plan);

/// The main function of the simulating process: receives the wanted frames through `orders` and sends
/// worker i the states of its frames, the wanted ones number i, i + feeds.size(), ...: a state is of the
/// frame, or with several moments per frame of the one before it. With the film's last frame it sends what
/// happened until the end of the scene. An error is sent to every worker.
/// Throws nothing.
void runSimulator(const FilmPlan& plan, Channel& orders, std::vector<Channel>& feeds) noexcept;

}  // namespace demos
