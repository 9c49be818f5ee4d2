/// replay.html: one file with a run to orbit, scrub and step, for any browser, without a network.
#pragma once
#include <string>

#include "demos/export/recording.h"

namespace demos {

/// Rather fewer contacts a frame, and then fewer frames, than more bytes than this.
constexpr std::size_t kReplayBytes = 10'000'000;

struct ReplayPage {
    std::string html;
    std::string left;  // what had to be left out, for a line on the screen; empty: nothing
};

/// `recording`: of one frame at least.
ReplayPage replayPage(const Recording& recording, std::size_t bytes = kReplayBytes);

}  // namespace demos
