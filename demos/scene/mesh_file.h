/// Triangles from files that a scene names: Wavefront OBJ and glTF 2.0.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "demos/scene/read_shape.h"

namespace demos {

inline constexpr std::size_t kMostTriangles = 1'000'000;
inline constexpr std::size_t kMostMeshCorners = 3 * kMostTriangles;
/// Of a file, and of all buffers of a glTF file.
inline constexpr std::uintmax_t kMostMeshBytes = 64u << 20;

struct TriangleMesh {
    std::vector<engine::Vec3> corners;          // in the file's order
    std::vector<std::array<int, 3>> triangles;  // indices into `corners`
    std::vector<std::string> buffers = {};      // further files that were read
};

/// What is wrong with a file, and what would be right.
class MeshFileError : public std::runtime_error {
public:
    explicit MeshFileError(const std::string& what)
        : std::runtime_error(printable(what)) {}  // what() would end at a zero byte
};

/// The format follows from the file's extension: .obj, .gltf or .glb. Throws MeshFileError.
TriangleMesh readMeshFile(const std::filesystem::path& path);

/// The bytes of a regular file of at most 64 MiB. Throws MeshFileError.
std::string readWholeFile(const std::filesystem::path& path);

/// Splits faces into triangles and ignores everything but vertices and faces. (obj_file.cpp)
TriangleMesh objMesh(const std::string& text);

/// The triangles of the file's default scene, placed by its nodes. `folder`: that of its buffers.
/// (gltf_file.cpp)
TriangleMesh gltfMesh(const std::string& text, const std::filesystem::path& folder);
/// The same from one binary file, whose chunks are the text and the first buffer.
TriangleMesh glbMesh(const std::string& bytes, const std::filesystem::path& folder);

/// The shape that `make` builds from the scaled and rotated triangles of the file that `key` names;
/// a shape that was built before is reused. `make` gets the file's name for its messages.
std::optional<engine::Shape> readShapeFile(
    Keys& keys, const char* key, const Placing& placing, ShapeFiles& files,
    const std::function<std::optional<engine::Shape>(const std::string&, const TriangleMesh&)>&
        make);

}  // namespace demos
