/// The data of a run in replay.html.
#pragma once
#include <cstddef>
#include <nlohmann/json_fwd.hpp>

#include "demos/export/recording.h"

namespace demos {

/// How much of a recording a page holds.
struct ReplayShare {
    std::size_t every = 1;     // every n-th frame
    std::size_t contacts = 0;  // the strongest per frame
};

/// The most contacts with an impulse in one frame.
std::size_t mostContacts(const Recording& recording);

nlohmann::ordered_json replayJson(const Recording& recording, const ReplayShare& share);

}  // namespace demos
