#include "demos/scene/stage.h"

namespace demos {
namespace {

/// Joints to 'world' need a body; this one is nowhere to be seen or hit. It comes after the
/// scene's own, so that these keep the numbers of the file.
engine::BodyId addGround(engine::World& world) {
    engine::BodyDef def;
    def.kind = engine::BodyKind::fixed;
    def.collide = false;
    return world.add(def);
}

engine::JointDef jointDef(const JointDescription& joint, const Stage& stage) {
    engine::JointDef def;
    def.type = joint.type;
    def.a = joint.a < 0 ? stage.ground : stage.bodies[joint.a];
    def.b = joint.b < 0 ? stage.ground : stage.bodies[joint.b];
    def.anchorA = joint.anchorA;
    def.anchorB = joint.anchorB;
    def.axis = joint.axis;
    def.length = joint.length;
    def.spring = joint.spring;
    return def;
}

}  // namespace

Stage::Stage(const SceneDescription& description)
    : scene(description), world(description.settings) {
    world.setGravity(scene.gravity);
    for (const BodyDescription& body : scene.bodies) bodies.push_back(world.add(body.def));
    ground = addGround(world);
    for (const JointDescription& joint : scene.joints)
        joints.push_back(world.add(jointDef(joint, *this)));
    trails.resize(scene.look.trails.size());
}

const std::string& Stage::nameOf(engine::BodyId id) const {
    static const std::string kWorld = "world";
    const bool own = id.index >= 0 && id.index < static_cast<int>(scene.bodies.size());
    return own ? scene.bodies[id.index].name : kWorld;
}

}  // namespace demos
