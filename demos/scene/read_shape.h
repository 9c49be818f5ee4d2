/// The readers of single shapes, for read_shape.cpp.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "demos/scene/keys.h"
#include "demos/text/text_hash.h"
#include "engine/shape.h"

namespace demos {

/// Shapes from files, each file read once however many bodies have its shape.
struct ShapeFiles {
    std::optional<std::filesystem::path> folder;  // that they are relative to; none: no files
    std::map<std::string, engine::Shape> known;   // by file, use, scale and turn
    TextHash contents = {};                       // of what was read
    std::vector<std::string> paths = {};          // that were read
};

/// What a shape needs to know besides its own keys.
struct ShapeReading {
    double density = 1000.0;  // kg/m^3, of the body: parts that give none have it
    ShapeFiles& files;
};

/// The one shape that a table { sphere = 0.5 } tells; `keys`: of that table.
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
/// False, and a complaint of `key`, where they come to lie too far away.
bool placePoints(Keys& keys, const char* key, const std::string& of, const Placing& placing,
                 std::vector<engine::Vec3>& points);
/// `turn_deg` alone: about the fixed x, then y, then z.
engine::Quat readTurn(Keys& keys);

}  // namespace demos
