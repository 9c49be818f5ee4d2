// Arbitrary bytes for every reader of files other than scenes and models; IMPULSE_FUZZ_READER names
// it. What is refused is refused in one printable line; what is accepted is within the limits, and
// what can be written is read again as the same.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "demos/film/run_record.h"
#include "demos/formulas/formula.h"
#include "demos/gallery/gallery_record.h"
#include "demos/load/builtin.h"
#include "demos/mjcf/mesh_file.h"
#include "demos/regression/baseline.h"
#include "demos/regression/pass_cache.h"
#include "demos/regression/trajectory_codec.h"
#include "demos/regression/verdict_json.h"
#include "demos/scene/mesh_file.h"
#include "demos/scene/reader.h"
#include "demos/slides/markup.h"
#include "demos/slides/numbers.h"
#include "demos/slides/read_deck.h"
#include "demos/slides/sections_json.h"
#include "demos/text/complaints.h"
#include "demos/text/deflate.h"
#include "demos/text/hex_text.h"
#include "demos/text/stop.h"
#include "demos/text/text_hash.h"
#include "render/encode/file.h"
#include "render/encode/png.h"
#include "render/encode/png_read.h"
#include "render/error.h"
#include "tests/fuzz/png_of_bytes.h"

namespace demos {

/// For decks; small, so that a run of the fuzzer is not mostly this scene's.
std::span<const BuiltinScene> builtinScenes() {
    static constexpr BuiltinScene kBall{
        "ball", "format = 1\nseconds = 1\n[[body]]\nname = \"ball\"\nshape = { sphere = 1 }\n"};
    return {&kBall, 1};
}

}  // namespace demos

