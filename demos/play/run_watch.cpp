#include "demos/play/run_watch.h"

namespace demos {

std::vector<std::string> RunWatch::lines(const Stage& stage) const {
    std::vector<std::string> lines;
    if (const std::string failed = failedLine(checker_.results()); !failed.empty())
        lines.push_back(stage.scene.name + ": " + failed);
    if (std::string falls = falls_.line(stage); !falls.empty()) lines.push_back(std::move(falls));
    return lines;
}

}  // namespace demos
