// Arbitrary bytes as a MuJoCo model. As in scene_fuzzer.cpp, they have to be rejected in complete
// lines with a place inside the text, or be simulated by the engine and finite after a step.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "demos/load/builtin.h"
#include "demos/mjcf/model_reader.h"
#include "demos/play/stage.h"
#include "demos/scene/reader.h"
#include "demos/text/complaints.h"

namespace demos {

/// Scenes come from texts here, not from names.
std::span<const BuiltinScene> builtinScenes() { return {}; }

}  // namespace demos

namespace {

constexpr std::size_t kMostBodies = 64;  // of a world that is built; below, of one that is stepped
constexpr std::size_t kMostMoving = 8;

void require(bool truth, const char* what, std::string_view value) {
    if (truth) return;
    std::fprintf(stderr, "%s: %.*s\n", what, static_cast<int>(value.size()), value.data());
    std::abort();
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

/// `a.xml:line:column: what`, of this text or of an included one.
void checkLine(const std::string& whole, long linesOfText) {
    require(demos::printable(whole) == whole, "a byte that does not print", whole);
    std::string_view line = whole;
    if (line.starts_with("and ")) return;
    const std::size_t file = line.find(".xml:");
    require(file != std::string_view::npos, "a line without its file", whole);
    const bool own = file == 1 && line[0] == 'a';
    line.remove_prefix(file + 5);
    if (!own) return;
    const long row = numberAt(line), column = numberAt(line);
    require(row >= 1 && row <= linesOfText + 1, "a line that is not in the text", whole);
    require(column >= 1, "a column below 1", whole);
    require(line.size() > 3 && line[0] == ' ', "a line without a message", whole);
}

/// Every file that a model names is this mesh, or missing.
std::string fileCalled(const std::filesystem::path& path) {
    if (path.extension() == ".obj") return "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    throw demos::SceneError({demos::printable(path.string()) + ": there is no such file"});
}

void checkWorld(demos::SceneDescription scene) {
    if (scene.bodies.size() + scene.joints.size() > kMostBodies) return;
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
    const std::string text(reinterpret_cast<const char*>(bytes), size);
    const long lines = std::count(text.begin(), text.end(), '\n') + 1;
    try {
        demos::SceneDescription scene = demos::mjcf::readModel(text, "a.xml", "a", {}, fileCalled);
        for (const std::string& note : scene.notes) checkLine(note, lines);
        checkWorld(std::move(scene));
    } catch (const demos::SceneError& error) {
        require(!error.lines().empty(), "rejected without a message", text);
        for (const std::string& line : error.lines()) checkLine(line, lines);
    }
    return 0;
}
