// ODE with its defaults (QuickStep, 20 sweeps, double precision in Debian), for the benchmark.
// Preset "direct" is its exact solver (dWorldStep). Sleeping and damping are off.
#include <ode/ode.h>

#include <array>

#include "tests/benchmark/peer_engine.h"

namespace peers {

namespace {

struct Preset {
    const char* name;
    int sweeps = 0;  // a sub-step; 0: ODE's own 20
    int substeps = 1;
    bool direct = false;
};

constexpr Preset kPresets[] = {
    {"default"},         {"sweeps100", 100},     {"sweeps50", 50},
    {"substeps4", 0, 4}, {"direct", 0, 1, true}, {"directSubsteps4", 0, 4, true}};

constexpr int kMostPoints = 8;  // of one pair

Vec3 vector(const dReal* v) { return {v[0], v[1], v[2]}; }

std::array<dReal, 4> quaternion(const Quat& q) { return {q.w(), q.x(), q.y(), q.z()}; }

class Ode : public Engine {
public:
    explicit Ode(const Preset& preset) : preset_(preset) {
        dInitODE2(0);
        dRandSetSeed(0);  // QuickStep shuffles its rows: the same in every run
        world_ = dWorldCreate();
        space_ = dHashSpaceCreate(nullptr);
        contacts_ = dJointGroupCreate(0);
        if (preset.sweeps > 0) dWorldSetQuickStepNumIterations(world_, preset.sweeps);
        dWorldSetAutoDisableFlag(world_, 0);
    }

    ~Ode() override {
        dJointGroupDestroy(contacts_);
        dSpaceDestroy(space_);
        dWorldDestroy(world_);
        dCloseODE();
    }

    bool supports(const Scene& scene) const override {
        for (const Body& body : scene.bodies)
            if (body.turns() || (body.kind != Kind::box && body.kind != Kind::sphere)) return false;
        for (const Joint& joint : scene.joints)
            if (joint.isLimited()) return false;
        return true;
    }

    void build(const Scene& scene) override {
        if (scene.sleeps) dWorldSetAutoDisableFlag(world_, 1);
        restitution_ = scene.restitution;
        friction_ = scene.friction;
        scene_ = &scene;
        dWorldSetGravity(world_, scene.gravity.x(), scene.gravity.y(), scene.gravity.z());
        for (const Body& body : scene.bodies) {
            bodies_.push_back(body.dynamic ? addBody(body) : nullptr);
            if (body.collide) addShape(body, bodies_.back());
        }
        for (const Joint& joint : scene.joints) addJoint(joint);
    }

    bool step(double dt) override {
        for (int i = 0; i < preset_.substeps; ++i) {
            points_ = 0;
            dSpaceCollide(space_, this, &Ode::meet);
            if (preset_.direct)
                dWorldStep(world_, dt / preset_.substeps);
            else
                dWorldQuickStep(world_, dt / preset_.substeps);
            dJointGroupEmpty(contacts_);
        }
        return true;
    }

    BodyState state(int body) const override {
        const dBodyID b = bodies_[body];
        if (!b) return {scene_->bodies[body].pose};
        const dReal* q = dBodyGetQuaternion(b);
        return {{vector(dBodyGetPosition(b)), Quat(q[0], q[1], q[2], q[3])},
                vector(dBodyGetLinearVel(b)),
                vector(dBodyGetAngularVel(b))};
    }

    int contactPoints() const override { return points_; }

private:
    dBodyID addBody(const Body& body) {
        const dBodyID b = dBodyCreate(world_);
        dMass mass;
        const Vec3 size = 2.0 * body.halfSize, &at = body.pose.position;
        if (body.kind == Kind::box)
            dMassSetBox(&mass, body.density, size.x(), size.y(), size.z());
        else
            dMassSetSphere(&mass, body.density, body.radius);
        dBodySetMass(b, &mass);
        dBodySetPosition(b, at.x(), at.y(), at.z());
        dBodySetQuaternion(b, quaternion(body.pose.rotation).data());
        dBodySetLinearVel(b, body.velocity.x(), body.velocity.y(), body.velocity.z());
        dBodySetAngularVel(b, body.spin.x(), body.spin.y(), body.spin.z());
        return b;
    }

    void addShape(const Body& body, dBodyID b) {
        const Vec3 size = 2.0 * body.halfSize, &at = body.pose.position;
        const dGeomID shape = body.kind == Kind::box ? dCreateBox(space_, size.x(), size.y(), size.z())
                                         : dCreateSphere(space_, body.radius);
        if (b) return dGeomSetBody(shape, b);
        dGeomSetPosition(shape, at.x(), at.y(), at.z());
        dGeomSetQuaternion(shape, quaternion(body.pose.rotation).data());
    }

    void addJoint(const Joint& joint) {
        const dJointID j =
            joint.isHinge ? dJointCreateHinge(world_, nullptr) : dJointCreateBall(world_, nullptr);
        dJointAttach(j, bodies_[joint.a], bodies_[joint.b]);
        const Vec3 &at = joint.at, &axis = joint.axis;
        if (!joint.isHinge) return dJointSetBallAnchor(j, at.x(), at.y(), at.z());
        dJointSetHingeAnchor(j, at.x(), at.y(), at.z());
        dJointSetHingeAxis(j, axis.x(), axis.y(), axis.z());
    }

    /// ODE calls this for every pair of shapes that are near each other.
    static void meet(void* self, dGeomID shapeA, dGeomID shapeB) {
        const dBodyID a = dGeomGetBody(shapeA), b = dGeomGetBody(shapeB);
        if (!a && !b) return;
        if (a && b && dAreConnectedExcluding(a, b, dJointTypeContact)) return;
        Ode& ode = *static_cast<Ode*>(self);
        dContact points[kMostPoints];
        const int count = dCollide(shapeA, shapeB, kMostPoints, &points[0].geom, sizeof(dContact));
        for (int i = 0; i < count; ++i) {
            points[i].surface.mode = dContactApprox1;  // a friction pyramid, mu times the force
            if (ode.restitution_ > 0.0) points[i].surface.mode |= dContactBounce;
            points[i].surface.bounce = ode.restitution_;
            points[i].surface.mu = ode.friction_;
            dJointAttach(dJointCreateContact(ode.world_, ode.contacts_, &points[i]), a, b);
        }
        ode.points_ += count;
    }

    Preset preset_;
    dWorldID world_;
    dSpaceID space_;
    dJointGroupID contacts_;
    double friction_ = 0.0, restitution_ = 0.0;
    const Scene* scene_ = nullptr;
    std::vector<dBodyID> bodies_;  // null: fixed
    int points_ = 0;
};

}  // namespace

std::string engineName() { return "ODE"; }

std::vector<std::string> presetNames() {
    std::vector<std::string> names;
    for (const Preset& preset : kPresets) names.push_back(preset.name);
    return names;
}

std::unique_ptr<Engine> makeEngine(const std::string& preset, int threads) {
    for (const Preset& p : kPresets)
        if (preset == p.name && threads == 1) return std::make_unique<Ode>(p);
    return {};
}

}  // namespace peers
