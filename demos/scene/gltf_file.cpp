// glTF 2.0: the triangles of the file's default scene. Materials, normals and the like are ignored;
// an unsupported feature that would change the triangles is an error.
#include <utility>

#include "demos/scene/gltf_buffers.h"
#include "demos/scene/mesh_file.h"
#include "demos/text/json_limits.h"

namespace demos {
namespace {

using engine::Mat3;
using engine::Vec3;

/// p -> linear p + shift
struct Affine {
    Mat3 linear = Mat3::Identity();
    Vec3 shift = Vec3::Zero();

    Affine operator*(const Affine& inner) const {
        return {linear * inner.linear, linear * inner.shift + shift};
    }
};

/// The numbers of node[key]; nothing if it is missing.
std::optional<std::vector<double>> numbersOf(const GltfJson& node, const char* key,
                                             std::size_t count) {
    const auto found = node.find(key);
    if (found == node.end()) return std::nullopt;
    std::vector<double> numbers;
    if (found->is_array())
        for (const GltfJson& number : *found)
            if (number.is_number()) numbers.push_back(number.get<double>());
    if (numbers.size() == count && found->size() == count) return numbers;
    throw MeshFileError(std::string("a node's ") + key + " should be " + std::to_string(count) +
                        " numbers");
}

Affine placeOf(const GltfJson& node) {
    Affine place;
    if (const auto m = numbersOf(node, "matrix", 16)) {  // by columns
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 4; ++column)
                (column < 3 ? place.linear(row, column) : place.shift[row]) =
                    (*m)[static_cast<std::size_t>(4 * column + row)];
        return place;
    }
    if (const auto q = numbersOf(node, "rotation", 4)) {  // x, y, z, w
        const engine::Quat turn((*q)[3], (*q)[0], (*q)[1], (*q)[2]);
        if (!(turn.norm() > 1e-6))
            throw MeshFileError("a node's rotation should be a quaternion, not all zero");
        place.linear = turn.normalized().toRotationMatrix();
    }
    if (const auto s = numbersOf(node, "scale", 3))
        place.linear = place.linear * Mat3(Vec3((*s)[0], (*s)[1], (*s)[2]).asDiagonal());
    if (const auto t = numbersOf(node, "translation", 3)) place.shift = {(*t)[0], (*t)[1], (*t)[2]};
    return place;
}

class GltfScene {
public:
    GltfScene(const GltfJson& file, GltfBuffers buffers)
        : file_(file), buffers_(std::move(buffers)) {}

    TriangleMesh read() {
        const GltfJson& scene = itemOf(file_, "scenes", wholeOf(file_, "scene", 0));
        takeChildren(scene, "nodes", {});
        std::vector<bool> seen;
        while (!waiting_.empty()) {  // no recursion: a chain of nodes may be long
            const auto [number, outer] = waiting_.back();
            waiting_.pop_back();
            const GltfJson& node = itemOf(file_, "nodes", number);
            seen.resize(std::max(seen.size(), number + 1));
            if (seen[number])
                throw MeshFileError("node " + std::to_string(number) +
                                    " is a child of two nodes, or of itself");
            seen[number] = true;
            if (node.contains("skin")) throw MeshFileError("skins are not supported; bake them");
            const Affine place = outer * placeOf(node);
            if (node.contains("mesh")) takeMesh(wholeOf(node, "mesh", std::nullopt), place);
            takeChildren(node, "children", place);
        }
        mesh_.buffers = buffers_.paths();
        return std::move(mesh_);
    }

private:
    void takeChildren(const GltfJson& parent, const char* key, const Affine& place) {
        const auto list = parent.find(key);
        if (list == parent.end()) return;
        if (!list->is_array()) throw MeshFileError(std::string(key) + " should be a list");
        for (std::size_t i = list->size(); i-- > 0;) {
            const GltfJson& number = (*list)[i];
            if (!number.is_number_unsigned() || number.get<std::uint64_t>() > 0x7fffffff)
                throw MeshFileError(std::string(key) + " should be numbers of nodes");
            waiting_.emplace_back(number.get<std::size_t>(), place);
        }
    }

    void takeMesh(std::size_t number, const Affine& place) {
        const GltfJson& mesh = itemOf(file_, "meshes", number);
        const auto parts = mesh.find("primitives");
        if (parts == mesh.end() || !parts->is_array())
            throw MeshFileError("mesh " + std::to_string(number) + " has no primitives");
        for (const GltfJson& part : *parts) takePart(part, place);
    }

