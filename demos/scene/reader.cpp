#include "demos/scene/reader.h"

#include <deque>
#include <fstream>
#include <system_error>
#include <utility>

#include "demos/scene/include.h"
#include "demos/scene/overrides.h"
#include "demos/scene/table_readers.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
    return text;
}

void readFormat(Keys& top) {
    const Value* format = top.any("format");
    if (!format)
        top.complain("format", "the scene has no format; begin it with format = 1");
    else if (format->kind == Value::Kind::integer && format->integer == 1)
        top.whole("format", {1, 1});
    else
        top.complain("format", "format is " + describe(*format) + "; this version reads format 1");
}

void readTop(Keys& top, SceneDescription& scene) {
    top.texts("include");  // was read before anything else
    scene.title = top.text("title").value_or(scene.name);
    scene.purpose = top.text("purpose").value_or("");
    scene.group = top.text("group").value_or("");
    // If the length is wrong, times are not checked against it: that would report the error again.
    const Range lengths{0.01, 1e5, "s"};
    if (top.has("seconds") || top.isMisspelt("seconds")) scene.seconds = lengths.high;
    scene.seconds = top.number("seconds", lengths).value_or(scene.seconds);
}

SceneDescription describeScene(const Value& document, const std::vector<ItemOverride>& overrides,
                               const std::string& sceneName, const std::optional<fs::path>& folder,
                               const Scope& scope, Complaints& complaints) {
    SceneDescription scene;
    scene.name = sceneName;
    scene.folder = folder;
    Keys top(document, "a scene", complaints, scope);
    readFormat(top);
    readValues(top, *scope.expressions, complaints);
    readTop(top, scene);
    readWorld(top, scene);
    readSolver(top, scene);
    const Materials materials = readMaterials(top, complaints);
    const Repeatable tables{top.tables("body"), top.tables("joint"), top.tables("force"),
                            top.tables("repeat")};
    Instances instances = unroll(tables, scene.seed, scope, complaints);
    if (instances.incomplete) return scene;  // to read what there is may take a minute
    std::deque<Value> changed;
    applyToItems(overrides, instances, changed, complaints);
    const BodyNumbers numbers = readBodies(instances.bodies, materials, scene, complaints);
    numberGroups(scene, complaints);
    readJoints(instances.joints, numbers, scene, complaints);
    readForces(instances.forces, numbers, scene, complaints);
    if (complaints.count() == 0 && scene.bodies.empty())
        complaints.add(document.place, "the scene has no body; write a [[body]]");
    readCamera(top, numbers, scene);
    readLook(top, scene);
    readSections(top, scene);
    readExpectations(top, scene);
    readSnapshot(top, scene);
    top.done();
    return scene;
}

/// The path of a text of this name; nothing without a folder.
std::optional<fs::path> pathOf(const std::string& fileName, const std::optional<fs::path>& folder) {
    return folder ? std::optional(*folder / fs::path(fileName).filename()) : std::nullopt;
}

[[noreturn]] void fail(const std::string& line) { throw SceneError({printable(line)}); }

}  // namespace

SceneError::SceneError(std::vector<std::string> lines)
    : std::runtime_error(joined(lines)), lines_(std::move(lines)) {}

SceneDescription readScene(std::string_view text, const std::string& fileName,
                           const std::string& sceneName, const std::vector<std::string>& overrides,
                           const std::optional<fs::path>& folder) {
    Complaints complaints(overrides);
    if (text.size() > kMostSceneBytes) fail(fileName + ": larger than 8 MiB");
    Document document = readDocument(text, fileName, pathOf(fileName, folder), complaints);
    if (complaints.count() > 0) throw SceneError(complaints.lines());
    const std::vector<ItemOverride> later =
        applyOverrides(overrides, document.table, complaints);
    Expressions expressions;
    const Scope scope{&expressions, {}, nullptr};
    SceneDescription scene =
        describeScene(document.table, later, sceneName, folder, scope, complaints);
    if (complaints.count() > 0) throw SceneError(complaints.lines());
    scene.files.insert(scene.files.begin(), document.files.begin(), document.files.end());
    for (Section& section : scene.sections) section.file = complaints.fileOf(section.place);
    return scene;
}

std::vector<std::string> catalogScene(std::string_view text, const std::string& name,
                                      Catalog& catalog) {
    Complaints complaints;
    const Document document = readDocument(text, name, std::nullopt, complaints);
    Expressions expressions;
    describeScene(document.table, {}, name, std::nullopt, {&expressions, {}, &catalog}, complaints);
    return complaints.lines();
}

std::string sceneNameOf(const fs::path& file) {
    const std::string name = file.stem().string();
    if (name == "." || name == "..")
        fail(file.string() + ": its name without the extension is '" + name +
             "', which is the name of a folder; rename it");
    return name;
}

std::string readSceneFile(const fs::path& path, const char* what, std::uintmax_t most) {
    const std::string name = path.string();
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found) fail(name + ": there is no such file");
    if (status.type() == fs::file_type::directory)
        fail(name + ": is a directory; it should be " + what);
    // Opening a FIFO blocks and /dev/zero never ends, so only regular files are opened.
    if (status.type() != fs::file_type::regular)
        fail(name + ": is not a regular file; it should be " + what);
    const std::uintmax_t size = fs::file_size(path, error);
    if (error) fail(name + ": cannot be read: " + error.message());
    if (size > most)
        fail(name + ": is " + std::to_string(size) + " bytes; it should be at most " +
             std::to_string(most >> 20) + " MiB");
    std::ifstream file(path, std::ios::binary);
    std::string text(static_cast<std::size_t>(size), '\0');
    file.read(text.data(), static_cast<std::streamsize>(size));
    if (!file || file.gcount() != static_cast<std::streamsize>(size))
        fail(name + ": cannot be read; check its permissions");
    return text;
}

}  // namespace demos
