#include "demos/commands/input_protection.h"

#include <fmt/format.h>

#include <filesystem>

#include "demos/text/complaints.h"
#include "demos/text/stop.h"

namespace demos {

void spareScenes(const std::vector<std::string>& scenes, const std::vector<std::string>& targets) {
    for (const std::string& target : targets)
        for (const std::string& scene : scenes) {
            std::error_code neither;  // set where one of them does not exist
            if (!target.empty() && std::filesystem::equivalent(target, scene, neither))
                refuse(fmt::format("'{}' is the scene itself; write to another file",
                                   printable(target)));
        }
}

}  // namespace demos
