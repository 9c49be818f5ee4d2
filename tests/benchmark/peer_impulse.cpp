// This project's engine, for the benchmark. Presets differ only in their Settings.
#include "engine/world.h"
#include "tests/benchmark/peer_engine.h"

namespace peers {

namespace {

using engine::BodyDef;
using engine::BodyKind;
using engine::JointDef;
using engine::JointType;
using engine::Settings;
using engine::World;

struct Preset {
    const char* name;
    Settings (*settings)();
};

Settings sleeping() {
    Settings s = Settings::steady();
    s.sleeping = true;
    return s;
}

constexpr Preset kPresets[] = {{"steady", Settings::steady},
                               {"fast", Settings::fast},
                               {"seed", Settings::seed},
                               {"sleeping", sleeping}};

engine::Shape drum(const std::vector<Plate>& plates) {
    std::vector<engine::ShapePart> parts;
    for (const Plate& plate : plates) {
        std::vector<Vec3> corners;
        for (int i = 0; i < 8; ++i)
            corners.push_back(plate.halfSize.cwiseProduct(
                Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
        parts.push_back({*engine::Shape::hullOf(corners), plate.pose});
    }
    return engine::Shape::compound(parts);
}

engine::Shape shapeOf(const Body& body) {
    switch (body.kind) {
        case Kind::sphere: return engine::Shape::sphere(body.radius);
        case Kind::capsule:
            return engine::Shape::capsule(body.radius, 2.0 * (body.radius + body.halfSize.y()));
        case Kind::hull: return *engine::Shape::hullOf(body.corners);
        case Kind::drum: return drum(body.plates);
        case Kind::mesh: return engine::Shape::meshOf(body.corners, body.triangles);
        default: return engine::Shape::box(2.0 * body.halfSize);
    }
}

BodyDef bodyDef(const Body& body, const Scene& scene) {
    BodyDef def;
    def.kind = body.dynamic ? BodyKind::dynamic
                            : body.turns() ? BodyKind::kinematic : BodyKind::fixed;
    def.shape = shapeOf(body);
    def.material = {.density = body.density, .friction = scene.friction,
                    .restitution = scene.restitution};
    if (body.kind == Kind::hull) {  // as for the other engines
        def.mass = body.mass();
        def.inertia = body.inertia().asDiagonal();
    }
    def.pose = body.pose;
    def.velocity = body.velocity, def.spin = body.spin;
    def.collide = body.collide;
    return def;
}

JointDef jointDef(const Joint& joint, const World& world) {
    JointDef def;
    def.type = joint.isHinge ? JointType::hinge : JointType::ball;
    def.a = {joint.a}, def.b = {joint.b};
    def.anchorA = world.pose(def.a).toLocal(joint.at);
    def.anchorB = world.pose(def.b).toLocal(joint.at);
    def.axis = joint.axis;
    if (joint.isLimited() && joint.isHinge) def.free[0].limits = {-joint.most, joint.most};
    if (joint.isLimited() && !joint.isHinge) {
        def.free[0].limits = {-joint.twist, joint.twist};
        def.free[1].limits.high = joint.most;
    }
    return def;
}

class Impulse : public Engine {
public:
    explicit Impulse(const Settings& settings) : world_(settings) {}

    void build(const Scene& scene) override {
        world_.setGravity(scene.gravity);
        Settings settings = world_.settings();
        settings.sleeping = settings.sleeping || scene.sleeps;
        world_.setSettings(settings);
        for (const Body& body : scene.bodies) world_.add(bodyDef(body, scene));
        for (const Joint& joint : scene.joints) world_.add(jointDef(joint, world_));
    }

    bool step(double dt) override { return world_.step(dt); }

    BodyState state(int body) const override {
        return {world_.pose({body}), world_.velocity({body}), world_.spin({body})};
    }

    int contactPoints() const override { return static_cast<int>(world_.contacts().size()); }

private:
    World world_;
};

}  // namespace

std::string engineName() { return "impulse"; }

std::vector<std::string> presetNames() {
    std::vector<std::string> names;
    for (const Preset& preset : kPresets) names.push_back(preset.name);
    return names;
}

std::unique_ptr<Engine> makeEngine(const std::string& preset, int threads) {
    for (const Preset& p : kPresets) {
        if (preset != p.name || threads < 1) continue;
        Settings settings = p.settings();
        settings.threads = threads;
        return std::make_unique<Impulse>(settings);
    }
    return {};
}

}  // namespace peers
