/// Helpers to run another program.
#pragma once
#include <spawn.h>

#include <chrono>
#include <string>
#include <string_view>

namespace render {

/// The two structures of posix_spawn, freed by the destructor.
struct SpawnPlan {
    SpawnPlan();
    ~SpawnPlan();
    SpawnPlan(const SpawnPlan&) = delete;
    SpawnPlan& operator=(const SpawnPlan&) = delete;

    /// Puts the child into its own process group, with default signal handlers. Ctrl-C reaches a
    /// whole group: the child then can finish its work, or can be killed with all it has started.
    void standAlone();

    posix_spawn_file_actions_t files;  ///< the files the child inherits
    posix_spawnattr_t attributes;      ///< signals and process group
};

/// The milliseconds in the environment `variable`, for tests of programs that hang; `unlessSet` if
/// it is not set or not within 1 ms to a day.
std::chrono::milliseconds patienceOf(const char* variable, std::chrono::milliseconds unlessSet);

/// The last line that is not empty, with control characters replaced; at most 300 bytes.
std::string lastLineOf(std::string_view text);

}  // namespace render
