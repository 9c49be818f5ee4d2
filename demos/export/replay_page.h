/// replay.html: a run to orbit, scrub and step in any browser, as one file without a network.
#pragma once
#include <string>

#include "demos/export/recording.h"

namespace demos {

/// A larger page gets fewer contacts per frame, then fewer frames.
constexpr std::size_t kReplayBytes = 10'000'000;

struct ReplayPage {
    std::string html;
    std::string left;  // what had to be left out, to be reported; empty: nothing
};

/// `recording`: has at least one frame.
ReplayPage replayPage(const Recording& recording, std::size_t bytes = kReplayBytes);

}  // namespace demos
