#include "demos/scene/mesh_file.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <span>
#include <system_error>

namespace demos {

namespace fs = std::filesystem;

std::string readWholeFile(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found) throw MeshFileError("there is no such file");
    // Opening a FIFO blocks and /dev/zero never ends, so only regular files are opened.
    if (status.type() != fs::file_type::regular)
        throw MeshFileError("is not a regular file; it should be one");
    const std::uintmax_t size = fs::file_size(path, error);
    if (error) throw MeshFileError("cannot be read: " + error.message());
    if (size > kMostMeshBytes)
        throw MeshFileError("is " + std::to_string(size) + " bytes; it should be at most 64 MiB");
    std::ifstream file(path, std::ios::binary);
    std::string bytes(static_cast<std::size_t>(size), '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(size));
    if (!file || file.gcount() != static_cast<std::streamsize>(size))
        throw MeshFileError("cannot be read; check its permissions");
    return bytes;
}

TriangleMesh readMeshFile(const fs::path& path) {
    const std::string ending = path.extension().string();
    if (ending == ".obj") return objMesh(readWholeFile(path));
    if (ending == ".gltf") return gltfMesh(readWholeFile(path), path.parent_path());
    if (ending == ".glb") return glbMesh(readWholeFile(path), path.parent_path());
    throw MeshFileError("its name ends in '" + shown(ending) +
                        "'; it should end in .obj, .gltf or .glb");
}

namespace {

/// The key of a shape from a file: equal for equal shapes.
std::string nameOf(const char* key, const fs::path& path, const Placing& placing) {
    std::string name = key + ("\n" + path.string());
    for (int k = 0; k < 3; ++k) name += "\n" + numberText(placing.scale[k]);
    for (int k = 0; k < 4; ++k) name += "\n" + numberText(placing.turn.coeffs()[k]);
    return name;
}

template <class Item>
std::span<const std::uint8_t> bytesOf(const std::vector<Item>& items) {
    return {reinterpret_cast<const std::uint8_t*>(items.data()), items.size() * sizeof(Item)};
}

void checkTriangles(const ShapeFiles& files) {
    if (files.triangles > kMostTrianglesInAll)
        throw MeshFileError("with it, the shapes have more than 4 million triangles, or 16 million points; use "
                            "simpler ones, and fewer scales");
}

/// Adds each path once: a file may be read for several shapes.
void notePaths(const fs::path& path, const TriangleMesh& mesh, std::vector<std::string>& paths) {
    std::vector<std::string> read = mesh.buffers;
    read.insert(read.begin(), path.string());
    for (std::string& one : read)
        if (std::find(paths.begin(), paths.end(), one) == paths.end())
            paths.push_back(std::move(one));
}

}  // namespace

std::optional<engine::Shape> readShapeFile(
    Keys& keys, const char* key, const Placing& placing, ShapeFiles& files,
    const std::function<std::optional<engine::Shape>(const std::string&, const TriangleMesh&)>&
        make) {
    const std::optional<std::string> file = keys.text(key);
    if (!file) return std::nullopt;
    if (!files.folder) {
        keys.complain(key, "'" + shown(*file) +
                               "' cannot be read, because the scene itself is not in a "
                               "file; write the points instead");
        return std::nullopt;
    }
    if (file->empty()) {
        keys.complain(key, std::string(key) +
                               " is an empty text; it should be a file name, like \"rock.obj\"");
        return std::nullopt;
    }
    const fs::path path = *files.folder / *file;
    const std::string name = nameOf(key, path, placing);
    if (const auto known = files.known.find(name); known != files.known.end()) return known->second;
    try {
        std::error_code ignored;
        const std::uintmax_t size = fs::file_size(path, ignored);
        if (!ignored && (files.bytes += size) > kMostShapeBytes)
            throw MeshFileError("with it, more than 256 MiB of shapes are read; use fewer files "
                                "and scales");
        checkTriangles(files);  // of those before
        TriangleMesh mesh = readMeshFile(path);
        files.triangles += mesh.triangles.size() + mesh.corners.size() / 4;
        checkTriangles(files);
        files.contents.add(bytesOf(mesh.corners));
        files.contents.add(bytesOf(mesh.triangles));
        notePaths(path, mesh, files.paths);
        if (!placePoints(keys, key, *file, placing, mesh.corners)) return std::nullopt;
        const std::optional<engine::Shape> shape = make(*file, mesh);
        if (shape) files.known.emplace(name, *shape);
        return shape;
    } catch (const MeshFileError& error) {
        keys.complain(key, shown(*file) + ": " + error.what());
        return std::nullopt;
    }
}

}  // namespace demos
