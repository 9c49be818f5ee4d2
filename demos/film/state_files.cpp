#include "demos/film/state_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <functional>

#include "demos/load/load_scene.h"
#include "demos/scene/reader.h"
#include "demos/text/complaints.h"
#include "demos/text/file_content.h"
#include "demos/text/hex_text.h"
#include "demos/text/program_bytes.h"
#include "demos/text/stop.h"
#include "demos/text/text_hash.h"
#include "demos/text/version.h"
#include "engine/base/state_bytes.h"
#include "render/encode/file.h"
#include "render/error.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

/// "impulse state 1", as the first 16 bytes; then the seal of all that follows.
constexpr char kMark[16] = "impulse state 1";
constexpr char kCameraMark[16] = "impulse camera1";
constexpr std::size_t kSealed = sizeof kMark + 8;  // bytes before what is sealed
constexpr const char* kDamaged = "is truncated or damaged: its hash does not match its content";
constexpr const char* kCameraFile = "camera.state";
constexpr std::uintmax_t kMostCameraBytes = 1u << 16;

/// Which of the overlays' memories a state has: they are kept only by a run that shows them.
struct Remembered {
    bool ghosts = false, stats = false, nudges = false;
    double ghostEvery = 0.0;  // s
    std::string colorBy;

    explicit Remembered(const Overlays& o)
        : ghosts(o.ghost),
          stats(o.stats),
          nudges(o.nudges),
          ghostEvery(o.ghostEvery),
          colorBy(o.colorBy) {}
};

/// What pictures with these overlays need and the state lacks, as --show calls it; "": nothing.
std::string missingFrom(const Remembered& has, const Remembered& needs) {
    if (needs.ghosts && (!has.ghosts || has.ghostEvery != needs.ghostEvery)) return "--show ghost";
    if (needs.stats && !has.stats) return "--show stats";
    if (needs.nudges && !has.nudges) return "--show nudges";
    if (needs.colorBy != has.colorBy && needs.colorBy != "body")
        return "--colour-by " + needs.colorBy;
    return {};
}

/// Eight bytes at a time, in four lanes: a byte at a time takes longer than all the rest. A state
/// belongs to one build, so that the order of a word's bytes does not matter.
std::uint64_t sealOf(std::span<const std::uint8_t> bytes) {
    std::uint64_t lanes[4] = {1, 2, 3, bytes.size()};
    std::size_t at = 0;
    const auto mix = [&](std::size_t lane, std::uint64_t word) {
        lanes[lane] = std::rotl(lanes[lane] ^ word, 27) * 0x9e3779b97f4a7c15ull;
    };
    for (; at + 32 <= bytes.size(); at += 32)
        for (std::size_t lane = 0; lane < 4; ++lane) {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes.data() + at + 8 * lane, sizeof word);
            mix(lane, word);
        }
    for (; at < bytes.size(); ++at) mix(at % 4, bytes[at]);
    std::uint64_t seal = 0;
    for (const std::uint64_t lane : lanes)
        seal = std::rotl(seal ^ lane, 31) * 0xff51afd7ed558ccdull;
    return seal ^ (seal >> 32);
}

/// Throws render::Error. What follows the seal is what was sealed.
std::vector<std::uint8_t> sealedFile(const fs::path& file, const char (&mark)[16], std::uintmax_t most) {
    const auto fail = [&](const char* what) {
        throw render::Error(fmt::format("{}: {}", printable(file.string()), what));
    };
    const std::vector<std::uint8_t> start = startOf(file, kSealed);
    const bool marked = start.size() == kSealed && std::equal(mark, mark + sizeof mark, start.begin());
    std::vector<std::uint8_t> bytes = contentOf(file, marked ? most : 0);
    std::error_code ignored;
    if (start.empty() && !fs::exists(file, ignored)) fail("there is no such file");
    if (start.empty() || (marked && bytes.empty())) fail("is not a file, is empty, or has more than 1 GiB");
    if (!marked || bytes.size() < kSealed)
        fail("is no state that 'impulse sim --states' of this version has written");
    const std::span<const std::uint8_t> all = bytes;
    engine::StateReader seal(all.subspan(sizeof mark, 8));
    std::uint64_t told = 0;
    seal(told);
    if (told != sealOf(all.subspan(kSealed))) fail(kDamaged);
    return bytes;
}

/// Adds the mark and room for the seal.
void begin(engine::StateWriter& writer, const char (&mark)[16]) {
    for (char letter : mark) writer(letter);
    std::uint64_t seal = 0;
    writer(seal);
}

void seal(std::vector<std::uint8_t>& bytes) {
    const std::uint64_t seal = sealOf(std::span(bytes).subspan(kSealed));
    for (std::size_t i = 0; i < 8; ++i)
        bytes[sizeof kMark + i] = static_cast<std::uint8_t>(seal >> (8 * i));
}

/// A file without the player's part, which follows.
struct StateContent {
    StateKind kind;
    Remembered remembered;
    ReadState state;  // its step

    template <class Bytes>
    void keep(Bytes& bytes) {
        bytes(kind.version, kind.build, kind.scene, kind.settings);
        bytes(remembered.ghosts, remembered.stats, remembered.nudges, remembered.ghostEvery);
        bytes(remembered.colorBy, state.step);
    }
};

/// Throws render::Error.
StateContent contentOfState(const fs::path& file) {
    std::vector<std::uint8_t> bytes = sealedFile(file, kMark, kMostStateBytes);
    engine::StateReader reader(std::span<const std::uint8_t>(bytes).subspan(kSealed));
    StateContent content{{}, Remembered({}), {}};
    content.keep(reader);
    if (!reader.isGood()) throw render::Error(fmt::format("{}: {}", printable(file.string()), kDamaged));
    content.state.start = bytes.size() - reader.left().size();
    content.state.file = std::move(bytes);
    return content;
}

