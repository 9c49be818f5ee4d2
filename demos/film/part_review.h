/// Work in parts that several machines do: which parts there are, whether they belong together, and
/// the commands for those that are missing.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "demos/film/frame_choice.h"

namespace demos {

/// Whether a part has this scene or run of many (from 0). They are dealt out in turn: neighbours
/// often take equally long.
bool isIn(const Shard& shard, std::size_t index);
/// Throws Stop (usage) if there are more parts than `count`; `what`: "scenes".
void checkShard(const Shard& shard, std::size_t count, const char* what);

/// A part that was found.
struct PartSeen {
    Shard shard;
    bool readable = false;        // it has a record
    bool whole = false;           // nothing of it is missing or changed
    std::uint64_t run = 0;        // hash of what the parts of a run share
    std::string program, pixels;  // pixels: the class of processors; empty: any
};

struct PartReview {
    int count = 0;
    std::vector<std::size_t> good;      // indices of the parts that belong together, by number
    std::vector<int> wanted;            // numbers of the parts to make, or make again
    std::vector<int> foreign;           // those of them that another run, program or processor has made
    std::vector<std::string> troubles;  // "missing: 3 7", "of another program: 5"
};

/// `run`: that of the whole; without it, most parts decide. `place`: where they are, for messages.
/// Throws Stop (usage) if there are no parts, parts of two counts, or two with one number.
PartReview reviewed(const std::vector<PartSeen>& parts, const std::string& place,
                    std::optional<std::uint64_t> run = std::nullopt);

/// A part's command, for another part. Empty unless it begins with `program` and is nothing but
/// words: records may come from other machines, and their commands are run.
std::string commandOf(std::string command, std::string_view program, const Shard& shard);
/// The same without --shard: the command for the whole.
std::string commandOfWhole(std::string command, std::string_view program);

}  // namespace demos
