/// What a caption says of a picture's moment.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "demos/film/film_plan.h"
#include "demos/look/paper.h"
#include "demos/snapshot/player.h"

namespace demos {

struct PictureFacts {
    double time = 0.0;  // s
    long step = 0;
    std::uint64_t state = 0;  // engine's state hash
    double impulse = 0.0;   // N s that an arrow of 1 cm stands for where the camera looks; 0: none
    double nudge = 0.0;     // mm likewise
    double colorEnd = 0.0;  // of the scale that bodies are coloured by
    double friction = 0.0;  // as impulse, of the arrows across
    bool onPaper = false;
    std::vector<std::string> leftOut = {};  // "stats", "legend", "caption": what has no room
};

/// `frame`: the player's frame as drawn.
PictureFacts factsOf(const Player& player, const FilmPlan& plan, const render::Frame& frame,
                     const Paper& paper);

/// "t = 0, 1.5 s"
std::string timesText(const std::vector<PictureFacts>& facts);

/// "; red arrows: impulses, 1 cm = 50 N s", the other marks that are on, and what bodies are
/// coloured by; empty if there is nothing to explain. On paper only arrows that are seen are named.
std::string scalesText(const Overlays& overlays, const std::vector<PictureFacts>& facts);

/// What belongs in the corners but has no room: "stats", "legend", "caption".
std::vector<std::string> leftOut(const render::Frame& frame, int width, int height);

/// What at least one of the pictures has no room for.
std::vector<std::string> leftOut(const std::vector<PictureFacts>& facts);

}  // namespace demos
