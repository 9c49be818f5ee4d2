// compound = [{ shape = { ... }, at = [...], turn_deg = [...], density = ... }, ...]

#include "demos/scene/ranges.h"
#include "demos/scene/read_shape.h"
#include "demos/scene/table_readers.h"

namespace demos {
namespace {

using engine::Shape;
using engine::ShapePart;
using engine::ShapeType;

std::size_t solidsIn(const Value& compound);

std::size_t solidsOfPart(const Value& part) {
    const Value* shape = part.find("shape");
    const Value* inner = shape ? shape->find("compound") : nullptr;
    return inner ? solidsIn(*inner) : 1;
}

/// With those of the compounds in it, before any of them is built.
std::size_t solidsIn(const Value& compound) {
    if (compound.kind != Value::Kind::array) return solidsOfPart(compound);
    std::size_t count = 0;
    for (const Value& part : compound.items) count += solidsOfPart(part);
    return count;
}

/// `at` is the position of the part's own origin, from that of the compound.
std::optional<ShapePart> readPart(Keys keys, ShapeReading& reading) {
    const Vec3 at = keys.vector("at", kMeters).value_or(Vec3(0, 0, 0));
    const Quat turn = readTurn(keys);
    const auto density = keys.number("density", kDensity);
    const Value* table = keys.any("shape");
    if (!table) keys.complain("", "a part has no shape; write { shape = { sphere = 0.5 } }");
    std::optional<Shape> shape;
    ShapeReading own{density.value_or(reading.density), reading.files};
    if (table) shape = readShapeTable(*table, keys.inner(*table, "a shape"), own);
    keys.done();
    if (!shape) return std::nullopt;
    if (shape->type == ShapeType::plane || shape->type == ShapeType::mesh) {
        keys.complain("shape", std::string("a part that is a ") +
                                   (shape->type == ShapeType::plane ? "plane" : "mesh") +
                                   "; parts should be solids: sphere, box, capsule, cylinder, "
                                   "cone, hull or compound");
        return std::nullopt;
    }
    return ShapePart{*shape, {at - turn * shape->origin, turn}, own.density / reading.density};
}

}  // namespace

std::optional<Shape> readCompound(Keys& keys, ShapeReading& reading) {
    const std::vector<const Value*> tables = keys.tables("compound");
    const Value& value = *keys.any("compound");
    const std::size_t solids = solidsIn(value);
    const bool none = value.kind == Value::Kind::array && tables.empty();
    if (none || solids > kMostParts) {
        keys.complain("compound", "compound has " + std::to_string(solids) +
                                      " parts; it should have 1 to " + std::to_string(kMostParts));
        return std::nullopt;
    }
    std::vector<ShapePart> parts;
    for (const Value* table : tables)
        if (const auto part = readPart(keys.inner(*table, "a part"), reading))
            parts.push_back(*part);
    if (parts.empty() || parts.size() < tables.size()) return std::nullopt;
    return Shape::compound(parts);
}

}  // namespace demos
