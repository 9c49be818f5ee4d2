/// Which of a film's frames a run draws: --frames and --shard.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace demos {

/// One of `count` parts of a film, each of consecutive frames.
struct Shard {
    int number = 1, count = 1;  // number: from 1
    /// Its first frame, and the one after its last, of a film of `frames` frames.
    int first(int frames) const;
    int end(int frames) const;
    std::string name() const;  // "003-of-016"
};

inline constexpr int kMostShards = 10'000;

/// "3/16". Throws Stop (usage).
Shard shardCalled(const std::string& text);
/// "003-of-016"; nothing for other names.
std::optional<Shard> shardNamed(const std::string& name);

/// `list`: "120..179", "0..-1", "0..299:2", "1..10,20"; negative numbers count from the
/// end; empty: all frames, or with a shard those of the shard. Throws Stop (usage).
std::vector<bool> chosenFrames(const std::string& list, const std::optional<Shard>& shard,
                               int frames);

}  // namespace demos
