#include "render/joined_faces.h"

#include <algorithm>

namespace render {
namespace {

bool isBefore(const SolidMesh& mesh, int triangle, const Vec3& eye) {
    return mesh.normals[triangle].dot(eye - mesh.vertices[mesh.triangles[triangle][0]]) > 0.0f;
}

bool endsHere(const SolidMesh& mesh, int triangle, const Vec3& eye) {
    for (int i = 0; i < 3; ++i) {
        const int other = mesh.beyond[triangle][i];
        if (other < 0 || mesh.crisp[triangle][i] || !isBefore(mesh, other, eye)) return true;
    }
    return false;
}

std::vector<int> tableOf(const SolidMesh& mesh, const Vec3& eye) {
    constexpr int kNone = -1;
    std::vector<int> table(static_cast<std::size_t>(std::min(mesh.facetCount, kFaces)), kNone);
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
        const int face = mesh.facets[t] & (kFaces - 1);
        if (table[face] == kNone && isBefore(mesh, t, eye) && endsHere(mesh, t, eye))
            table[face] = face;
    }
    const auto first = std::find(table.begin(), table.end(), kNone);
    std::replace(table.begin(), table.end(), kNone, static_cast<int>(first - table.begin()));
    return table;
}

}  // namespace

FaceTables joinedFaces(const std::vector<Surface>& surfaces, const Vec3& eye) {
    FaceTables tables;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const Surface& s = surfaces[i];
        if (s.kind != SurfaceKind::mesh) continue;
        tables.resize(surfaces.size());
        const Vec3d local = s.axes.transpose() * (eye.cast<double>() - s.at);
        tables[i] = tableOf(*s.mesh, local.cast<float>());
    }
    return tables;
}

void joinFaces(SurfaceMap& map, const PixelRect& where, const FaceTables& tables) {
    if (tables.empty()) return;
    for (int y = where.y0; y < where.y1; ++y)
        for (int x = where.x0; x < where.x1; ++x) {
            std::int32_t& packed = map.packed[static_cast<std::size_t>(y) * map.width + x];
            const int surface = surfaceIn(packed);
            if (surface >= 0 && !tables[surface].empty())
                packed = packedSurface(surface, tables[surface][faceIn(packed)]);
        }
}

}  // namespace render
