/// The instances of a frame, and all the meshes used to draw them.
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "render/instanced_mesh.h"
#include "render/solid_mesh.h"

namespace render {

/// Corners around round shapes, by their size in the picture, with an error of a third of a pixel.
inline constexpr std::array<int, 6> kBallCorners = {12, 16, 20, 28, 44, 64};
inline constexpr std::array<int, 3> kBarCorners = {6, 10, 20};
using ByCorners = std::array<std::vector<Instance>, kBallCorners.size()>;

/// The detail of round shapes: as the picture needs it, or one step coarser for
/// the depths of ambient occlusion, where an error of two thirds of a pixel is not visible.
enum class Detail { fine, coarse };

/// Solids and rods of a frame, by mesh, nearest first: hidden ones are not shaded.
struct Instances {
    struct OfMesh {
        std::shared_ptr<const SolidMesh> mesh;
        std::vector<Instance> instances;
    };
    std::vector<Instance> boxes;
    std::array<std::vector<Instance>, kBarCorners.size()> bars;
    ByCorners balls, cylinders, cones;
    std::vector<OfMesh> meshes;  // each once
};
/// `pixelsAMeter`: at 1 m from the eye. A ball of few pixels gets few triangles. `chosen`: the bodies
/// to draw, by number of their surface; null: all. Their order is the same.
Instances instancesOf(const Frame& frame, float pixelsAMeter,
                      const std::vector<char>* chosen = nullptr);

/// m. A rod thinner than a pixel is drawn a little wider than a pixel, so that no row of it falls
/// between the pixels' centres.
float drawnRadius(const Rod& rod, const Vec3& eye, float pixelsAMeter);

/// All meshes, with the instances of one frame.
class Meshes {
public:
    Meshes();
    void set(const Instances& instances);
    /// Boxes of one material, or all that are not glass; so also the following.
    void drawBoxes(std::optional<Material> only = {}) const { box_.draw(boxes_, only); }
    /// Also meshes without a crisp edge.
    void drawRound(Detail detail, std::optional<Material> only = {}) const;
    /// Cylinders, cones and meshes with crisp edges; the program has the uniform `thinnestOfUnit`.
    void drawFacets(GLuint program, Detail detail, std::optional<Material> only = {}) const;
    /// Front faces with a program that has the uniform `worldToClip`.
    void drawWith(GLuint program, const Eigen::Matrix4f& worldToClip, Detail detail,
                  std::optional<Material> only = {}) const;
    /// Those of any instance.
    std::bitset<kMaterials> materials() const { return boxes_.materials() | round_ | facets_; }
    /// Those of instances that the three functions above draw.
    bool anyBoxes(Material material) const { return boxes_.materials()[indexOf(material)]; }
    bool anyRound(Material material) const { return round_[indexOf(material)]; }
    bool anyFacets(Material material) const { return facets_[indexOf(material)]; }

private:
    void setMeshes(const std::vector<Instances::OfMesh>& meshes);

    struct Uploaded {
        std::shared_ptr<const SolidMesh> mesh;
        InstancedMesh drawn;
        InstanceList instances;
    };
    /// One shape in several details, and the instances of each.
    struct Levels {
        std::vector<InstancedMesh> meshes;
        std::vector<InstanceList> instances;
        void draw(Detail detail, std::optional<Material> only) const;
        std::bitset<kMaterials> materials() const;
    };
    InstancedMesh box_;
    InstanceList boxes_;
    Levels bars_, balls_, cylinders_, cones_;
    std::vector<Uploaded> meshes_;                          // those of the last frame
    std::bitset<kMaterials> round_, facets_;
};

}  // namespace render
