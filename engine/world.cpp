#include "engine/world.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/check.h"
#include "engine/collision/ray_cast.h"
#include "engine/dynamics/forces.h"
#include "engine/dynamics/integration.h"
#include "engine/solver/nudges.h"
#include "engine/solver/prepare_contacts.h"
#include "engine/solver/solve.h"
#include "engine/world_checks.h"
#include "engine/world_joints.h"
#include "engine/world_limits.h"
#include "engine/world_looks.h"
#include "engine/world_paces.h"
#include "engine/world_sleep.h"

namespace engine {
namespace {

constexpr const char* kNoSuchBody = "there is no such body; it was removed or never added";
constexpr const char* kNoSuchJoint = "there is no such joint; it was removed or never added";

/// As if the caller had just placed all bodies: what depends on their bounds is found again.
void placeAll(WorldState& s) {
    for (int i = 0; i < s.bodies.count(); ++i) {
        if (!s.bodies.present[i]) continue;
        s.bodies.placed[i] = 1;
        activate(s.bodies, i);
    }
    s.contactsStale = true;
}

}  // namespace

World::World(const Settings& settings) : state_(std::make_unique<WorldState>()) {
    state_->finder.workers = &state_->solver.workers;
    setSettings(settings);
}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

/// The six steps of the second seed, in its order. The first five are done in every sub-step; collision
/// detection runs at the end, and within the step only for fast bodies.
bool World::step(double dt) {
    WorldState& s = *state_;
    checkIdle(s);
    ENGINE_CHECK(dt > 0.0 && std::isfinite(dt),
                 "a step needs a positive time; reading the world needs no step");
    if (!beginStep(s, dt)) return false;
    const double h = dt / s.report.substeps;
    for (int i = 0; i < s.report.substeps; ++i) {
        beginSubstep(s, i);                                   // world_paces.cpp
        if (looksAgain(s, i, h)) findContactsWithin(s, i, h);  // for fast bodies: world_looks.cpp
        s.phase(Phase::forces, i);
        evaluateForces(*this, s, i, h);                  // world_state.cpp, forces/
        applyForces(s.bodies, s.gravity, s.fieldLoads);  // dynamics/forces.cpp

        s.phase(Phase::velocities, i);
        integrateVelocities(s.bodies, s.settings.gyroscope);  // dynamics/integration.cpp
        limitSpeeds(s);                                       // world_limits.cpp

        s.phase(Phase::impulses, i);
        updateSeparations(s.bodies, s.solver);  // solver/prepare_contacts.cpp
        solveConstraints(s.solver, s.bodies, s.settings, h, s.report);  // solver/solve.cpp

        s.phase(Phase::positions, i);
        integratePositions(s.bodies, s.settings.gyroscope);  // dynamics/integration.cpp

        s.phase(Phase::nudges, i);
        const int untilSeen = s.hasForces() ? 0 : s.report.substeps - i;
        solveNudges(s.joints, s.bodies, s.solver, s.settings, h, untilSeen);  // solver/nudges.cpp
        s.substeps.measure(s.joints, s.bodies, s.solver);  // solver/substeps.cpp
    }
    s.phase(Phase::collisions, s.report.substeps - 1);
    if (!staysFinite(s)) return step(dt);  // without the removed bodies
    if (turnedTooFast(s, dt)) return step(dt);  // with more sub-steps
    return endStep(s, dt);  // world_state.cpp: collision/contacts.cpp, solved in the next step
}

BodyId World::add(const BodyDef& def) {
    WorldState& s = *state_;
    checkIdle(s);
    checkBody(def);
    s.contactsStale = true;
    const int i = s.bodySlots.take();
    addBody(s.bodies, def, i);
    s.sleep.add(s.bodies, i);
    if (def.shape.type == ShapeType::plane || !def.collide) s.untreed.push_back(i);
    return s.bodyId(i);
}

JointId World::add(const JointDef& def) {
    WorldState& s = *state_;
    checkIdle(s);
    ENGINE_CHECK(has(def.a) && has(def.b), "a joint needs two bodies of this world");
    checkJoint(s, def);
    const int i = s.jointSlots.take();
    s.joints.resize(larger(s.joints.size(), std::size_t(i) + 1));
    s.joints[i] = makeJoint(s, def);
    for (const BodyId id : {def.a, def.b}) s.sleep.call(s.bodies, id.index);
    s.jointsStale = s.contactsStale = true;
    return s.jointId(i);
}

ForceId World::add(const ForceDef& def) {
    checkIdle(*state_);
    ENGINE_CHECK(std::ranges::all_of(def.on, [&](BodyId id) { return has(id); }),
                 "a force needs bodies of this world");
    checkForce(def);
    WorldState& s = *state_;
    const int i = s.forceSlots.take();
    s.forces.resize(larger(s.forces.size(), std::size_t(i) + 1));
    s.forces[i] = def;
    ++s.forceCount;
    return {i, s.forceSlots.generation(i)};
}

void World::remove(BodyId id) {
    checkIdle(*state_);
    ENGINE_CHECK(has(id), kNoSuchBody);
    removeBody(*state_, id);
}

void World::remove(JointId id) {
    WorldState& s = *state_;
    checkIdle(s);
    ENGINE_CHECK(s.jointSlots.knows(id.index, id.generation) && s.joints[id.index].present,
                 kNoSuchJoint);
    Joint& joint = s.joints[id.index];
    for (const BodyId body : {joint.def.a, joint.def.b}) s.sleep.call(s.bodies, body.index);
    joint.present = false;
    s.jointSlots.remove(id.index);
    s.jointsStale = s.contactsStale = true;
}

void World::remove(ForceId id) {
    WorldState& s = *state_;
    checkIdle(s);
    ENGINE_CHECK(s.forceSlots.knows(id.index, id.generation) && s.forces[id.index],
                 "there is no such force; it was removed or never added");
    for (const BodyId body : s.forces[id.index]->on) s.sleep.call(s.bodies, body.index);
    s.forces[id.index].reset();
    --s.forceCount;
    s.fieldLoads.clear();
    s.forceSlots.remove(id.index);
}

void World::setSettings(const Settings& settings) {
    checkIdle(*state_);
    checkSettings(settings);
    if (settings.speculativeMargin != state_->settings.speculativeMargin) placeAll(*state_);
    state_->settings = settings;
    state_->sleep.callAll(state_->bodies);
    state_->solver.workers.setCount(settings.threads);
    state_->substeps = {};
    state_->jointsStale = true;
}

const Settings& World::settings() const { return state_->settings; }
void World::setGravity(const Vec3& gravity) {
    checkIdle(*state_);
    ENGINE_CHECK(gravity.allFinite(), "gravity must be finite");
    if (gravity != state_->gravity) state_->sleep.callAll(state_->bodies);
    state_->gravity = gravity;
}
const Vec3& World::gravity() const { return state_->gravity; }
int World::bodyCount() const { return state_->bodies.count(); }
int World::jointCount() const { return static_cast<int>(state_->joints.size()); }

std::optional<RayHit> World::castRay(const Vec3& from, const Vec3& to,
                                     const std::function<bool(BodyId)>& wanted) const {
    ENGINE_CHECK(from.allFinite() && to.allFinite(), "both ends of a ray must be finite");
    const WorldState& s = *state_;
    std::optional<RayHit> first;
    const auto look = [&](int i) {
        const BodyDef& def = s.bodies.defs[i];
        const double most = first ? first->fraction : 1.0;
        if (!(wanted ? wanted(s.bodyId(i)) : def.collide && !def.sensor)) return most;
        const auto hit = enterShape(def.shape, s.bodies.poses[i], from, to);
        if (!hit || hit->fraction > most) return most;
        if (first && hit->fraction == most && i > first->body.index) return most;
        first = RayHit{s.bodyId(i), hit->fraction, from + hit->fraction * (to - from), hit->normal};
        return hit->fraction;
    };
    for (const int i : s.untreed) look(i);
    if (s.contactsStale)  // the tree does not include the caller's latest changes
        for (int i = 0; i < s.bodies.count(); ++i)
            if (s.bodies.present[i] && s.bodies.placed[i]) look(i);
    s.finder.broadPhase.tree().along(from, to, first ? first->fraction : 1.0, look);
    return first;
}

bool World::has(BodyId id) const {
    return state_->bodySlots.knows(id.index, id.generation) && state_->bodies.present[id.index];
}

const BodyDef& World::def(BodyId id) const {
    ENGINE_CHECK(state_->bodySlots.knows(id.index, id.generation), kNoSuchBody);
    return state_->bodies.defs[id.index];
}
const Pose& World::pose(BodyId id) const {
    ENGINE_CHECK(state_->bodySlots.knows(id.index, id.generation), kNoSuchBody);
    return state_->bodies.poses[id.index];
}
const Vec3& World::velocity(BodyId id) const {
    ENGINE_CHECK(state_->bodySlots.knows(id.index, id.generation), kNoSuchBody);
    return state_->bodies.velocities[id.index].linear;
}
const Vec3& World::spin(BodyId id) const {
    ENGINE_CHECK(state_->bodySlots.knows(id.index, id.generation), kNoSuchBody);
    return state_->bodies.velocities[id.index].angular;
}
bool World::isAsleep(BodyId id) const {
    ENGINE_CHECK(state_->bodySlots.knows(id.index, id.generation), kNoSuchBody);
    return state_->sleep.staysAsleep(state_->bodies, id.index);
}
double World::mass(BodyId id) const {
    ENGINE_CHECK(state_->bodySlots.knows(id.index, id.generation), kNoSuchBody);
    return state_->bodies.masses[id.index].mass;
}
const Mat3& World::inertia(BodyId id) const {
    ENGINE_CHECK(state_->bodySlots.knows(id.index, id.generation), kNoSuchBody);
    return state_->bodies.masses[id.index].inertia;
}

JointState World::joint(JointId id) const {
    ENGINE_CHECK(state_->jointSlots.knows(id.index, id.generation), kNoSuchJoint);
    return stateOf(*state_, state_->joints[id.index]);
}

void World::setFreedom(JointId id, int coordinate, const Freedom& freedom) {
    checkIdle(*state_);
    ENGINE_CHECK(state_->jointSlots.knows(id.index, id.generation) &&
                     state_->joints[id.index].present,
                 kNoSuchJoint);
    checkFreedom(state_->joints[id.index].def.type, coordinate, freedom);
    JointDef& def = state_->joints[id.index].def;
    def.free[coordinate] = freedom;
    state_->joints[id.index].acts = def.acts();
    for (const BodyId body : {def.a, def.b}) state_->sleep.call(state_->bodies, body.index);
    state_->jointsStale = true;
}

void World::setPose(BodyId id, const Pose& pose) {
    ENGINE_CHECK(has(id), kNoSuchBody);
    WorldState& s = *state_;
    checkIdle(s);
    checkPose(pose);
    callAround(s, id.index);
    s.bodies.placed[id.index] = 1;
    activate(s.bodies, id.index);
    s.bodies.poses[id.index] = pose;
    s.bodies.poses[id.index].rotation.normalize();
    updateInverseInertia(s.bodies, id.index);
    findOnPaths(s, id.index);
    s.contactsStale = s.jointsStale = true;
}

void World::setVelocity(BodyId id, const Vec3& velocity, const Vec3& spin) {
    checkIdle(*state_);
    ENGINE_CHECK(has(id) && def(id).kind != BodyKind::fixed,
                 "only a dynamic or kinematic body has a velocity");
    Bodies& bodies = state_->bodies;
    const bool wasDriven = bodies.isDriven(id.index);
    bodies.velocities[id.index] = {velocity, spin};
    state_->solver.constraints.ratesStale = true;
    if (bodies.isDynamic(id.index) || bodies.isDriven(id.index) != wasDriven)
        callAround(*state_, id.index);
}

void World::applyForce(BodyId id, const Vec3& force, const Vec3& torque) {
    checkIdle(*state_);
    ENGINE_CHECK(has(id), kNoSuchBody);
    if (def(id).kind == BodyKind::fixed) return;
    state_->sleep.call(state_->bodies, id.index);
    state_->bodies.loads[id.index].force += force;
    state_->bodies.loads[id.index].torque += torque;
}

void World::applyImpulse(BodyId id, const Vec3& impulse, const Vec3& at) {
    checkIdle(*state_);
    ENGINE_CHECK(has(id), kNoSuchBody);
    Bodies& bodies = state_->bodies;
    state_->sleep.call(bodies, id.index);
    // dv = P / m, dw = I^-1 (r x P)
    const InverseMass& m = bodies.inverseMasses[id.index];
    const Vec3 arm = at - bodies.poses[id.index].position;
    bodies.velocities[id.index].linear += m.linear * impulse;
    bodies.velocities[id.index].angular += m.angular * arm.cross(impulse);
}

void World::findContacts() {
    checkIdle(*state_);
    findContactsNow(*state_);
}
std::vector<ContactState> World::contacts() const {
    std::vector<ContactState> states;
    listContacts(*state_, states);
    return states;
}
ErrorReport World::errors() const { return errorsOf(*state_); }

void World::watchTouches(bool watch) {
    checkIdle(*state_);
    state_->touches = {};
    state_->touches.watched = watch;
}
std::span<const TouchEvent> World::touches() const { return state_->touches.events; }

const StepReport& World::report() const { return state_->report; }

Energy World::energy() const { return energyNow(*state_); }

std::uint64_t World::hash() const {
    StateHash hash;
    const Bodies& bodies = state_->bodies;
    for (int i = 0; i < bodies.count(); ++i) {
        hash.add(static_cast<std::uint64_t>(bodies.present[i] != 0));
        hash.add(bodies.poses[i].position), hash.add(bodies.poses[i].rotation);
        hash.add(bodies.velocities[i].linear), hash.add(bodies.velocities[i].angular);
    }
    return hash.value();
}

void World::setForceField(std::function<void(const World&, std::span<Load>)> field) {
    checkIdle(*state_);
    state_->sleep.callAll(state_->bodies);
    state_->field = std::move(field);
    state_->fieldLoads.clear();
}

void World::observe(std::function<void(Phase, int)> observer) {
    checkIdle(*state_);
    state_->observer = std::move(observer);
}

}  // namespace engine
