// shape = { sphere = 0.5 } and its kin

#include "demos/scene/read_parts.h"

namespace demos {
namespace {

constexpr Range kSize{1e-3, 1e3, "m"};

std::optional<engine::Shape> readCapsule(Keys keys) {
    for (const char* key : {"radius", "height"})
        if (!keys.has(key))
            keys.complain(key, std::string("a capsule has no ") + key +
                                   "; write capsule = { radius = 0.1, height = 0.5 }");
    const std::optional<double> radius = keys.number("radius", kSize);
    const std::optional<double> height = keys.number("height", kSize);
    keys.done();
    if (!radius || !height) return std::nullopt;
    if (*height < 2.0 * *radius) {
        keys.complain("height", "height is " + numberText(*height) +
                                    "; from tip to tip it should be at least twice the radius, " +
                                    numberText(2.0 * *radius));
        return std::nullopt;
    }
    return engine::Shape::capsule(*radius, *height);
}

std::optional<engine::Shape> readPlane(Keys& keys) {
    const std::optional<Vec3> normal = keys.vector("plane", {-1e6, 1e6});
    if (!normal) return std::nullopt;
    if (normal->norm() < 1e-6) {
        keys.complain("plane",
                      "plane is [0, 0, 0]; it should be the direction out of the solid, "
                      "like [0, 1, 0]");
        return std::nullopt;
    }
    return engine::Shape::plane(*normal);
}

}  // namespace

std::optional<engine::Shape> readShape(Keys& body) {
    const Value* table = body.any("shape");
    if (!table) {
        body.complain("shape",
                      "a [[body]] has no shape; write shape = { sphere = 0.5 }, or box, "
                      "capsule, plane");
        return std::nullopt;
    }
    Keys keys = body.inner(*table, "a shape");
    std::optional<engine::Shape> shape;
    int given = 0;
    for (const char* key : {"sphere", "box", "capsule", "plane"}) given += keys.has(key) ? 1 : 0;
    if (const std::optional<double> radius = keys.number("sphere", kSize))
        shape = engine::Shape::sphere(*radius);
    if (const std::optional<Vec3> size = keys.vector("box", kSize))
        shape = engine::Shape::box(*size);
    if (const Value* capsule = keys.any("capsule")) 
        shape = readCapsule(keys.inner(*capsule, "a capsule"));
    if (const std::optional<engine::Shape> plane = readPlane(keys)) shape = plane;
    keys.later({"cylinder", "hull", "mesh", "compound"});
    keys.done();
    const bool empty = table->kind == Value::Kind::table && table->keys.empty();
    if (given > 1 || empty) {
        body.complain("shape", std::string(empty ? "an empty shape" : "two shapes in one") +
                                   "; give one of sphere, box, capsule, plane");
        return std::nullopt;
    }
    return shape;
}

}  // namespace demos
