/// What it takes to run another program, whichever it is.
#pragma once
#include <spawn.h>

#include <chrono>
#include <string>
#include <string_view>

namespace render {

/// posix_spawn's two structures, freed on every way out.
struct SpawnPlan {
    SpawnPlan();
    ~SpawnPlan();
    SpawnPlan(const SpawnPlan&) = delete;
    SpawnPlan& operator=(const SpawnPlan&) = delete;

    /// In a process group of its own, with signals as they were before anybody caught them: Ctrl-C
    /// reaches a whole group, and this one has work to finish, or goes with all it has started.
    void standAlone();

    posix_spawn_file_actions_t files;  ///< which of our files it has
    posix_spawnattr_t attributes;      ///< signals and process group
};

/// The milliseconds that the environment's `variable` says, for tests of programs that hang;
/// `unlessSet` where it says nothing, or nothing from 1 ms to a day.
std::chrono::milliseconds patienceOf(const char* variable, std::chrono::milliseconds unlessSet);

/// The last line that says something, without what could steer a terminal; at most 300 bytes.
std::string lastLineOf(std::string_view text);

}  // namespace render
