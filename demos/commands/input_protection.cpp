#include "demos/commands/input_protection.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "demos/text/complaints.h"
#include "demos/text/file_content.h"
#include "demos/text/stop.h"

namespace demos {
namespace {

constexpr std::size_t kEnough = 4096;  // bytes at the start of a file

bool isPlain(std::string_view line) {
    return std::ranges::none_of(line, [](char c) { return static_cast<unsigned char>(c) < 0x20; });
}

bool isOfKind(ResultKind kind, std::string_view start) {
    const std::string_view line = start.substr(0, start.find('\n'));
    switch (kind) {
        case ResultKind::table:
            return isPlain(line) && line.find(',') != line.npos;
        case ResultKind::events:
            return start.starts_with('{') || start.starts_with('[');
        case ResultKind::chart:
            return start.starts_with("\x89PNG") || start.starts_with("<svg") || start.starts_with("<?xml");
    }
    return false;
}

const char* wordOf(ResultKind kind) {
    return kind == ResultKind::table ? "table" : kind == ResultKind::events ? "list of events" : "chart";
}

}  // namespace

void spareOthers(ResultKind kind, const std::vector<std::string>& targets) {
    for (const std::string& target : targets) {
        const std::vector<std::uint8_t> start = startOf(target, kEnough);
        if (!start.empty() && !isOfKind(kind, {reinterpret_cast<const char*>(start.data()), start.size()}))
            throw Stop(Exit::wouldOverwrite,
                       fmt::format("'{}' already exists and is no {}; remove it or write to another file",
                                   printable(target), wordOf(kind)));
    }
}

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
