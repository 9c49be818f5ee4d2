// hull = [[x, y, z], ...] or hull = "file.obj"

#include "demos/scene/mesh_file.h"
#include "demos/scene/ranges.h"
#include "demos/scene/read_shape.h"
#include "demos/scene/table_readers.h"
#include "engine/shapes/hull.h"

namespace demos {
namespace {

using engine::Shape;

/// Reports points that do not make a hull.
bool checkPoints(Keys& keys, const std::string& of, const std::vector<Vec3>& points) {
    Vec3 low = Vec3::Constant(1e300), high = -low;
    for (const Vec3& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
    const double extent = points.empty() ? 0.0 : (high - low).norm();
    if (points.size() >= 4 && (extent < kSize.low || extent > kSize.high))
        keys.complain("hull", of + " is " + numberText(extent) +
                                  " m across; it should be from 0.001 to 1000 m");
    else if (points.size() < 4 || engine::isFlat(points))
        keys.complain("hull", of + " is flat, " + std::to_string(points.size()) +
                                  " points; it should be four or more that are not in one plane");
    else
        return true;
    return false;
}

std::optional<Shape> hullOf(Keys& keys, const std::string& of, const std::vector<Vec3>& points) {
    if (!checkPoints(keys, of, points)) return std::nullopt;
    std::optional<Shape> shape = Shape::hullOf(points);
    if (shape) return shape;
    if (points.size() > Shape::kMostCorners)
        keys.complain("hull", of + " has more than " + std::to_string(Shape::kMostCorners) +
                                  " corners; it should be simpler, or a compound of several");
    else
        keys.complain("hull",
                      of + " is too nearly flat; its points should be farther from one plane");
    return std::nullopt;
}

}  // namespace

std::optional<Shape> readHull(Keys& keys, ShapeReading& reading) {
    const Placing placing = readPlacing(keys);
    if (keys.any("hull")->kind == Value::Kind::text) {
        const auto make = [&](const std::string& name, const TriangleMesh& mesh) {
            return hullOf(keys, name, mesh.corners);
        };
        return readShapeFile(keys, "hull", placing, reading.files, make);
    }
    std::optional<std::vector<Vec3>> points = keys.vectors("hull", kMeters);
    if (!points || !placePoints(keys, "hull", "hull", placing, *points)) return std::nullopt;
    return hullOf(keys, "hull", *points);
}

}  // namespace demos