    void takePart(const GltfJson& part, const Affine& place) {
        constexpr std::size_t kTriangles = 4;
        if (!part.is_object()) throw MeshFileError("a primitive should be a table");
        // A node is one of many that may show a mesh of many primitives.
        if (++parts_ > kMostTriangles) throw MeshFileError("more than a million primitives");
        const std::size_t mode = wholeOf(part, "mode", kTriangles);
        if (mode != kTriangles)
            throw MeshFileError("a primitive of mode " + std::to_string(mode) +
                                " is not supported; it should be 4, triangles");
        if (part.contains("targets"))
            throw MeshFileError("morph targets are not supported; bake them");
        const auto attributes = part.find("attributes");
        if (attributes == part.end() || !attributes->is_object() ||
            !attributes->contains("POSITION"))
            throw MeshFileError("a primitive has no POSITION");
        const auto points = buffers_.positions(wholeOf(*attributes, "POSITION", std::nullopt));
        std::vector<std::uint32_t> numbers;
        if (part.contains("indices"))
            numbers = buffers_.numbers(wholeOf(part, "indices", std::nullopt));
        else
            for (std::uint32_t i = 0; i < points.size(); ++i) numbers.push_back(i);
        addTriangles(points, numbers, place);
    }

    void addTriangles(const std::vector<Vec3>& points, const std::vector<std::uint32_t>& numbers,
                      const Affine& place) {
        if (numbers.size() % 3 != 0)
            throw MeshFileError(std::to_string(numbers.size()) +
                                " indices do not make triangles; a triangle should have three");
        if (mesh_.triangles.size() + numbers.size() / 3 > kMostTriangles ||
            mesh_.corners.size() + points.size() > kMostMeshCorners)
            throw MeshFileError("more than a million triangles");
        const int first = static_cast<int>(mesh_.corners.size());
        for (const Vec3& point : points)
            mesh_.corners.push_back(place.linear * point + place.shift);
        const bool mirrored = place.linear.determinant() < 0.0;  // reverses the orientation
        for (std::size_t i = 0; i < numbers.size(); i += 3) {
            std::array<int, 3> triangle{};
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t number = numbers[i + k];
                if (number >= points.size())
                    throw MeshFileError("index " + std::to_string(number) +
                                        " is not a corner of its primitive; it should be below " +
                                        std::to_string(points.size()));
                triangle[k] = first + static_cast<int>(number);
            }
            if (mirrored) std::swap(triangle[1], triangle[2]);
            mesh_.triangles.push_back(triangle);
        }
    }

    const GltfJson& file_;
    GltfBuffers buffers_;
    std::vector<std::pair<std::size_t, Affine>> waiting_;
    std::size_t parts_ = 0;
    TriangleMesh mesh_;
};

/// The little-endian word in the four bytes at `at`, which have to exist.
std::uint32_t wordAt(const std::string& bytes, std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i)
        word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    return word;
}

/// The contents of the chunk that begins at `at`, if it is of this type.
std::optional<std::string> chunkAt(const std::string& bytes, std::size_t at, std::uint32_t type) {
    if (at + 8 > bytes.size() || wordAt(bytes, at + 4) != type) return std::nullopt;
    const std::size_t length = wordAt(bytes, at);
    if (length > bytes.size() - at - 8)
        throw MeshFileError("is cut off: a chunk of " + std::to_string(length) +
                            " bytes has only " + std::to_string(bytes.size() - at - 8) +
                            " left");
    return bytes.substr(at + 8, length);
}

/// An extension in a message. Only a text is a name; anything else may be long and deep.
std::string extensionName(const GltfJson& extension) {
    if (!extension.is_string()) return std::string("that is ") + extension.type_name();
    return "'" + shown(extension.get_ref<const std::string&>()) + "'";
}

TriangleMesh meshOf(const std::string& text, const std::filesystem::path& folder,
                    std::optional<std::string> chunk) {
    if (const std::string trouble = jsonTrouble(text, kGltfJson); !trouble.empty())
        throw MeshFileError(trouble);
    const GltfJson file = GltfJson::parse(text, nullptr, false);
    if (!file.is_object()) throw MeshFileError("is not JSON; it should be glTF 2.0");
    const auto asset = file.find("asset");
    const bool second = asset != file.end() && asset->is_object() && asset->contains("version") &&
                        (*asset)["version"] == "2.0";
    if (!second) throw MeshFileError("is not of version 2.0; it should be glTF 2.0");
    if (const auto needs = file.find("extensionsRequired");
        needs != file.end() && needs->is_array() && !needs->empty())
        throw MeshFileError("needs the extension " + extensionName((*needs)[0]) +
                            ", which is not supported; it should need none");
    return GltfScene(file, GltfBuffers(file, folder, std::move(chunk))).read();
}

}  // namespace

TriangleMesh gltfMesh(const std::string& text, const std::filesystem::path& folder) {
    return meshOf(text, folder, std::nullopt);
}

TriangleMesh glbMesh(const std::string& bytes, const std::filesystem::path& folder) {
    constexpr std::uint32_t kMagic = 0x46546c67, kText = 0x4e4f534a, kBinary = 0x004e4942;
    if (bytes.size() < 12 || wordAt(bytes, 0) != kMagic || wordAt(bytes, 4) != 2)
        throw MeshFileError("is not a binary glTF of version 2");
    const std::optional<std::string> text = chunkAt(bytes, 12, kText);
    if (!text) throw MeshFileError("has no JSON chunk; it should begin with one");
    return meshOf(*text, folder, chunkAt(bytes, 20 + text->size(), kBinary));
}

}  // namespace demos
