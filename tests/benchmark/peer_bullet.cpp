// Bullet with its defaults (10 sweeps, split impulse, single precision in Debian), for the benchmark.
// Sleeping and damping are off, as in the other engines.
#include <btBulletDynamicsCommon.h>

#include <cmath>

#include "tests/benchmark/peer_engine.h"

namespace peers {

namespace {

struct Preset {
    const char* name;
    int sweeps = 10;   // a sub-step
    int substeps = 1;  // a step
};

constexpr Preset kPresets[] = {{"default"},
                               {"sweeps50", 50},
                               {"sweeps4", 4},
                               {"substeps4", 10, 4},
                               {"substeps4sweeps4", 4, 4}};

btScalar scalar(double x) { return static_cast<btScalar>(x); }
btVector3 vector(const Vec3& v) { return {scalar(v.x()), scalar(v.y()), scalar(v.z())}; }
double wide(btScalar x) { return static_cast<double>(x); }
Vec3 vector(const btVector3& v) { return {wide(v.x()), wide(v.y()), wide(v.z())}; }

btTransform transform(const Pose& pose) {
    const Quat& q = pose.rotation;
    const btQuaternion rotation(scalar(q.x()), scalar(q.y()), scalar(q.z()), scalar(q.w()));
    return btTransform(rotation, vector(pose.position));
}

std::unique_ptr<btCollisionShape> makeShape(const Body& body) {
    if (body.isBox) return std::make_unique<btBoxShape>(vector(body.halfSize));
    return std::make_unique<btSphereShape>(scalar(body.radius));
}

std::unique_ptr<btRigidBody> makeBody(const Body& body, btCollisionShape* shape, double friction) {
    const btVector3 inertia = body.dynamic ? vector(body.inertia()) : btVector3(0, 0, 0);
    btRigidBody::btRigidBodyConstructionInfo info(scalar(body.dynamic ? body.mass() : 0.0), nullptr,
                                                  shape, inertia);
    info.m_startWorldTransform = transform(body.pose);
    info.m_friction = scalar(std::sqrt(friction));  // Bullet multiplies the two
    info.m_restitution = 0;
    info.m_linearDamping = info.m_angularDamping = 0;
    auto result = std::make_unique<btRigidBody>(info);
    result->setActivationState(DISABLE_DEACTIVATION);
    result->setLinearVelocity(vector(body.velocity));
    result->setAngularVelocity(vector(body.spin));
    return result;
}

class Bullet : public Engine {
public:
    explicit Bullet(const Preset& preset) : substeps_(preset.substeps) {
        world_.getSolverInfo().m_numIterations = preset.sweeps;
        world_.getSolverInfo().m_splitImpulse = true;
    }

    ~Bullet() override {
        for (auto& joint : joints_) world_.removeConstraint(joint.get());
        for (auto& body : bodies_) world_.removeRigidBody(body.get());
    }

    void build(const Scene& scene) override {
        world_.setGravity(vector(scene.gravity));
        for (const Body& body : scene.bodies) add(body, scene.friction);
        for (const Joint& joint : scene.joints) add(joint, scene);
    }

    bool step(double dt) override {
        for (int i = 0; i < substeps_; ++i) world_.stepSimulation(scalar(dt / substeps_), 0);
        return true;
    }

    BodyState state(int body) const override {
        const btRigidBody& b = *bodies_[body];
        const btQuaternion q = b.getWorldTransform().getRotation();
        const Quat rotation(wide(q.w()), wide(q.x()), wide(q.y()), wide(q.z()));
        return {{vector(b.getWorldTransform().getOrigin()), rotation},
                vector(b.getLinearVelocity()),
                vector(b.getAngularVelocity())};
    }

    int contactPoints() const override {
        int points = 0;
        for (int i = 0; i < dispatcher_.getNumManifolds(); ++i)
            points += dispatcher_.getManifoldByIndexInternal(i)->getNumContacts();
        return points;
    }

private:
    void add(const Body& body, double friction) {
        shapes_.push_back(makeShape(body));
        bodies_.push_back(makeBody(body, shapes_.back().get(), friction));
        if (body.collide)
            world_.addRigidBody(bodies_.back().get());
        else
            world_.addRigidBody(bodies_.back().get(), 2, 0);  // in group 2, collides with no group
    }

    void add(const Joint& joint, const Scene& scene) {
        const Pose &poseA = scene.bodies[joint.a].pose, &poseB = scene.bodies[joint.b].pose;
        const btVector3 a = vector(poseA.toLocal(joint.at)), b = vector(poseB.toLocal(joint.at));
        const btVector3 axisA = vector(Vec3(poseA.rotation.conjugate() * joint.axis));
        const btVector3 axisB = vector(Vec3(poseB.rotation.conjugate() * joint.axis));
        btRigidBody &bodyA = *bodies_[joint.a], &bodyB = *bodies_[joint.b];
        if (joint.isHinge)
            joints_.push_back(
                std::make_unique<btHingeConstraint>(bodyA, bodyB, a, b, axisA, axisB));
        else
            joints_.push_back(std::make_unique<btPoint2PointConstraint>(bodyA, bodyB, a, b));
        world_.addConstraint(joints_.back().get(), true);  // true: joined bodies do not collide
    }

    int substeps_;
    btDefaultCollisionConfiguration configuration_;
    mutable btCollisionDispatcher dispatcher_{&configuration_};  // counting is not const in Bullet
    btDbvtBroadphase broadPhase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broadPhase_, &solver_, &configuration_};
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    std::vector<std::unique_ptr<btTypedConstraint>> joints_;
};

}  // namespace

std::string engineName() { return "Bullet"; }

std::vector<std::string> presetNames() {
    std::vector<std::string> names;
    for (const Preset& preset : kPresets) names.push_back(preset.name);
    return names;
}

std::unique_ptr<Engine> makeEngine(const std::string& preset, int threads) {
    for (const Preset& p : kPresets)
        if (preset == p.name && threads == 1) return std::make_unique<Bullet>(p);
    return {};
}

}  // namespace peers
