/// What replay.html knows of a run.
#pragma once
#include <cstddef>
#include <nlohmann/json_fwd.hpp>

#include "demos/export/recording.h"

namespace demos {

/// How much of a recording a page holds.
struct ReplayShare {
    std::size_t every = 1;     // of the frames
    std::size_t contacts = 0;  // a frame, the strongest
};

/// Of one frame; those that push.
std::size_t mostContacts(const Recording& recording);

nlohmann::ordered_json replayJson(const Recording& recording, const ReplayShare& share);

}  // namespace demos
