#include "demos/film/part_review.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "demos/text/complaints.h"
#include "demos/text/shell_word.h"
#include "demos/text/stop.h"

namespace demos {
namespace {

/// Run, program, pixels.
using PartKind = std::tuple<std::uint64_t, std::string, std::string>;

PartKind kindOf(const PartSeen& part) { return {part.run, part.program, part.pixels}; }

/// The kind of most parts, of this run if one is given.
PartKind usualKind(const std::vector<PartSeen>& parts, std::optional<std::uint64_t> run) {
    std::map<PartKind, int> counts;
    for (PartSeen part : parts) {
        if (!part.readable) continue;
        const bool own = part.run == run.value_or(part.run);
        part.run = run.value_or(part.run);
        counts[kindOf(part)] += own ? 1 : 0;
    }
    const auto most =
        std::max_element(counts.begin(), counts.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == counts.end() ? PartKind{} : most->first;
}

const char* oddness(const PartKind& kind, const PartKind& usual) {
    if (std::get<2>(kind) != std::get<2>(usual))
        return "of another class of processors (--reproducible draws the same on all)";
    if (std::get<1>(kind) != std::get<1>(usual)) return "of another program or renderer";
    return "of another run";
}

/// What is wrong with a part; empty: nothing.
std::string troubleOf(const PartSeen* part, const PartKind& usual) {
    if (!part) return "missing";
    if (part->readable && kindOf(*part) != usual) return oddness(kindOf(*part), usual);
    return part->readable && part->whole ? "" : "damaged or incomplete";
}

/// Index of each part by its number, from 1; no index: missing.
std::vector<std::optional<std::size_t>> byNumber(const std::vector<PartSeen>& parts,
                                                 const std::string& place) {
    const int count = parts.front().shard.count;
    std::vector<std::optional<std::size_t>> places(static_cast<std::size_t>(count) + 1);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Shard& shard = parts[i].shard;
        if (shard.count != count)
            refuse(fmt::format("'{}' has parts of {} and of {}; remove those that do not belong",
                               place, count, shard.count));
        std::optional<std::size_t>& here = places[static_cast<std::size_t>(shard.number)];
        if (here)
            refuse(fmt::format("'{}' has part {} twice; remove the one that does not belong",
                               place, shard.number));
        here = i;
    }
    return places;
}

/// Where the words " --shard 3/16" are; empty: nowhere.
std::pair<std::size_t, std::size_t> shardOption(const std::string& command) {
    constexpr std::string_view kOption = " --shard";
    const std::size_t at = command.find(kOption);
    if (at == std::string::npos) return {0, 0};
    // After a space or '='.
    const std::size_t value = std::min(at + kOption.size() + 1, command.size());
    return {at, std::min(command.find(' ', value), command.size()) - at};
}

/// Replaces the option.
std::string commandWith(const std::string& option, std::string command, std::string_view program) {
    if (!command.starts_with(program) || !arePlainWords(command)) return {};
    const auto [at, length] = shardOption(command);
    return length == 0 ? "" : command.replace(at, length, option);
}

}  // namespace

bool isIn(const Shard& shard, std::size_t index) {
    return index % static_cast<std::size_t>(shard.count) ==
           static_cast<std::size_t>(shard.number - 1);
}

void checkShard(const Shard& shard, std::size_t count, const char* what) {
    if (static_cast<std::size_t>(shard.count) > count)
        refuse(fmt::format("--shard {}/{}: there are {} {}; make fewer parts", shard.number,
                           shard.count, count, what));
}

PartReview reviewed(const std::vector<PartSeen>& parts, const std::string& place,
                    std::optional<std::uint64_t> run) {
    const std::string name = printable(place);
    if (parts.empty()) refuse(fmt::format("'{}' has no parts; make them with --shard 1/N", name));
    const std::vector<std::optional<std::size_t>> numbered = byNumber(parts, name);
    const PartKind usual = usualKind(parts, run);
    PartReview review;
    review.count = parts.front().shard.count;
    std::map<std::string, std::vector<int>> troubles;
    for (int number = 1; number <= review.count; ++number) {
        const std::optional<std::size_t> i = numbered[static_cast<std::size_t>(number)];
        const std::string trouble = troubleOf(i ? &parts[*i] : nullptr, usual);
        if (trouble.empty()) {
            review.good.push_back(*i);
            continue;
        }
        if (i && parts[*i].readable && kindOf(parts[*i]) != usual) review.foreign.push_back(number);
        troubles[trouble].push_back(number);
        review.wanted.push_back(number);
    }
    for (const auto& [what, numbers] : troubles)
        review.troubles.push_back(fmt::format("{}: {}", what, fmt::join(numbers, " ")));
    return review;
}

std::string commandOf(std::string command, std::string_view program, const Shard& shard) {
    return commandWith(fmt::format(" --shard {}/{}", shard.number, shard.count),
                       std::move(command), program);
}

std::string commandOfWhole(std::string command, std::string_view program) {
    return commandWith("", std::move(command), program);
}

}  // namespace demos
