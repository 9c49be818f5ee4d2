/// What is drawn of a frame: the instances of each mesh, without a driver.
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "render/solid_mesh.h"
#include "render/vertex.h"

namespace render {

/// Corners around round shapes, by their size in the picture, with an error of a third of a pixel.
inline constexpr std::array<int, 6> kBallCorners = {12, 16, 20, 28, 44, 64};
inline constexpr std::array<int, 3> kBarCorners = {6, 10, 20};
using ByCorners = std::array<std::vector<Instance>, kBallCorners.size()>;

/// Solids and rods of a frame, by mesh, nearest first: hidden ones are not shaded.
struct Instances {
    struct OfMesh {
        std::shared_ptr<const SolidMesh> mesh;
        std::vector<Instance> instances;
    };
    std::vector<Instance> boxes;
    std::array<std::vector<Instance>, kBarCorners.size()> bars;
    ByCorners balls, cylinders, cones;
    ByCorners domes;             // half balls, turned towards the eye
    Eigen::Vector4f towardsSun;  // their rotation in the shadow map, x, y, z, w
    std::vector<OfMesh> meshes;  // each once
};
/// `pixelsAMeter`: at 1 m from the eye. A ball of few pixels gets few triangles. `toSun`: for the
/// shadow map. `chosen`: the bodies to draw, by number of their surface; null: all. Their order is
/// the same.
Instances instancesOf(const Frame& frame, float pixelsAMeter, const Vec3& toSun,
                      const std::vector<char>* chosen = nullptr);

/// m. A rod thinner than a pixel is drawn a little wider than a pixel, so that no row of it falls
/// between the pixels' centres.
float drawnRadius(const Rod& rod, const Vec3& eye, float pixelsAMeter);

}  // namespace render
