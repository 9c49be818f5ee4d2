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

std::unique_ptr<btConvexHullShape> hullOf(const std::vector<Vec3>& corners) {
    auto hull = std::make_unique<btConvexHullShape>();
    for (const Vec3& corner : corners) hull->addPoint(vector(corner), false);
    hull->recalcLocalAabb();
    return hull;
}

/// A shape, and the parts that it refers to.
struct OwnedShape {
    std::unique_ptr<btCollisionShape> shape;
    std::vector<std::unique_ptr<btCollisionShape>> parts;
    std::unique_ptr<btTriangleMesh> mesh;
};

OwnedShape drumOf(const Body& body) {
    OwnedShape owned;
    auto compound = std::make_unique<btCompoundShape>();
    for (const Plate& plate : body.plates) {
        std::vector<Vec3> corners;
        for (int i = 0; i < 8; ++i)
            corners.push_back(plate.halfSize.cwiseProduct(
                Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
        owned.parts.push_back(hullOf(corners));
        compound->addChildShape(transform(plate.pose), owned.parts.back().get());
    }
    owned.shape = std::move(compound);
    return owned;
}

OwnedShape meshOf(const Body& body) {
    OwnedShape owned;
    owned.mesh = std::make_unique<btTriangleMesh>();
    for (const auto& [a, b, c] : body.triangles)
        owned.mesh->addTriangle(vector(body.corners[a]), vector(body.corners[b]),
                                vector(body.corners[c]));
    owned.shape = std::make_unique<btBvhTriangleMeshShape>(owned.mesh.get(), true);
    return owned;
}

OwnedShape makeShape(const Body& body) {
    OwnedShape owned;
    switch (body.kind) {
        case Kind::drum: return drumOf(body);
        case Kind::mesh: return meshOf(body);
        case Kind::hull: owned.shape = hullOf(body.corners); break;
        case Kind::sphere:
            owned.shape = std::make_unique<btSphereShape>(scalar(body.radius));
            break;
        case Kind::capsule:
            owned.shape = std::make_unique<btCapsuleShape>(scalar(body.radius),
                                                           scalar(2.0 * body.halfSize.y()));
            break;
        default: owned.shape = std::make_unique<btBoxShape>(vector(body.halfSize));
    }
    return owned;
}

/// A rotation whose x axis is `axis`, for a cone.
btTransform frameAlong(const btVector3& axis, const btVector3& at) {
    const btVector3 x = axis.normalized();
    const btVector3 y = x.cross(std::abs(x.y()) < .9f ? btVector3(0, 1, 0) : btVector3(1, 0, 0))
                            .normalized();
    const btVector3 z = x.cross(y);
    return btTransform(btMatrix3x3(x.x(), y.x(), z.x(), x.y(), y.y(), z.y(), x.z(), y.z(), z.z()), at);
}

std::unique_ptr<btRigidBody> makeBody(const Body& body, btCollisionShape* shape,
                                      const Scene& scene) {
    const btVector3 inertia = body.dynamic ? vector(body.inertia()) : btVector3(0, 0, 0);
    btRigidBody::btRigidBodyConstructionInfo info(scalar(body.dynamic ? body.mass() : 0.0), nullptr,
                                                  shape, inertia);
    info.m_startWorldTransform = transform(body.pose);
    info.m_friction = scalar(std::sqrt(scene.friction));  // Bullet multiplies the two
    info.m_restitution = scalar(std::sqrt(scene.restitution));
    info.m_linearDamping = info.m_angularDamping = 0;
    auto result = std::make_unique<btRigidBody>(info);
    if (!scene.sleeps) result->setActivationState(DISABLE_DEACTIVATION);
    if (body.turns()) result->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
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
        scene_ = &scene;
        world_.setGravity(vector(scene.gravity));
        for (const Body& body : scene.bodies) add(body, scene);
        for (const Joint& joint : scene.joints) add(joint, scene);
    }

    bool step(double dt) override {
        for (int i = 0; i < substeps_; ++i) {
            time_ += dt / substeps_;
            turnDrums();
            world_.stepSimulation(scalar(dt / substeps_), 0);
        }
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
    /// A kinematic body is where the caller puts it; Bullet finds its velocity from that.
    void turnDrums() {
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const Body& body = scene_->bodies[i];
            if (!body.turns()) continue;
            const double speed = body.spin.norm();
            Pose pose = body.pose;
            pose.rotation = Quat(Eigen::AngleAxisd(speed * time_, body.spin / speed)) * pose.rotation;
            bodies_[i]->setWorldTransform(transform(pose));
        }
    }

    void add(const Body& body, const Scene& scene) {
        shapes_.push_back(makeShape(body));
        bodies_.push_back(makeBody(body, shapes_.back().shape.get(), scene));
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
        if (joint.isHinge) {
            auto hinge = std::make_unique<btHingeConstraint>(bodyA, bodyB, a, b, axisA, axisB);
            if (joint.isLimited()) hinge->setLimit(scalar(-joint.most), scalar(joint.most));
            joints_.push_back(std::move(hinge));
        } else if (joint.isLimited()) {
            const btTransform inWorld = frameAlong(vector(joint.axis), vector(joint.at));
            auto cone = std::make_unique<btConeTwistConstraint>(
                bodyA, bodyB, transform(poseA).inverse() * inWorld,
                transform(poseB).inverse() * inWorld);
            cone->setLimit(scalar(joint.most), scalar(joint.most), scalar(joint.twist));
            joints_.push_back(std::move(cone));
        } else
            joints_.push_back(std::make_unique<btPoint2PointConstraint>(bodyA, bodyB, a, b));
        world_.addConstraint(joints_.back().get(), true);  // true: joined bodies do not collide
    }

    int substeps_;
    double time_ = 0.0;  // s
    const Scene* scene_ = nullptr;
    btDefaultCollisionConfiguration configuration_;
    mutable btCollisionDispatcher dispatcher_{&configuration_};  // counting is not const in Bullet
    btDbvtBroadphase broadPhase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broadPhase_, &solver_, &configuration_};
    std::vector<OwnedShape> shapes_;
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
