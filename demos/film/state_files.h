/// Files with the state of a run: DIR/000240.state, after step 240. Another run continues from there,
/// to the same bits. A file belongs to one build of the program and one scene with its settings; a
/// hash seals it.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "demos/options/options.h"
#include "demos/snapshot/player.h"

namespace demos {

/// What a state belongs to.
struct StateKind {
    std::string version;      // of the program
    std::uint64_t build = 0;  // hash of its bytes
    std::string scene;
    std::uint64_t settings = 0;  // hash of the scene's files, and of --set but for threads

    bool operator==(const StateKind&) const = default;
};
StateKind stateKindOf(const SceneDescription& scene, const Options& options);

inline constexpr std::uintmax_t kMostStateBytes = 1u << 30;

/// A state that was read and is what it should be.
struct ReadState {
    long long step = 0;
    std::vector<std::uint8_t> file;  // all of it
    std::size_t start = 0;           // of the player's part

    std::span<const std::uint8_t> player() const { return std::span(file).subspan(start); }
};

/// Writes the player's state into the folder, which must exist, in one step. `memory`: of the state
/// before, to be used again. Throws render::Error.
void writeState(const std::filesystem::path& folder, const StateKind& kind,
                const Overlays& overlays, const Player& player,
                std::vector<std::uint8_t>& memory);

/// 240 of "000240.state"; nothing for other names.
std::optional<long long> stepOfState(const std::filesystem::path& file);

/// Throws render::Error if it is no whole state, Stop (usage) if it is of another program or scene,
/// or lacks what these overlays show; both are named.
ReadState readState(const std::filesystem::path& file, const StateKind& kind,
                    const Overlays& overlays);

/// readState, and the player continues from there. Returns the step.
long long goOnFrom(const std::filesystem::path& file, const StateKind& kind,
                   const Overlays& overlays, Player& player);

/// The folder's last state of a step up to `step` that belongs to this and remembers what is shown;
/// nothing if there is none. Other files, and states that are damaged, are passed over.
std::optional<ReadState> nearestState(const std::filesystem::path& folder, const StateKind& kind,
                                      const Overlays& overlays, long long step);

/// Adds DIR/camera.state: where a camera that fits the motion of this whole run is, so that parts of its film
/// need not simulate it. Throws render::Error.
void writeCamera(const std::filesystem::path& folder, const StateKind& kind, const SceneDescription& scene,
                 const CameraDescription& camera);

/// Places the scene's camera, if it fits the motion and the folder has that of a run of the same kind and length.
void readCamera(const std::filesystem::path& folder, const StateKind& kind, SceneDescription& scene);

}  // namespace demos
