#include "demos/mjcf/mesh_file.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>

#include "demos/scene/mesh_file.h"

namespace demos::mjcf {
namespace {

constexpr double kFarthest = 1e6;  // in the file's own unit

bool isUsable(const Vec3& corner) {
    return corner.allFinite() && corner.cwiseAbs().maxCoeff() <= kFarthest;
}

std::string_view lineOff(std::string_view& text) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

/// Takes a line and those that a backslash at its end joins to it; `number` counts them.
std::string wholeLineOff(std::string_view& text, int& number) {
    std::string line(lineOff(text));
    for (++number; line.ends_with('\\') && !line.starts_with('#') && !text.empty(); ++number) {
        line.back() = ' ';
        line += lineOff(text);
    }
    return line;
}

/// Three numbers, or an unusable corner.
Vec3 cornerIn(std::string_view text) {
    Vec3 corner(0, 0, 0);
    for (double& x : corner) {
        text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
        const std::from_chars_result read =
            std::from_chars(text.data(), text.data() + text.size(), x);
        if (read.ec != std::errc()) return Vec3::Constant(2.0 * kFarthest);
        text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
    }
    return corner;
}

/// The triangles; none if the faces are invalid or missing, in which case only the hull is drawn.
std::vector<std::array<int, 3>> facesOf(const std::string& text, std::size_t corners) {
    try {
        TriangleMesh mesh = objMesh(text);
        if (mesh.corners.size() == corners) return std::move(mesh.triangles);
    } catch (const MeshFileError&) {
    }
    return {};
}

MeshCorners readObj(std::string_view text) {
    const std::string_view whole = text;
    MeshCorners mesh;
    for (int read = 0; !text.empty();) {
        const int line = read + 1;
        const std::string words = wholeLineOff(text, read);
        if (!words.starts_with("v ") && !words.starts_with("v\t")) continue;
        mesh.corners.push_back(cornerIn(std::string_view(words).substr(2)));
        if (isUsable(mesh.corners.back())) continue;
        mesh.wrong = "line " + std::to_string(line) + " should be 'v' and three numbers";
        return mesh;
    }
    if (mesh.wrong.empty()) mesh.triangles = facesOf(std::string(whole), mesh.corners.size());
    if (mesh.corners.empty()) mesh.wrong = "it has no corners; an OBJ file has lines 'v x y z'";
    return mesh;
}

std::uint32_t wordAt(std::string_view bytes, std::size_t at) {
    std::uint32_t word = 0;  // little-endian, by the format
    for (std::size_t i = 0; i < 4; ++i)
        word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    return word;
}

/// 80 arbitrary bytes, the number of triangles, then 50 bytes for each: normal, three corners, two
/// more bytes.
MeshCorners readStl(std::string_view bytes) {
    constexpr std::size_t kHead = 84, kTriangle = 50;
    MeshCorners mesh;
    const std::size_t count = bytes.size() >= kHead ? wordAt(bytes, 80) : 0;
    if (count == 0 || bytes.size() != kHead + kTriangle * count) {
        mesh.wrong = "its size is not that of a binary STL file of " + std::to_string(count) +
                     " triangles; ASCII STL is not supported";
        return mesh;
    }
    for (int i = 0; i < static_cast<int>(count); ++i)
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    for (std::size_t i = 0; i < 3 * count; ++i) {
        Vec3 corner;
        for (std::size_t k = 0; k < 3; ++k)
            corner[static_cast<int>(k)] = static_cast<double>(std::bit_cast<float>(
                wordAt(bytes, kHead + kTriangle * (i / 3) + 12 + 12 * (i % 3) + 4 * k)));
        mesh.corners.push_back(corner);
        if (isUsable(corner)) continue;
        mesh.wrong = "triangle " + std::to_string(i / 3 + 1) +
                     " has a corner that is beyond 1000000 or not finite";
        return mesh;
    }
    return mesh;
}

}  // namespace

MeshCorners readMeshFile(const std::string& name, std::string_view bytes) {
    std::string ending = std::filesystem::path(name).extension().string();
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (ending == ".obj") return readObj(bytes);
    if (ending == ".stl") return readStl(bytes);
    return {{}, {}, "its format is not supported; it should be OBJ or binary STL"};
}

}  // namespace demos::mjcf
