#include "demos/play/solids.h"

#include "engine/shapes/hull.h"
#include "engine/shapes/mesh.h"
#include "render/solid_mesh.h"

namespace demos {
namespace {

std::vector<render::Vec3> drawnCorners(const std::vector<engine::Vec3>& corners) {
    std::vector<render::Vec3> drawn;
    for (const engine::Vec3& corner : corners) drawn.push_back(corner.cast<float>());
    return drawn;
}

render::Solid meshSolid(std::shared_ptr<const render::SolidMesh> mesh) {
    render::Solid solid;
    solid.shape = render::SolidShape::mesh;
    solid.halfSize = mesh->halfSize;
    solid.mesh = std::move(mesh);
    return solid;
}

render::Solid hullSolid(const engine::Hull& hull) {
    render::MeshTriangles triangles;
    for (const engine::Hull::Face& face : hull.faces)
        for (std::size_t i = 2; i < face.corners.size(); ++i)
            triangles.push_back({face.corners[0], face.corners[i - 1], face.corners[i]});
    return meshSolid(render::makeMesh(drawnCorners(hull.corners), std::move(triangles), true));
}

render::Solid surfaceSolid(const engine::Mesh& mesh) {
    render::MeshTriangles triangles;
    for (const engine::Mesh::Triangle& triangle : mesh.triangles)
        triangles.push_back(triangle.corners);
    return meshSolid(render::makeMesh(drawnCorners(mesh.corners), std::move(triangles), false));
}

render::Solid roundSolid(render::SolidShape shape, double radius, double half) {
    render::Solid solid;
    solid.shape = shape;
    const float r = static_cast<float>(radius);
    solid.halfSize = {r, static_cast<float>(half), r};
    return solid;
}

render::Solid solidOf(const engine::Shape& shape) {
    const double r = shape.radius, half = shape.halfLength;
    switch (shape.type) {
        case engine::ShapeType::sphere: return roundSolid(render::SolidShape::sphere, r, r);
        case engine::ShapeType::capsule: return roundSolid(render::SolidShape::capsule, r, half);
        case engine::ShapeType::cylinder: return roundSolid(render::SolidShape::cylinder, r, half);
        case engine::ShapeType::cone: return roundSolid(render::SolidShape::cone, r, half);
        case engine::ShapeType::hull: return hullSolid(*shape.hull);
        case engine::ShapeType::mesh: return surfaceSolid(*shape.mesh);
        default: break;
    }
    render::Solid box;
    box.halfSize = shape.halfSize.cast<float>();
    return box;
}

}  // namespace

std::vector<DrawnPart> drawnParts(const engine::Shape& shape) {
    if (shape.type == engine::ShapeType::plane) return {};
    if (shape.type != engine::ShapeType::compound) return {{solidOf(shape), {}}};
    std::vector<DrawnPart> parts;
    for (const engine::ShapePart& part : *shape.parts)
        parts.push_back({solidOf(part.shape), part.pose});
    return parts;
}

}  // namespace demos