namespace {

namespace fs = std::filesystem;
using Bytes = std::span<const std::uint8_t>;
using Json = nlohmann::ordered_json;

void require(bool truth, const char* what, std::string_view value = {}) {
    if (truth) return;
    std::fprintf(stderr, "%s: %.*s\n", what, static_cast<int>(value.size()), value.data());
    std::abort();
}

std::string textOf(Bytes bytes) { return {bytes.begin(), bytes.end()}; }

void checkLine(const std::string& line) {
    require(!line.empty(), "refused without a message");
    require(line.find('\n') == std::string::npos, "a message of several lines", line);
    require(line.size() <= demos::kLongestMessage, "a long message", line);
    require(demos::printable(line) == line, "a byte that does not print", line);
}

template <class Vector>
void checkTriangles(const std::vector<Vector>& corners,
                    const std::vector<std::array<int, 3>>& triangles) {
    require(corners.size() <= demos::kMostMeshCorners, "too many corners");
    require(triangles.size() <= demos::kMostTriangles, "too many triangles");
    for (const std::array<int, 3>& triangle : triangles)
        for (const int corner : triangle)
            require(corner >= 0 && corner < static_cast<int>(corners.size()), "no such corner");
}

/// `read`: from the text, to a mesh or a MeshFileError.
template <class Read>
void checkMesh(Bytes bytes, Read read) {
    try {
        const demos::TriangleMesh mesh = read(textOf(bytes));
        checkTriangles(mesh.corners, mesh.triangles);
    } catch (const demos::MeshFileError& error) {  // whoever reports it makes it printable
        checkLine(demos::printable(error.what()));
    }
}

const char* const kNoFolder = "/nonexistent";  // a glTF's buffers can only be within it

void obj(Bytes bytes) { checkMesh(bytes, demos::objMesh); }
void gltf(Bytes bytes) {
    checkMesh(bytes, [](const std::string& text) { return demos::gltfMesh(text, kNoFolder); });
}
void glb(Bytes bytes) {
    checkMesh(bytes, [](const std::string& text) { return demos::glbMesh(text, kNoFolder); });
}

void stl(Bytes bytes) {
    const demos::mjcf::MeshCorners mesh = demos::mjcf::readMeshFile("a.stl", textOf(bytes));
    if (!mesh.wrong.empty()) return checkLine(mesh.wrong);
    for (const auto& corner : mesh.corners) require(corner.allFinite(), "a corner is not finite");
    checkTriangles(mesh.corners, mesh.triangles);
}

/// A small picture only: a large one is refused by its size before there is room for it.
void decode(Bytes bytes) {
    constexpr int kMostSide = 512;
    const auto [width, height] = fuzz::sizeOfPng(bytes);
    const bool small = width > 0 && height > 0 && width <= kMostSide && height <= kMostSide;
    try {
        const render::Image image =
            render::decodePng(bytes, small ? width : 1, small ? height : 1);
        require(image.width == width && image.height == height, "another size");
        require(image.pixels.size() == std::size_t(4) * width * height, "pixels are missing");
    } catch (const render::Error& error) {
        checkLine(error.what());
    }
    (void)render::pngIsWhole(bytes, width, height);
}

void png(Bytes bytes) {
    decode(bytes);
    decode(fuzz::withChecksums(bytes));
    decode(fuzz::pngOfRows(bytes));
}

void deck(Bytes bytes) {
    try {
        demos::readDeck(textOf(bytes), "a.toml");
    } catch (const demos::SceneError& error) {
        require(!error.lines().empty(), "refused without a message");
        for (const std::string& line : error.lines())
            require(demos::printable(line) == line, "a byte that does not print", line);
    }
}

/// A formula's error has its place in the text.
template <class Make>
std::string made(const std::string& text, Make make) {
    try {
        return make(text);
    } catch (const demos::FormulaError& error) {
        require(error.at() <= text.size(), "a place behind the text", text);
        return {};
    }
}

void checkHtml(const std::string& html) {
    for (const char* word : {"<script", "<img", "<iframe", "<style", "href=\"javascript:"})
        require(html.find(word) == std::string::npos, "markup that was not asked for", html);
}

void words(Bytes bytes) {
    const std::string text = textOf(bytes);
    try {
        (void)demos::numberedText(text);
    } catch (const demos::NumberError& error) {
        require(error.at() < text.size(), "a place behind the text", text);
    }
    checkHtml(made(text, demos::htmlOf));
    checkHtml(made(text, demos::htmlInlineOf));
    for (const auto make : {demos::latexOf, demos::latexInlineOf, demos::markdownOf,
                            demos::markdownInlineOf, demos::plainOf, demos::titleTextOf})
        (void)made(text, make);
}

void formula(Bytes bytes) {
    const std::string text = textOf(bytes.first(std::min(bytes.size(), demos::kLongestFormula)));
    const std::string math =
        made(text, [](const std::string& tex) { return demos::mathMlOf(tex, true); });
    require(math.empty() || math.starts_with("<math"), "no formula", math);
    checkHtml(math);
    (void)demos::latexFormulaOf(text, false);
}

/// What is accepted is written and read as the same.
void checkBaseline(const std::string& text) {
    try {
        const demos::Baseline baseline = demos::baselineFrom(text, "baseline.json");
        const std::string again = demos::jsonOf(baseline, demos::Tolerance{});
        require(demos::jsonOf(demos::baselineFrom(again, "baseline.json"), demos::Tolerance{}) ==
                    again,
                "it does not stay the same", text);
    } catch (const demos::BaselineError& error) {
        checkLine(error.what());
    }
}

void baseline(Bytes bytes) {
    const std::string text = textOf(bytes);
    checkBaseline(text);
    Json json = text.size() > 4096 ? Json() : Json::parse(text, nullptr, false);
    if (!json.is_object()) return;
    json.erase("seal");  // so that more than the seal is read
    json["seal"] =
        demos::hexText(demos::hashOf(json.dump(1, ' ', false, Json::error_handler_t::replace)));
    checkBaseline(json.dump());
}

void checkTrajectory(Bytes packed) {
    const std::optional<demos::Trajectory> trajectory = demos::decodeTrajectory(packed);
    if (!trajectory) return;
    for (const demos::TrajectoryMoment& moment : trajectory->moments)
        require(moment.poses.size() == trajectory->bodies.size(), "a body has no pose");
    (void)demos::thinned(*trajectory, 1);
}

void trajectory(Bytes bytes) {
    checkTrajectory(bytes);
    checkTrajectory(demos::deflated(bytes));
}

void runRecord(Bytes bytes) {
    const std::optional<demos::RunRecord> record = demos::recordFromJson(textOf(bytes));
    if (!record) return;
    const std::string again = demos::jsonOf(*record);
    const auto same = demos::recordFromJson(again);
    require(same && demos::jsonOf(*same) == again, "it does not stay the same", again);
}

void report(Bytes bytes) {
    try {
        const std::string again =
            demos::jsonOf(demos::testVerdictFrom(textOf(bytes), "report.json"));
        require(demos::jsonOf(demos::testVerdictFrom(again, "report.json")) == again,
                "it does not stay the same", again);
    } catch (const demos::Stop& stop) {
        checkLine(stop.what());
    }
}

/// A folder in memory for the readers that open their files themselves.
const fs::path& ownFolder() {
    static const fs::path folder = [] {
        std::string name = "/dev/shm/impulse-fuzz-XXXXXX";
        require(mkdtemp(name.data()) != nullptr, "cannot make a folder", name);
        return fs::path(name);
    }();
    return folder;
}

void gallery(Bytes bytes) {
    render::writeFrameFile(ownFolder() / "gallery.json", bytes);
    const demos::GalleryRecord record(ownFolder());
    require(record.found() || !record.owns("ball"), "a file that is not ours");
}

void sections(Bytes bytes) {
    render::writeFrameFile(ownFolder() / "sections.json", bytes);
    for (const fs::path& file : demos::listedFiles(ownFolder())) {
        require(file.is_relative() && !file.empty(), "a place elsewhere", file.string());
        for (const fs::path& part : file) require(part != "..", "a place elsewhere", file.string());
    }
}

void passed(Bytes bytes) {
    const fs::path file = ownFolder() / "passed.json";
    render::writeFrameFile(file, bytes);
    demos::PassCache cache(file);
    cache.add("ball", 1);
    cache.write();
    require(demos::PassCache(file).has("ball", 1), "it does not stay the same");
}

using Reader = void (*)(Bytes);
Reader readerCalled(const char* name) {
    static const std::map<std::string_view, Reader> readers = {
        {"obj", obj},           {"stl", stl},         {"gltf", gltf},       {"glb", glb},
        {"png", png},           {"deck", deck},       {"words", words},     {"formula", formula},
        {"baseline", baseline}, {"trajectory", trajectory}, {"run", runRecord}, {"report", report},
        {"gallery", gallery},   {"sections", sections}, {"passed", passed}};
    const auto found = readers.find(name ? name : "");
    require(found != readers.end(), "IMPULSE_FUZZ_READER is no reader", name ? name : "");
    return found->second;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static const Reader read = readerCalled(std::getenv("IMPULSE_FUZZ_READER"));
    read({bytes, size});
    return 0;
}
