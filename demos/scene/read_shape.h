/// The readers of single shapes, for read_shape.cpp.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "demos/scene/keys.h"
#include "demos/text/text_hash.h"
#include "engine/shape.h"

namespace demos {

inline constexpr std::size_t kMostParts = 1000;  // solids of a compound, at any depth
/// Bytes of all files with shapes: one is read again for every scale.
inline constexpr std::uintmax_t kMostShapeBytes = 256u << 20;
/// Triangles, and a quarter of the points, of all shapes that are built from files, one for every scale: 1 GB.
inline constexpr std::size_t kMostTrianglesInAll = 4'000'000;
/// Shapes from files. A shape is built once, however many bodies use it.
struct ShapeFiles {
    std::optional<std::filesystem::path> folder;  // they are relative to it; none: no files
    std::map<std::string, engine::Shape> known;   // by file, use, scale and rotation
    TextHash contents = {};                       // of the points and triangles read
    std::vector<std::string> paths = {};          // files that were read
    std::uintmax_t bytes = 0;                     // of these files, up to kMostShapeBytes
    std::size_t triangles = 0;  // of all shapes built of them, and a quarter of their points
};

/// What reading a shape needs besides the shape's own keys.
struct ShapeReading {
    double density = 1000.0;  // kg/m^3, of the body: the default of its parts
    ShapeFiles& files;
};

/// The one shape that a table { sphere = 0.5 } describes; `keys`: of that table.
std::optional<engine::Shape> readShapeTable(const Value& table, Keys keys, ShapeReading& reading);

// Each reads one key of that table.
std::optional<engine::Shape> readHull(Keys& keys, ShapeReading& reading);         // read_hull.cpp
std::optional<engine::Shape> readMesh(Keys& keys, ShapeReading& reading);         // read_mesh.cpp
std::optional<engine::Shape> readHeightField(Keys& keys, ShapeReading& reading);  // read_mesh.cpp
std::optional<engine::Shape> readCompound(Keys& keys, ShapeReading& reading);  // read_compound.cpp

/// `scale` and `turn_deg` of points and files: p -> R S p.
struct Placing {
    engine::Vec3 scale{1, 1, 1};
    engine::Quat turn = engine::Quat::Identity();
    engine::Vec3 of(const engine::Vec3& p) const { return turn * scale.cwiseProduct(p); }
};
Placing readPlacing(Keys& keys);
/// Places the points. False, with an error at `key`, if one is too far away.
bool placePoints(Keys& keys, const char* key, const std::string& of, const Placing& placing,
                 std::vector<engine::Vec3>& points);
/// `turn_deg` alone: rotations about the fixed x, then y, then z axis.
engine::Quat readTurn(Keys& keys);

}  // namespace demos
