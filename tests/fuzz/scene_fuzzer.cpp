// Arbitrary bytes as a scene. If readScene rejects them, each line of its error has a place inside
// the text and only printable characters. If it accepts them, the engine does too (ENGINE_CHECK
// stops the program), and one step leaves a finite world or reports why not.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "demos/load/builtin.h"
#include "demos/play/stage.h"
#include "demos/scene/reader.h"
#include "demos/text/complaints.h"

namespace demos {

/// Scenes come from texts here, not from names.
std::span<const BuiltinScene> builtinScenes() { return {}; }

}  // namespace demos

namespace {

constexpr std::string_view kOption = "#--set ";
constexpr std::size_t kMostOptions = 8;
constexpr std::size_t kMostBodies = 64;  // of a world that is built; below, of one that is stepped
constexpr std::size_t kMostMoving = 8;

void require(bool truth, const char* what, std::string_view value) {
    if (truth) return;
    std::fprintf(stderr, "%s: %.*s\n", what, static_cast<int>(value.size()), value.data());
    std::abort();
}

/// A line that begins with `#--set ` is a comment in the scene and also an option.
std::vector<std::string> optionsIn(std::string_view text) {
    std::vector<std::string> options;
    for (std::size_t at = text.find(kOption);
         at != std::string_view::npos && options.size() < kMostOptions;
         at = text.find(kOption, at)) {
        at += kOption.size();
        options.emplace_back(text.substr(at, text.find('\n', at) - at));
    }
    return options;
}

/// Takes a number off the front; -1 if there is none.
long numberAt(std::string_view& line) {
    const std::size_t end = line.find(':');
    if (end == 0 || end > 9) return -1;
    long number = 0;
    for (const char digit : line.substr(0, end)) {
        if (digit < '0' || digit > '9') return -1;
        number = 10 * number + (digit - '0');
    }
    line.remove_prefix(end + 1);
    return number;
}

void checkComplaint(const std::string& whole, long linesOfText) {
    require(demos::printable(whole) == whole, "a byte that does not print", whole);
    std::string_view line = whole;
    if (line.starts_with("--set ") || line.starts_with("and ")) return;
    require(line.starts_with("a.toml:"), "an error without its file", whole);
    line.remove_prefix(7);
    const long row = numberAt(line), column = numberAt(line);
    require(row >= 1 && row <= linesOfText + 1, "a line that is not in the text", whole);
    require(column >= 1, "a column below 1", whole);
    require(line.size() > 3 && line[0] == ' ', "an error without a message", whole);
}

void checkRefusal(const demos::SceneError& error, std::string_view text) {
    require(!error.lines().empty(), "rejected without a message", text);
    const long lines = std::count(text.begin(), text.end(), '\n') + 1;
    for (const std::string& line : error.lines()) checkComplaint(line, lines);
}

/// Limits the work of a step, whatever settings the scene has.
void boundWork(engine::Settings& s) {
    s.threads = 1;
    s.substeps = std::min(s.substeps, 8);
    s.maxSubsteps = std::min(s.maxSubsteps, 8);
    s.sweeps = std::min(s.sweeps, 20);
    s.minSweeps = std::min(s.minSweeps, 20);
    s.nudges = std::min(s.nudges, 8);
}

void checkWorld(demos::SceneDescription scene) {
    if (scene.bodies.size() + scene.joints.size() > kMostBodies) return;
    boundWork(scene.settings);
    demos::Stage stage(scene);
    if (scene.bodies.size() > kMostMoving || !stage.step()) return;
    for (const engine::BodyId id : stage.bodies) {
        const bool finite = stage.world.pose(id).position.allFinite() &&
                            stage.world.velocity(id).allFinite() &&
                            stage.world.spin(id).allFinite();
        require(finite, "not finite after a step without an error", stage.nameOf(id));
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(bytes), size);
    try {
        checkWorld(demos::readScene(text, "a.toml", "a", optionsIn(text)));
    } catch (const demos::SceneError& error) {
        checkRefusal(error, text);
    }
    return 0;
}
