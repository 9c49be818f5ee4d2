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

BodyDef bodyDef(const Body& body, double friction) {
    BodyDef def;
    def.kind = body.dynamic ? BodyKind::dynamic : BodyKind::fixed;
    def.shape =
        body.isBox ? engine::Shape::box(2.0 * body.halfSize) : engine::Shape::sphere(body.radius);
    def.material = {.density = body.density, .friction = friction, .restitution = 0.0};
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
    return def;
}

class Impulse : public Engine {
public:
    explicit Impulse(const Settings& settings) : world_(settings) {}

    void build(const Scene& scene) override {
        world_.setGravity(scene.gravity);
        for (const Body& body : scene.bodies) world_.add(bodyDef(body, scene.friction));
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
