// mesh = "file.glb", mesh = { points, triangles } and height_field = { ... }

#include <algorithm>

#include "demos/scene/mesh_file.h"
#include "demos/scene/ranges.h"
#include "demos/scene/read_shape.h"
#include "demos/scene/table_readers.h"
#include "engine/shapes/mesh.h"

namespace demos {
namespace {

using engine::Shape;

bool hasAnArea(const TriangleMesh& mesh) {
    return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
        const Vec3 &a = mesh.corners[t[0]], &b = mesh.corners[t[1]], &c = mesh.corners[t[2]];
        return (0.5 * (b - a).cross(c - a)).norm() >= engine::kLeastArea;
    });
}

std::optional<Shape> meshOf(Keys& keys, const std::string& of, const TriangleMesh& mesh) {
    if (mesh.triangles.empty())
        keys.complain("mesh", of + " has no triangles; it should have one or more");
    else if (mesh.triangles.size() > kMostTriangles)
        keys.complain("mesh", of + " has " + std::to_string(mesh.triangles.size()) +
                                  " triangles; it should have at most a million");
    else if (!hasAnArea(mesh))
        keys.complain("mesh", "no triangle of " + of +
                                  " has an area; at least one should have "
                                  "1e-12 m^2");
    else
        return Shape::meshOf(mesh.corners, mesh.triangles);
    return std::nullopt;
}

/// Three indices of corners, from 0.
std::optional<std::array<int, 3>> triangleOf(const Vec3& numbers, std::size_t corners) {
    std::array<int, 3> triangle{};
    for (int k = 0; k < 3; ++k) {
        if (numbers[k] >= static_cast<double>(corners)) return std::nullopt;
        triangle[static_cast<std::size_t>(k)] = static_cast<int>(numbers[k]);
        if (triangle[static_cast<std::size_t>(k)] != numbers[k]) return std::nullopt;
    }
    return triangle;
}

std::optional<TriangleMesh> readTriangles(Keys keys) {
    for (const char* key : {"points", "triangles"})
        if (!keys.has(key))
            keys.complain("", std::string("a mesh has no ") + key +
                                  "; write mesh = { points = [[0, 0, 0], ...], "
                                  "triangles = [[0, 1, 2], ...] } or mesh = \"file.obj\"");
    const auto points = keys.vectors("points", kMeters);
    const auto triangles = keys.vectors("triangles", {0.0, 1e6});
    keys.done();
    if (!points || !triangles) return std::nullopt;
    TriangleMesh mesh{*points, {}};
    for (std::size_t i = 0; i < triangles->size(); ++i) {
        const auto triangle = triangleOf((*triangles)[i], points->size());
        if (!triangle) {
            keys.complain("triangles", "triangle " + std::to_string(i) +
                                           " should be three whole numbers below " +
                                           std::to_string(points->size()) +
                                           ", the number of points, which count from 0");
            return std::nullopt;
        }
        mesh.triangles.push_back(*triangle);
    }
    return mesh;
}

}  // namespace

std::optional<Shape> readMesh(Keys& keys, ShapeReading& reading) {
    const Placing placing = readPlacing(keys);
    const Value& value = *keys.any("mesh");
    if (value.kind == Value::Kind::text) {
        const auto make = [&](const std::string& name, const TriangleMesh& mesh) {
            return meshOf(keys, name, mesh);
        };
        return readShapeFile(keys, "mesh", placing, reading.files, make);
    }
    std::optional<TriangleMesh> mesh = readTriangles(keys.inner(value, "a mesh"));
    if (!mesh || !placePoints(keys, "mesh", "mesh", placing, mesh->corners)) return std::nullopt;
    return meshOf(keys, "mesh", *mesh);
}

std::optional<Shape> readHeightField(Keys& shape, ShapeReading&) {
    constexpr int kMost = 2000;
    Keys keys = shape.inner(*shape.any("height_field"), "a height_field");
    for (const char* key : {"columns", "rows", "spacing", "heights"})
        if (!keys.has(key))
            keys.complain("", std::string("a height_field has no ") + key +
                                  "; write height_field = { columns = 2, rows = 2, spacing = 1, "
                                  "heights = [0, 0, 0, 1] }");
    const std::optional<int> columns = keys.whole("columns", {2, kMost});
    const std::optional<int> rows = keys.whole("rows", {2, kMost});
    const std::optional<double> spacing = keys.number("spacing", kSize);
    const std::optional<std::vector<double>> heights = keys.numbers("heights", kMeters);
    keys.done();
    if (!columns || !rows || !spacing || !heights) return std::nullopt;
    const auto needed = static_cast<std::size_t>(*columns) * static_cast<std::size_t>(*rows);
    if (heights->size() == needed) return Shape::heightField(*columns, *rows, *spacing, *heights);
    keys.complain("heights", "the number of heights is " + std::to_string(heights->size()) +
                                 "; it should be " + std::to_string(needed) +
                                 ", columns times rows: row after row, x running fastest");
    return std::nullopt;
}

}  // namespace demos
