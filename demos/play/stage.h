/// A scene in simulation: the world, and what pictures need in addition.
#pragma once
#include <vector>

#include "demos/play/solids.h"
#include "demos/scene/description.h"
#include "engine/world.h"

namespace demos {

struct Stage {
    SceneDescription scene;
    engine::World world;
    engine::BodyId ground;                  // the body that represents 'world' in joints
    std::vector<engine::BodyId> bodies;     // by index in scene.bodies
    std::vector<engine::JointId> joints;    // by index in scene.joints
    std::vector<std::vector<DrawnPart>> drawn;  // by index in scene.bodies
    std::vector<std::vector<Vec3>> trails;  // by index in scene.look.trails; one point per step

    explicit Stage(const SceneDescription& description);

    double dt() const { return 1.0 / scene.hz; }
    /// One step of the world, with kinematic bodies on their paths. False: it diverged;
    /// world.report() has the reason.
    bool step();
    const std::string& nameOf(engine::BodyId id) const;
    /// What is kept of it, besides the world's state, in a state (engine/base/state_bytes.h).
    template <class Bytes>
    void keep(Bytes& bytes) {
        bytes(trails, steps_);
    }
    /// The number of the scene's bodies that have not been removed after an incident.
    int bodiesNow() const;

private:
    void followPaths();

    std::vector<int> onPaths_;  // indices in scene.bodies
    long long steps_ = 0;
};

}  // namespace demos
