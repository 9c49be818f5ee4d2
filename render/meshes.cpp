#include "render/meshes.h"

#include <map>
#include <utility>

#include "render/facet_mesh.h"
#include "render/unit_meshes.h"

namespace render {

/// Coarse: uses the mesh of the level below, if there is one.
void Meshes::Levels::draw(const std::vector<InstanceList>& lists, Detail detail,
                          std::optional<Material> only) const {
    for (std::size_t i = 0; i < meshes.size(); ++i)
        meshes[detail == Detail::coarse && i > 0 ? i - 1 : i].draw(lists[i], only);
}

std::bitset<kMaterials> Meshes::Levels::materials() const {
    std::bitset<kMaterials> result;
    for (const InstanceList& list : instances) result |= list.materials();
    return result;
}

Meshes::Meshes() : box_(boxMesh()), litDomes_(kBallCorners.size()) {
    for (const int corners : kBarCorners) bars_.meshes.emplace_back(barMesh(corners));
    for (const int corners : kBallCorners) {
        balls_.meshes.emplace_back(ballMesh(corners));
        domes_.meshes.emplace_back(domeMesh(corners));
        cylinders_.meshes.emplace_back(cylinderMesh(corners));
        cones_.meshes.emplace_back(coneMesh(corners));
    }
    for (Levels* shape : {&bars_, &balls_, &cylinders_, &cones_, &domes_})
        shape->instances = std::vector<InstanceList>(shape->meshes.size());
}

void Meshes::set(const Instances& instances) {
    boxes_.set(instances.boxes);
    for (std::size_t i = 0; i < instances.bars.size(); ++i)
        bars_.instances[i].set(instances.bars[i]);
    for (std::size_t i = 0; i < kBallCorners.size(); ++i) {
        balls_.instances[i].set(instances.balls[i]);
        cylinders_.instances[i].set(instances.cylinders[i]);
        cones_.instances[i].set(instances.cones[i]);
    }
    setDomes(instances);
    setMeshes(instances.meshes);
    round_ = balls_.materials() | bars_.materials() | domes_.materials();
    facets_ = cylinders_.materials() | cones_.materials();
    for (const Uploaded& one : meshes_)
        (one.mesh->anyCrisp ? facets_ : round_) |= one.instances.materials();
}

void Meshes::setDomes(const Instances& instances) {
    for (std::size_t i = 0; i < instances.domes.size(); ++i) {
        std::vector<Instance> domes = instances.domes[i];
        domes_.instances[i].set(domes);
        for (Instance& dome : domes) dome.rotation = instances.towardsSun;
        litDomes_[i].set(domes);
    }
}

/// Meshes of the last frame are not uploaded again; those this frame does not use are freed.
void Meshes::setMeshes(const std::vector<Instances::OfMesh>& meshes) {
    std::map<const SolidMesh*, Uploaded*> old;
    for (Uploaded& one : meshes_) old[one.mesh.get()] = &one;
    std::vector<Uploaded> now;
    for (const Instances::OfMesh& one : meshes) {
        const auto known = old.find(one.mesh.get());
        if (known != old.end())
            now.push_back(std::move(*known->second));
        else
            now.push_back({one.mesh, InstancedMesh(facetMesh(*one.mesh)), InstanceList()});
        now.back().instances.set(one.instances);
    }
    meshes_ = std::move(now);
}

void Meshes::drawRound(GLuint program, Detail detail, Half half,
                       std::optional<Material> only) const {
    setUniform(program, "ofDome", 1.0f);
    domes_.draw(half == Half::seen ? domes_.instances : litDomes_, detail, only);
    setUniform(program, "ofDome", 0.0f);
    balls_.draw(detail, only);
    bars_.draw(detail, only);
    for (const Uploaded& one : meshes_)
        if (!one.mesh->anyCrisp) one.drawn.draw(one.instances, only);
}

void Meshes::drawFacets(GLuint program, Detail detail, std::optional<Material> only) const {
    setUniform(program, "thinnestOfUnit", 1.0f);
    cylinders_.draw(detail, only);
    cones_.draw(detail, only);
    for (const Uploaded& one : meshes_) {
        if (!one.mesh->anyCrisp) continue;
        setUniform(program, "thinnestOfUnit", one.mesh->thinnest);
        one.drawn.draw(one.instances, only);
    }
}

void Meshes::drawWith(GLuint program, const Eigen::Matrix4f& worldToClip, Detail detail, Half half,
                      std::optional<Material> only) const {
    glUseProgram(program);
    setUniform(program, "worldToClip", worldToClip);
    glEnable(GL_CULL_FACE);
    drawBoxes(only);
    drawRound(program, detail, half, only);
    drawFacets(program, detail, only);
    glDisable(GL_CULL_FACE);
}

}  // namespace render
