/// Triangles from files beside a scene: Wavefront OBJ and glTF 2.0.
#pragma once
#include <array>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "demos/scene/read_shape.h"

namespace demos {

inline constexpr std::size_t kMostTriangles = 1'000'000;

struct TriangleMesh {
    std::vector<engine::Vec3> corners;          // as the file has them
    std::vector<std::array<int, 3>> triangles;  // each number is that of a corner
    std::vector<std::string> buffers = {};      // files that were read besides the mesh's own
};

/// What is wrong with a file, and what would be right.
class MeshFileError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// By the file's ending: .obj, .gltf or .glb. Throws MeshFileError.
TriangleMesh readMeshFile(const std::filesystem::path& path);

/// A regular file of at most 64 MiB. Throws MeshFileError.
std::string readWholeFile(const std::filesystem::path& path);

/// Faces become triangles; everything but corners and faces is left out. (obj_file.cpp)
TriangleMesh objMesh(const std::string& text);

/// The triangles of the scene that the file shows, placed by its nodes. `folder`: of its buffers.
/// (gltf_file.cpp)
TriangleMesh gltfMesh(const std::string& text, const std::filesystem::path& folder);
/// The same in one binary file: its chunks are the text and the first buffer.
TriangleMesh glbMesh(const std::string& bytes, const std::filesystem::path& folder);

/// The shape that `make` makes of the file's triangles once they are scaled and turned, which is
/// given the file's name for its complaints; one that was made before is taken again.
std::optional<engine::Shape> readShapeFile(
    Keys& keys, const char* key, const Placing& placing, ShapeFiles& files,
    const std::function<std::optional<engine::Shape>(const std::string&, const TriangleMesh&)>&
        make);

}  // namespace demos
