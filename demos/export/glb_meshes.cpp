#include "demos/export/glb_meshes.h"

#include <array>

#include "render/linear.h"
#include "render/material.h"

namespace demos {

int GlbMeshes::materialOf(const render::Color& color, render::Material look) {
    const render::MaterialValues& values = render::valuesOf(look);
    const auto [place, isNew] = byValues_.try_emplace(
        {color.r, color.g, color.b, color.a, values.metallic, values.roughness},
        static_cast<int>(materials_.size()));
    if (!isNew) return place->second;
    const render::Vec3 light = render::linear(color);
    GlbJson& material = materials_.emplace_back();
    material["pbrMetallicRoughness"] = {
        {"baseColorFactor", {light.x(), light.y(), light.z(), color.a}},
        {"metallicFactor", values.metallic},
        {"roughnessFactor", values.roughness}};
    if (color.a < 1.0f) material["alphaMode"] = "BLEND";
    return place->second;
}

const std::pair<int, GlbMeshes::Accessors>& GlbMeshes::shared(const Triangles& triangles) {
    const auto known = shared_.find(triangles);
    if (known != shared_.end()) return known->second;
    const Accessors accessors{
        buffer_.addPositions(triangles.positions), buffer_.addNormals(triangles.normals),
        buffer_.addCorners(triangles.corners, triangles.positions.size() / 3)};
    const auto number = static_cast<int>(shared_.size());
    return shared_.emplace(triangles, std::pair(number, accessors)).first->second;
}

int GlbMeshes::meshOf(const Triangles& triangles, int material) {
    const auto& [number, accessors] = shared(triangles);
    const auto [place, isNew] =
        byParts_.try_emplace({number, material}, static_cast<int>(meshes_.size()));
    if (!isNew) return place->second;
    GlbJson primitive;
    primitive["attributes"] = {{"POSITION", accessors.positions}, {"NORMAL", accessors.normals}};
    primitive["indices"] = accessors.corners;
    primitive["material"] = material;
    meshes_.push_back({{"primitives", GlbJson::array({std::move(primitive)})}});
    return place->second;
}

}  // namespace demos