/// Where the camera is that fits the motion of a run.
struct CameraContent {
    StateKind kind;
    double seconds = 0.0;  // of the run
    Vec3 from, lookAt;

    template <class Bytes>
    void keep(Bytes& bytes) {
        bytes(kind.version, kind.build, kind.scene, kind.settings, seconds, from, lookAt);
    }
};

/// What keeps a state from being gone on from; "": nothing.
std::string objectionTo(const StateContent& content, const StateKind& kind,
                        const Overlays& overlays) {
    const StateKind& its = content.kind;
    if (its.version != kind.version || its.build != kind.build)
        return fmt::format("is a state of impulse {} (build {}), and this is {} (build {})",
                           printable(its.version), hexText(its.build), kind.version,
                           hexText(kind.build));
    if (its.scene != kind.scene)
        return fmt::format("is a state of the scene '{}', and not of '{}'", printable(its.scene),
                           printable(kind.scene));
    if (its.settings != kind.settings)
        return fmt::format(
            "is a state of '{}' with other values ({}, and now {}): its file or --set "
            "differs",
            printable(kind.scene), hexText(its.settings), hexText(kind.settings));
    const std::string missing = missingFrom(content.remembered, Remembered(overlays));
    if (missing.empty()) return {};
    return fmt::format("lacks what pictures with {} show; write it with that option",
                       missing);
}

}  // namespace

std::optional<long long> stepOfState(const fs::path& file) {
    const std::string name = file.filename().string();
    const std::string digits = name.substr(0, name.find('.'));
    long long step = 0;
    const auto got = std::from_chars(digits.data(), digits.data() + digits.size(), step);
    const bool whole = got.ec == std::errc{} && got.ptr == digits.data() + digits.size();
    return whole && name == digits + ".state" ? std::optional(step) : std::nullopt;
}

StateKind stateKindOf(const SceneDescription& scene, const Options& options) {
    TextHash hash;
    hash.add(sceneText(options.scene()));
    for (const std::string& file : scene.files)
        hash.add(readSceneFile(file, "a file of the scene", kMostPartBytes));
    hash.add(std::to_string(scene.contents));
    for (const std::string& text : options.overrides)
        if (!text.starts_with("solver.threads")) hash.add(text);
    return {kVersion, programHash(), scene.name, hash.value()};
}

void writeState(const fs::path& folder, const StateKind& kind, const Overlays& overlays,
                const Player& player, std::vector<std::uint8_t>& memory) {
    const long long step = player.stage().world.report().step;
    StateContent content{kind, Remembered(overlays), {}};
    content.state.step = step;
    engine::StateWriter writer(memory);
    begin(writer, kMark);
    writer(content);
    player.saveState(memory, writer.end());
    seal(memory);
    render::writeFileAtomically(folder / fmt::format("{:06}.state", step), memory);
}

ReadState readState(const fs::path& file, const StateKind& kind, const Overlays& overlays) {
    StateContent content = contentOfState(file);
    const std::string objection = objectionTo(content, kind, overlays);
    if (!objection.empty())
        throw Stop(Exit::usage, fmt::format("{}: {}", printable(file.string()), objection));
    return std::move(content.state);
}

long long goOnFrom(const fs::path& file, const StateKind& kind, const Overlays& overlays,
                   Player& player) {
    const ReadState state = readState(file, kind, overlays);
    if (!player.restoreState(state.player()))
        throw render::Error(fmt::format("{}: is not a state of this scene's bodies and joints",
                                        printable(file.string())));
    return state.step;
}

std::optional<ReadState> nearestState(const fs::path& folder, const StateKind& kind,
                                      const Overlays& overlays, long long step) {
    std::vector<std::pair<long long, fs::path>> files;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
        if (const auto number = stepOfState(entry.path()); number && *number <= step)
            files.push_back({*number, entry.path()});
    std::sort(files.begin(), files.end(), std::greater<>());
    for (const auto& [number, path] : files) try {
            ReadState state = readState(path, kind, overlays);
            if (state.step == number) return state;
        } catch (const std::exception&) {  // another one may fit
        }
    return std::nullopt;
}

void writeCamera(const fs::path& folder, const StateKind& kind, const SceneDescription& scene,
                 const CameraDescription& camera) {
    CameraContent content{kind, scene.seconds, camera.from, camera.lookAt};
    std::vector<std::uint8_t> bytes;
    engine::StateWriter writer(bytes);
    begin(writer, kCameraMark);
    writer(content);
    bytes.resize(writer.end());
    seal(bytes);
    render::writeFileAtomically(folder / kCameraFile, bytes);
}

void readCamera(const fs::path& folder, const StateKind& kind, SceneDescription& scene) try {
    if (!scene.camera.fitsMotion) return;
    const std::vector<std::uint8_t> bytes = sealedFile(folder / kCameraFile, kCameraMark, kMostCameraBytes);
    engine::StateReader reader(std::span<const std::uint8_t>(bytes).subspan(kSealed));
    CameraContent content;
    content.keep(reader);
    if (!reader.isGood() || content.kind != kind || content.seconds != scene.seconds) return;
    scene.camera.from = content.from, scene.camera.lookAt = content.lookAt;
    scene.camera.fitsMotion = false;
} catch (const render::Error&) {  // none there: the run is simulated for it
}

}  // namespace demos
