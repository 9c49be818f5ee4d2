/// A scene that plays: the world, and what the picture needs besides.
#pragma once
#include <vector>

#include "demos/play/solids.h"
#include "demos/scene/description.h"
#include "engine/world.h"

namespace demos {

struct Stage {
    SceneDescription scene;
    engine::World world;
    engine::BodyId ground;                  // the body that stands for 'world' in joints
    std::vector<engine::BodyId> bodies;     // by place in scene.bodies
    std::vector<engine::JointId> joints;    // by place in scene.joints
    std::vector<std::vector<DrawnPart>> drawn;  // by place in scene.bodies
    std::vector<std::vector<Vec3>> trails;  // by place in scene.look.trails; one point per frame

    explicit Stage(const SceneDescription& description);

    double dt() const { return 1.0 / scene.hz; }
    /// One step of the world, kinematic bodies on their paths. False: it diverged; world.report()
    /// says how.
    bool step();
    const std::string& nameOf(engine::BodyId id) const;

private:
    void followPaths();

    std::vector<int> onPaths_;  // places in scene.bodies
    long long steps_ = 0;
};

}  // namespace demos
