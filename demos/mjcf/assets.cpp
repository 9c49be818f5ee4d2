#include "demos/mjcf/assets.h"

#include <cmath>

#include "demos/mjcf/hulls.h"
#include "demos/mjcf/mesh_file.h"
#include "demos/scene/reader.h"

namespace demos::mjcf {
namespace {

namespace fs = std::filesystem;

constexpr Range kCoordinates{-1e6, 1e6};
constexpr std::size_t kMostNumbers = 3'000'000;
constexpr double kFlat = 1e-6;         // sine of a triangle's angle: flatter ones are left out
constexpr double kLeastCross = 1e-11;  // m^2, twice an area: smaller is left out
constexpr double kLargest = 1e4, kLeast = 1e-5;  // m

class MeshReader {
public:
    MeshReader(Attributes attributes, const Rules& rules, const fs::path& folder,
               const FileReader& read)
        : attributes_(std::move(attributes)), rules_(rules), folder_(folder), read_(read) {}

    std::string name() const {
        if (attributes_.has("name")) return attributes_.text("name");
        return fs::path(attributes_.text("file")).stem().string();
    }

    std::optional<MeshShapes> read() {
        MeshCorners mesh = attributes_.has("vertex") ? inlineMesh() : fileMesh();
        std::vector<Vec3>& corners = mesh.corners;
        if (corners.empty()) return std::nullopt;
        place(corners);
        Vec3 low = corners.front(), high = low;
        for (const Vec3& corner : corners) low = low.cwiseMin(corner), high = high.cwiseMax(corner);
        const double size = (high - low).maxCoeff();
        const bool near =
            low.cwiseAbs().maxCoeff() < kLargest && high.cwiseAbs().maxCoeff() < kLargest;
        std::optional<engine::Shape> hull;
        if (size > kLeast && near) hull = hullOfAny(corners);
        if (!hull)
            attributes_.wrong("", "mesh '" + name() +
                                      "' has no convex hull; its corners should not lie in one "
                                      "plane and should be within 10000 m of its origin");
        if (!hull) return std::nullopt;
        return MeshShapes{*hull, pictureOf(mesh, hull->origin)};
    }

private:
    MeshCorners inlineMesh() {
        const auto numbers = attributes_.numbers("vertex", 12, kMostNumbers, kCoordinates);
        if (!numbers) return {};
        if (numbers->size() % 3 != 0) {
            attributes_.wrong("vertex", "vertex has " + std::to_string(numbers->size()) +
                                            " numbers; it should be three for each corner");
            return {};
        }
        std::vector<Vec3> corners;
        for (std::size_t i = 0; i < numbers->size(); i += 3)
            corners.push_back({(*numbers)[i], (*numbers)[i + 1], (*numbers)[i + 2]});
        std::vector<std::array<int, 3>> faces = inlineFaces(corners.size());
        return {std::move(corners), std::move(faces), ""};
    }

    std::vector<std::array<int, 3>> inlineFaces(std::size_t corners) {
        const auto numbers =
            attributes_.numbers("face", 3, kMostNumbers, {0.0, static_cast<double>(corners) - 1.0});
        std::vector<std::array<int, 3>> faces;
        for (std::size_t i = 0; numbers && i + 3 <= numbers->size(); i += 3)  // whole ones
            faces.push_back({static_cast<int>((*numbers)[i]), static_cast<int>((*numbers)[i + 1]),
                             static_cast<int>((*numbers)[i + 2])});
        return faces;
    }

    MeshCorners fileMesh() {
        const std::string file = attributes_.text("file");
        if (file.empty() || fs::path(file).is_absolute()) {
            attributes_.wrong("file",
                              "a <mesh> should have vertex, or a file in the model's folder");
            return {};
        }
        std::string wrong;
        try {
            const fs::path path = (folder_ / rules_.meshFolder / file).lexically_normal();
            MeshCorners mesh = readMeshFile(file, read_(path));
            if (mesh.wrong.empty()) return mesh;
            wrong = shown(file) + ": " + mesh.wrong;
        } catch (const SceneError& error) {
            wrong = error.what();
        }
        attributes_.wrong("file", wrong);
        return {};
    }

    /// Scales, transforms to the frame of refpos and refquat, then to y up.
    void place(std::vector<Vec3>& corners) {
        const Vec3 scale = attributes_.vector("scale", kCoordinates).value_or(Vec3(1, 1, 1));
        const Vec3 from = attributes_.vector("refpos", kCoordinates).value_or(Vec3(0, 0, 0));
        const auto q = attributes_.numbers("refquat", 4, 4, kCoordinates);
        Quat turn = q ? Quat((*q)[0], (*q)[1], (*q)[2], (*q)[3]) : Quat::Identity();
        if (turn.norm() < 1e-9) {
            attributes_.wrong("refquat", "refquat is 0 0 0 0; it should be a rotation");
            turn = Quat::Identity();
        }
        turn.normalize();
        for (Vec3& corner : corners)
            corner = yUp(Vec3(turn.conjugate() * (corner.cwiseProduct(scale) - from)));
    }

    /// Nothing if no triangle has an area. A mirrored mesh keeps its outside.
    std::optional<engine::Shape> pictureOf(MeshCorners& mesh, const Vec3& origin) {
        const Vec3 scale = attributes_.vector("scale", kCoordinates).value_or(Vec3(1, 1, 1));
        if (scale.prod() < 0.0)
            for (std::array<int, 3>& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
        const auto corner = [&](int i) { return mesh.corners[static_cast<std::size_t>(i)]; };
        std::erase_if(mesh.triangles, [&](const std::array<int, 3>& t) {
            const Vec3 a = corner(t[1]) - corner(t[0]), b = corner(t[2]) - corner(t[0]);
            return a.cross(b).norm() <= engine::larger(kFlat * a.norm() * b.norm(), kLeastCross);
        });
        if (mesh.triangles.empty()) return std::nullopt;
        for (Vec3& point : mesh.corners) point += origin;
        return engine::Shape::meshOf(mesh.corners, mesh.triangles);
    }

    Attributes attributes_;
    const Rules& rules_;
    const fs::path& folder_;
    const FileReader& read_;
};

void readAsset(const Element& element, const Defaults& defaults, const Rules& rules,
               const fs::path& folder, const FileReader& read, Diagnostics& diagnostics,
               Assets& assets) {
    if (element.name == "material") {
        Attributes attributes = defaults.of(element, "");
        assets.colors[attributes.text("name")] = readColor(attributes);
    } else if (element.name == "mesh") {
        MeshReader reader(defaults.of(element, ""), rules, folder, read);
        if (!assets.meshes.emplace(reader.name(), reader.read()).second)
            diagnostics.wrong(element.spot,
                              "two meshes are called '" + reader.name() + "'; rename one");
    }
}

}  // namespace

std::optional<unsigned> readColor(Attributes& attributes) {
    const auto rgba = attributes.numbers("rgba", 4, 4, {0.0, 1.0});
    if (!rgba) return std::nullopt;
    unsigned color = 0;
    for (std::size_t i = 0; i < 3; ++i)
        color = color << 8 | static_cast<unsigned>(std::lround(255.0 * (*rgba)[i]));
    return color;
}

Assets readAssets(const Element& root, const Defaults& defaults, const Rules& rules,
                  const fs::path& folder, const FileReader& read, Diagnostics& diagnostics) {
    Assets assets;
    for (const Element& section : root.children) {
        if (section.name != "asset") continue;
        for (const Element& element : section.children)
            readAsset(element, defaults, rules, folder, read, diagnostics, assets);
    }
    return assets;
}

}  // namespace demos::mjcf
