#include "demos/film/frame_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "demos/text/complaints.h"
#include "demos/text/stop.h"

namespace demos {
namespace {

/// Reads a number at the front of `text` and removes it.
std::optional<int> numberAt(std::string_view& text) {
    int number = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
    if (read.ec != std::errc()) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
    return number;
}

bool takes(std::string_view& text, std::string_view word) {
    if (!text.starts_with(word)) return false;
    text.remove_prefix(word.size());
    return true;
}

std::optional<Shard> shardIn(std::string_view text, std::string_view between) {
    const std::optional<int> number = numberAt(text);
    if (!number || !takes(text, between)) return std::nullopt;
    const std::optional<int> count = numberAt(text);
    const bool good =
        count && text.empty() && *number >= 1 && *number <= *count && *count <= kMostShards;
    return good ? std::optional(Shard{*number, *count}) : std::nullopt;
}

[[noreturn]] void refuseList(const std::string& list, const std::string& why) {
    refuse(fmt::format("--frames '{}': {}", printable(shown(list)), why));
}

struct FrameRange {
    int first = 0, last = 0, step = 1;
};

FrameRange rangeIn(std::string_view text, const std::string& list, int frames) {
    FrameRange range;
    const std::optional<int> first = numberAt(text);
    const bool wide = first && takes(text, "..");
    const std::optional<int> last = wide ? numberAt(text) : first;
    const bool stepped = wide && last && takes(text, ":");
    const std::optional<int> step = stepped ? numberAt(text) : std::optional(1);
    if (!last || !step || *step < 1 || !text.empty())
        refuseList(list, "must be a list of frames and ranges, as in 1..10,20 or 0..-1:2");
    range = {*first < 0 ? frames + *first : *first, *last < 0 ? frames + *last : *last, *step};
    if (range.first < 0 || range.last >= frames)
        refuseList(list,
                   fmt::format("the film has frames 0 to {}, or -1 to -{}", frames - 1, frames));
    if (range.first > range.last) refuseList(list, "a range must go from a frame to a later one");
    return range;
}

}  // namespace

int Shard::first(int frames) const {
    return static_cast<int>(static_cast<long long>(frames) * (number - 1) / count);
}

int Shard::end(int frames) const {
    return static_cast<int>(static_cast<long long>(frames) * number / count);
}

std::string Shard::name() const { return fmt::format("{:03}-of-{:03}", number, count); }

Shard shardCalled(const std::string& text) {
    const std::optional<Shard> shard = shardIn(text, "/");
    if (!shard)
        refuse(fmt::format("--shard '{}': must be PART/PARTS, as in 3/16; at most {} parts",
                           printable(shown(text)), kMostShards));
    return *shard;
}

std::optional<Shard> shardNamed(const std::string& name) {
    const std::optional<Shard> shard = shardIn(name, "-of-");
    return shard && shard->name() == name ? shard : std::nullopt;
}

std::vector<bool> chosenFrames(const std::string& list, const std::optional<Shard>& shard,
                               int frames) {
    std::vector<bool> chosen(static_cast<std::size_t>(frames), list.empty() && !shard);
    if (shard) {
        if (shard->count > frames)
            refuse(fmt::format("--shard {}/{}: the film has {} frames; make fewer parts",
                               shard->number, shard->count, frames));
        std::fill(chosen.begin() + shard->first(frames), chosen.begin() + shard->end(frames), true);
    }
    std::string_view rest = list;
    while (!rest.empty()) {
        const std::size_t comma = std::min(rest.find(','), rest.size() - 1);
        const bool more = rest[comma] == ',';
        const FrameRange range = rangeIn(rest.substr(0, more ? comma : rest.size()), list, frames);
        for (int frame = range.first; frame <= range.last; frame += range.step)
            chosen[static_cast<std::size_t>(frame)] = true;
        rest.remove_prefix(comma + 1);
        if (more && rest.empty()) refuseList(list, "ends in a comma");
    }
    return chosen;
}

}  // namespace demos
