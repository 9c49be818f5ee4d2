/// All the meshes used to draw a frame.
#pragma once
#include <memory>
#include <vector>

#include "render/instanced_mesh.h"
#include "render/instances.h"

namespace render {

/// The detail of round shapes: as the picture needs it, or one step coarser for
/// the depths of ambient occlusion, where an error of two thirds of a pixel is not visible.
enum class Detail { fine, coarse };

/// The half of a ball that is drawn: towards the eye or towards the sun.
enum class Half { seen, lit };

/// All meshes, with the instances of one frame.
class Meshes {
public:
    Meshes();
    void set(const Instances& instances);
    /// Boxes of one material, or all that are not glass; so also the following.
    void drawBoxes(std::optional<Material> only = {}) const { box_.draw(boxes_, only); }
    /// Also meshes without a crisp edge. The program has the uniform `ofDome`.
    void drawRound(GLuint program, Detail detail, Half half, std::optional<Material> only = {}) const;
    /// Cylinders, cones and meshes with crisp edges; the program has the uniform `thinnestOfUnit`.
    void drawFacets(GLuint program, Detail detail, std::optional<Material> only = {}) const;
    /// Front faces with a program that has the uniform `worldToClip`.
    void drawWith(GLuint program, const Eigen::Matrix4f& worldToClip, Detail detail, Half half,
                  std::optional<Material> only = {}) const;
    /// Those of any instance.
    std::bitset<kMaterials> materials() const { return boxes_.materials() | round_ | facets_; }
    /// Those of instances that the three functions above draw.
    bool anyBoxes(Material material) const { return boxes_.materials()[indexOf(material)]; }
    bool anyRound(Material material) const { return round_[indexOf(material)]; }
    bool anyFacets(Material material) const { return facets_[indexOf(material)]; }

private:
    void setDomes(const Instances& instances);
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
        void draw(Detail detail, std::optional<Material> only) const { draw(instances, detail, only); }
        void draw(const std::vector<InstanceList>& lists, Detail detail,
                  std::optional<Material> only) const;
        std::bitset<kMaterials> materials() const;
    };
    InstancedMesh box_;
    InstanceList boxes_;
    Levels bars_, balls_, cylinders_, cones_, domes_;
    std::vector<InstanceList> litDomes_;                    // towards the sun, by corners
    std::vector<Uploaded> meshes_;                          // those of the last frame
    std::bitset<kMaterials> round_, facets_;
};

}  // namespace render
