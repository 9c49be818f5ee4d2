#include "demos/own_files.h"

#include <fmt/format.h>

#include <filesystem>

#include "demos/scene/complaints.h"
#include "demos/stop.h"

namespace demos {
namespace {

std::vector<std::string> targetsOf(const Options& options) {
    std::vector<std::string> targets = options.outputs;
    for (const std::string* file : {&options.csv, &options.bodies, &options.joints,
                                    &options.contacts, &options.sweeps, &options.events,
                                    &options.plot, &options.poster, &options.caption})
        if (!file->empty()) targets.push_back(*file);
    return targets;
}

}  // namespace

void spareScenes(const Options& options) {
    for (const std::string& target : targetsOf(options))
        for (const std::string& scene : options.scenes) {
            std::error_code neither;  // one of them is no file
            if (std::filesystem::equivalent(target, scene, neither))
                throw Stop(Exit::usage,
                           fmt::format("'{}' is the scene itself; write to another file",
                                       printable(target)));
        }
}

}  // namespace demos
