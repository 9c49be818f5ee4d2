// shape = { sphere = 0.5 } and all other shapes

#include "demos/scene/read_shape.h"

#include "demos/scene/ranges.h"
#include "demos/scene/table_readers.h"
#include "demos/text/nearest.h"
#include "engine/base/trigonometry.h"

namespace demos {
namespace {

using engine::Shape;

std::optional<Shape> readSphere(Keys& keys, ShapeReading&) {
    const std::optional<double> radius = keys.number("sphere", kSize);
    return radius ? std::optional(Shape::sphere(*radius)) : std::nullopt;
}

std::optional<Shape> readBox(Keys& keys, ShapeReading&) {
    const std::optional<Vec3> size = keys.vector("box", kSize);
    return size ? std::optional(Shape::box(*size)) : std::nullopt;
}

struct Round {
    double radius, height;  // m
};

/// Reads { radius, height }.
std::optional<Round> readRound(Keys& shape, const char* key) {
    const std::string kind = key;
    Keys keys = shape.inner(*shape.any(key), "a " + kind);
    for (const char* size : {"radius", "height"})
        if (!keys.has(size))
            keys.complain(size, "a " + kind + " has no " + size + "; write " + kind +
                                    " = { radius = 0.1, height = 0.5 }");
    const std::optional<double> radius = keys.number("radius", kSize);
    const std::optional<double> height = keys.number("height", kSize);
    keys.done();
    if (!radius || !height) return std::nullopt;
    if (kind != "capsule" || *height >= 2.0 * *radius) return Round{*radius, *height};
    keys.complain("height", "height is " + numberText(*height) +
                                "; from tip to tip it should be at least twice the radius, " +
                                numberText(2.0 * *radius));
    return std::nullopt;
}

std::optional<Shape> readCapsule(Keys& keys, ShapeReading&) {
    const std::optional<Round> r = readRound(keys, "capsule");
    return r ? std::optional(Shape::capsule(r->radius, r->height)) : std::nullopt;
}

std::optional<Shape> readCylinder(Keys& keys, ShapeReading&) {
    const std::optional<Round> r = readRound(keys, "cylinder");
    return r ? std::optional(Shape::cylinder(r->radius, r->height)) : std::nullopt;
}

std::optional<Shape> readCone(Keys& keys, ShapeReading&) {
    const std::optional<Round> r = readRound(keys, "cone");
    return r ? std::optional(Shape::cone(r->radius, r->height)) : std::nullopt;
}

std::optional<Shape> readPlane(Keys& keys, ShapeReading&) {
    const std::optional<Vec3> normal = keys.vector("plane", {-1e6, 1e6});
    if (!normal) return std::nullopt;
    if (normal->norm() >= 1e-6) return Shape::plane(*normal);
    keys.complain("plane",
                  "plane is [0, 0, 0]; it should be its normal, the direction out of the solid, "
                  "like [0, 1, 0]");
    return std::nullopt;
}

struct ShapeKind {
    const char* key;
    std::optional<Shape> (*read)(Keys& keys, ShapeReading& reading);
    const char* example;
};

constexpr const char* kRoundExample = "{ radius = 0.1, height = 0.5 }";

constexpr ShapeKind kShapeKinds[] = {
    {"sphere", readSphere, "0.5"},
    {"box", readBox, "[1, 1, 1]"},
    {"capsule", readCapsule, kRoundExample},
    {"cylinder", readCylinder, kRoundExample},
    {"cone", readCone, kRoundExample},
    {"plane", readPlane, "[0, 1, 0]"},
    {"hull", readHull, "[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]"},
    {"mesh", readMesh, "\"thing.stl\""},
    {"height_field", readHeightField, "{ ... }"},
    {"compound", readCompound, "[{ ... }, ...]"},
};

std::string kindNames() {
    std::vector<std::string> names;
    for (const ShapeKind& kind : kShapeKinds) names.emplace_back(kind.key);
    return anyOf(names);
}

/// "{ sphere = 0.5 }" for the word "ball"; empty if it means no kind of shape.
std::string shapeExample(const std::string& word) {
    std::vector<std::string> names;
    for (const ShapeKind& kind : kShapeKinds) names.emplace_back(kind.key);
    const std::string meant = nearest(word, names);
    for (const ShapeKind& kind : kShapeKinds)
        if (meant == kind.key) return "{ " + meant + " = " + kind.example + " }";
    return {};
}

/// Only points can be scaled and rotated, not shapes with sizes of their own.
void refusePlacing(Keys& keys, const std::string& kind) {
    for (const char* key : {"scale", "turn_deg"})
        if (keys.any(key))
            keys.complain(key, std::string(key) + " is given for a " + kind +
                                   "; leave it out: only hull and mesh take it");
}

}  // namespace

engine::Quat readTurn(Keys& keys) {
    const Vec3 degrees = keys.vector("turn_deg", kDegrees).value_or(Vec3(0, 0, 0));
    Vec3 angles;
    for (int k = 0; k < 3; ++k) angles[k] = engine::radians(degrees[k]);
    return engine::turnAboutXyz(angles);
}

Placing readPlacing(Keys& keys) {
    constexpr Range kScale{1e-6, 1e6};
    Placing placing;
    const Value* scale = keys.any("scale");
    if (scale && scale->kind == Value::Kind::array)
        placing.scale = keys.vector("scale", kScale).value_or(placing.scale);
    else if (scale)
        placing.scale.setConstant(keys.number("scale", kScale).value_or(1.0));
    placing.turn = readTurn(keys);
    return placing;
}

bool placePoints(Keys& keys, const char* key, const std::string& of, const Placing& placing,
                 std::vector<Vec3>& points) {
    constexpr double kFarthest = 1e5;  // m
    for (Vec3& p : points) {
        p = placing.of(p);
        if ((p.array().abs() <= kFarthest).all()) continue;  // false for NaN too
        keys.complain(key, of + " has a point (" + numberText(p.x()) + ", " + numberText(p.y()) +
                               ", " + numberText(p.z()) +
                               "); all should be within 100000 m: give a scale");
        return false;
    }
    return true;
}

std::optional<Shape> readShapeTable(const Value& table, Keys keys, ShapeReading& reading) {
    std::optional<Shape> shape;
    int given = 0;
    for (const ShapeKind& kind : kShapeKinds) {
        if (!keys.any(kind.key)) continue;  // asks for every kind, so that none is unknown
        ++given;
        shape = kind.read(keys, reading);
        const std::string name = kind.key;
        if (name != "hull" && name != "mesh") refusePlacing(keys, name);
    }
    keys.done();
    if (given == 1) return shape;
    if (given > 1)
        keys.complain("", "two shapes in one; give one of " + kindNames());
    else if (table.kind == Value::Kind::table && table.keys.empty())
        keys.complain("", "an empty shape; give one of " + kindNames());
    return std::nullopt;
}

std::optional<Shape> readShape(Keys& body, double density, ShapeFiles& files) {
    const Value* table = body.any("shape");
    if (!table) {
        body.complain("shape",
                      "a [[body]] has no shape; write shape = { sphere = 0.5 }, or " + kindNames());
        return std::nullopt;
    }
    if (table->kind == Value::Kind::text) {
        const std::string example = shapeExample(table->text);
        body.complainOf("shape", "shape is " + describe(*table) + "; it should be a table like " +
                                     (example.empty() ? "{ sphere = 0.5 }, or " + kindNames()
                                                      : example));
        return std::nullopt;
    }
    ShapeReading reading{density, files};
    return readShapeTable(*table, body.inner(*table, "a shape"), reading);
}

}  // namespace demos
