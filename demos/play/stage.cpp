#include "demos/play/stage.h"

#include <algorithm>
#include <map>

namespace demos {
namespace {

/// Joints to 'world' need a body; this one is invisible and does not collide. It comes after the
/// scene's bodies, so that these keep the numbers of the file.
engine::BodyId addGround(engine::World& world) {
    engine::BodyDef def;
    def.kind = engine::BodyKind::fixed;
    def.collide = false;
    return world.add(def);
}

/// The body in the world for one numbered by the description.
engine::BodyId bodyOf(engine::BodyId id, const Stage& stage) {
    return id.index < 0 ? stage.ground : stage.bodies[static_cast<std::size_t>(id.index)];
}

engine::JointDef jointDef(const JointDescription& joint, const Stage& stage) {
    engine::JointDef def = joint.def;
    def.a = bodyOf(joint.def.a, stage);
    def.b = bodyOf(joint.def.b, stage);
    return def;
}

/// Bodies that share a mesh or a hull also share its drawn mesh, which is as large.
class Drawings {
public:
    std::vector<DrawnPart> of(const BodyDescription& body) {
        if (!body.looks) return of(body.def.shape);
        std::vector<DrawnPart> parts;
        for (const engine::ShapePart& look : *body.looks)
            for (const DrawnPart& part : of(look.shape))
                parts.push_back({part.solid,
                                 {look.pose.toWorld(part.place.position),
                                  (look.pose.rotation * part.place.rotation).normalized()}});
        return parts;
    }

private:
    const std::vector<DrawnPart>& of(const engine::Shape& shape) {
        const void* key = shape.mesh    ? static_cast<const void*>(shape.mesh.get())
                          : shape.hull  ? static_cast<const void*>(shape.hull.get())
                          : shape.parts ? static_cast<const void*>(shape.parts.get())
                                        : nullptr;
        if (!key) return own_ = drawnParts(shape);
        const auto found = known_.find(key);
        return found != known_.end() ? found->second
                                     : known_.emplace(key, drawnParts(shape)).first->second;
    }

    std::vector<DrawnPart> own_;
    std::map<const void*, std::vector<DrawnPart>> known_;  // never iterated: keys have no order
};

engine::ForceDef forceDef(const ForceDescription& force, const Stage& stage) {
    engine::ForceDef def = force.def;
    for (engine::BodyId& id : def.on) id = bodyOf(id, stage);
    return def;
}

}  // namespace

Stage::Stage(const SceneDescription& description)
    : scene(description), world(description.settings) {
    world.setGravity(scene.gravity);
    Drawings drawings;
    for (const BodyDescription& body : scene.bodies) {
        if (body.path) onPaths_.push_back(static_cast<int>(bodies.size()));
        bodies.push_back(world.add(body.def));
        drawn.push_back(drawings.of(body));
    }
    ground = addGround(world);
    for (const JointDescription& joint : scene.joints)
        joints.push_back(world.add(jointDef(joint, *this)));
    for (const ForceDescription& force : scene.forces) world.add(forceDef(force, *this));
    followPaths();
    world.findContacts();
    trails.resize(scene.look.trails.size());
}

bool Stage::step() {
    followPaths();
    const bool good = world.step(dt());
    if (good) ++steps_;
    return good;
}

void Stage::followPaths() {
    const double next = static_cast<double>(steps_ + 1) / scene.hz;
    for (const int i : onPaths_) {
        if (!world.has(bodies[i])) continue;  // it went too far
        const BodyDescription& body = scene.bodies[i];
        const Vec3& origin = body.def.shape.origin;  // the point that the path moves
        const engine::Pose &centre = body.def.pose, start{centre.toWorld(origin), centre.rotation};
        engine::Pose target = poseAt(*body.path, start, next);
        target.position -= target.rotation * origin;
        const Twist twist = twistBetween(world.pose(bodies[i]), target, dt());
        world.setVelocity(bodies[i], twist.velocity, twist.spin);
    }
}

int Stage::bodiesNow() const {
    return static_cast<int>(std::count_if(bodies.begin(), bodies.end(), [this](engine::BodyId id) {
        return world.has(id);
    }));
}

const std::string& Stage::nameOf(engine::BodyId id) const {
    static const std::string kWorld = "world";
    const bool own = id.index >= 0 && id.index < static_cast<int>(scene.bodies.size());
    return own ? scene.bodies[id.index].name : kWorld;
}

}  // namespace demos
