#include "engine/solver/substeps.h"

namespace engine {
namespace {

constexpr double kSwingPerSubstep = 1.0;  // rad of the links' own oscillation
constexpr double kTurnPerSubstep = 0.1;   // rad
constexpr double kTurnInTouch = 0.3;      // rad, with contacts
constexpr double kTurnInNet = 0.5;        // rad
constexpr double kChangesAhead = 2.0;     // steps
constexpr int kMostUsual = 32;            // sub-steps
constexpr int kMostJoints = 2048;         // sub-steps times joints
constexpr double kWayPerSubstep = 0.5;    // times the thinner body's thickness, in a sub-step
constexpr int kMany = 50;                 // fewer contacts than one in so many do not count
constexpr double kHeavy = 10.0;           // ratio of masses
constexpr double kSubstepsARatio = 8.0 / 50.0, kLeastHeavy = 4.0, kMostHeavy = 8.0;
constexpr double kVeryHeavy = 100.0, kSubstepsALevel = 3.2;
constexpr double kShortRod = 1e-3;        // m
constexpr double kCalm = 1.0;             // s
constexpr double kCalmOfJoints = 10.0;    // s

/// omega^2 of a body pulled by the force f at the arm r: f r / I, with I perpendicular to the arm.
double swingSquared(const InverseMass& mass, const Vec3& arm, double force) {
    const double r = arm.norm();
    if (r == 0.0 || mass.linear == 0.0) return 0.0;
    const Vec3 along = arm / r;
    const double across = 0.5 * (mass.angular.trace() - along.dot(mass.angular * along));
    return force * r * across;
}

/// rad/s, without a wheel's spin about its axle, which turns no arm.
double turnOfB(const Joint& joint, const Bodies& bodies) {
    const int b = joint.def.b.index;
    const Vec3& spin = bodies.velocities[b].angular;
    if (joint.def.type != JointType::wheel) return spin.norm();
    const Vec3 axle = bodies.poses[b].rotation * joint.axis2B;
    return (spin - axle.dot(spin) * axle).norm();
}

/// From end to end.
Vec3 alongRod(const Joint& joint, const Bodies& bodies) {
    return bodies.poses[joint.def.b.index].toWorld(joint.def.anchorB) -
           bodies.poses[joint.def.a.index].toWorld(joint.def.anchorA);
}

/// How fast a joint turns, rad/s; a rod also by itself: the bodies at its ends need not turn with it.
double turnOf(const JointConstraint& c, const Joint& joint, const Bodies& bodies) {
    const Velocity &va = bodies.velocities[c.a], &vb = bodies.velocities[c.b];
    const double turn = larger(va.angular.norm(), turnOfB(joint, bodies));
    if (joint.def.type != JointType::distance) return turn;
    const Vec3 armA = bodies.poses[c.a].rotation * joint.def.anchorA;
    const Vec3 armB = bodies.poses[c.b].rotation * joint.def.anchorB;
    const Vec3 apart = vb.linear + vb.angular.cross(armB) - va.linear - va.angular.cross(armA);
    const Vec3 along = alongRod(joint, bodies);
    return larger(turn, along.cross(apart).norm() / larger(along.squaredNorm(), kShortRod * kShortRod));
}

/// The rate at which a joint of a tree swings under tension, rad/s.
double swingOf(const JointConstraint& c, const Joint& joint, const Bodies& bodies) {
    const double force = joint.force.norm();
    const InverseMass &a = bodies.inverseMasses[c.a], &b = bodies.inverseMasses[c.b];
    double swing = larger(swingSquared(a, bodies.poses[c.a].rotation * joint.def.anchorA, force),
                          swingSquared(b, bodies.poses[c.b].rotation * joint.def.anchorB, force));
    if (joint.def.type == JointType::distance)
        swing = larger(swing, force / larger(alongRod(joint, bodies).norm(), kShortRod) * (a.linear + b.linear));
    return std::sqrt(swing);
}

/// |w1 - w0|, rad/s: how much the body's rotation changed during the last step.
double changeOfSpin(int body, const Bodies& bodies, std::span<const Velocity> before) {
    if (bodies.spans[body] == 0.0 || !bodies.isDynamic(body)) return 0.0;  // new, or not changed by joints
    if (body >= static_cast<int>(before.size())) return 0.0;
    return (bodies.velocities[body].angular - before[body].angular).norm();
}

/// How many times as heavy a body is as the one it rests on; 0 if one of the two is immovable.
double loadRatio(const Contact& c, const Bodies& bodies, const Vec3& gravity) {
    const double a = bodies.masses[c.a].mass, b = bodies.masses[c.b].mass;
    if (a <= 0.0 || b <= 0.0) return 0.0;
    const double below = gravity.dot(c.normal);  // positive: a is above b
    return larger(below >= 0.0 ? a / b : 0.0, below <= 0.0 ? b / a : 0.0);
}

/// How many times the thinner one's thickness they approach in a step of dt (s); 0 if they do not meet.
double ways(const Contact& c, const Bodies& bodies, double dt) {
    const Vec3 apart = bodies.velocities[c.b].linear - bodies.velocities[c.a].linear;
    const double way = -dt * c.normal.dot(apart), thickness = bodies.thinner(c.a, c.b);
    if (way < thickness) return 0.0;
    const Pose &a = bodies.poses[c.a], &b = bodies.poses[c.b];
    for (const ContactPoint& p : std::span(c.points).first(c.count))
        if (c.normal.dot(b.toWorld(p.anchorB) - a.toWorld(p.anchorA)) < way) return way / thickness;
    return 0.0;
}

/// 4, 8, 12, 16, 24, 32 ...: a power of two times the least, or 1.5 times that; all are multiples of the least.
int nextNumber(int number, int least) {
    int power = least;
    if (number == least) return 2 * least;
    while (2 * power <= number) power *= 2;
    return number + larger(power / 2, 1);
}

int numberFor(double needed, int least, int most) {
    int enough = least;
    while (enough < needed && enough < most) enough = nextNumber(enough, least);
    return smaller(enough, most);
}

}  // namespace

void estimateTension(std::span<Joint> joints, const Bodies& bodies, const Vec3& gravity,
                     Solver& solver, double dt) {
    if (solver.trees.empty()) return;
    std::vector<Velocity> v = bodies.velocities;
    for (int i = 0; i < bodies.count(); ++i) {
        const InverseMass& m = bodies.inverseMasses[i];
        if (!bodies.isDynamic(i)) continue;
        v[i].linear += dt * (gravity + m.linear * bodies.loads[i].force);
        v[i].angular += dt * (m.angular * bodies.loads[i].torque);
    }
    Correction unused;
    solver.trees.beginStep();
    solver.trees.begin(0, 0.0, v);
    solver.trees.setBiasRate(0.0);
    solver.trees.solveVelocities(0, v, unused);
    solver.trees.report(joints, dt);
}

void Substeps::addJoints(DisjointSets& islands, std::span<const Joint> joints, const Bodies& bodies,
                         const Solver& solver, const SubstepChoice& step) {
    const double dt = step.dt;
    for (const int i : solver.trees.whole()) {
        const JointConstraint& c = solver.constraints.joints[i];
        Island& island = islands_[islands.leaderOf(bodies.movable(c.a, c.b))];
        ++island.joints;
        const double turn = turnOf(c, joints[c.joint], bodies);
        const double change =
            larger(changeOfSpin(c.a, bodies, step.before), changeOfSpin(c.b, bodies, step.before));
        const double swing = dt * swingOf(c, joints[c.joint], bodies) / kSwingPerSubstep;
        island.needed = larger(island.needed, smaller(double{kMostUsual}, swing));
        island.turn = larger(island.turn, turn);
        island.turnToCome = larger(island.turnToCome, turn + kChangesAhead * change);
    }
    for (const int i : solver.trees.inNets()) {
        const JointConstraint& c = solver.constraints.joints[i];
        Island& island = islands_[islands.leaderOf(bodies.movable(c.a, c.b))];
        const Joint& joint = joints[c.joint];
        island.needed = larger(island.needed, dt * swingOf(c, joint, bodies) / kSwingPerSubstep);
        island.needed = larger(island.needed, dt * turnOf(c, joint, bodies) / kTurnInNet);
    }
    for (const JointConstraint& c : solver.constraints.joints) {
        if (c.inTree || !c.spring.isSoft()) continue;
        Island& island = islands_[islands.leaderOf(bodies.movable(c.a, c.b))];
        const double swing = dt * swingOf(c, joints[c.joint], bodies) / kSwingPerSubstep;
        island.needed = larger(island.needed, smaller(double{kMostUsual}, swing));
    }
}

void Substeps::addTurns(const Bodies& bodies, double dt) {
    for (const int i : bodies.active) {
        Island& island = islands_[i];
        if (kMany * island.thin > island.contacts)
            island.needed = larger(island.needed, island.thinSum / island.thin);
        island.needed = larger(island.needed, island.touching ? dt * island.turn / kTurnInTouch
                                                              : dt * island.turnToCome / kTurnPerSubstep);
    }
}

void Substeps::addContacts(DisjointSets& islands, std::span<const Contact> contacts,
                           const Bodies& bodies, const Solver& solver, const SubstepChoice& step) {
    columns_.measure(contacts, solver.order, bodies, islands);
    for (const Contact& c : contacts) {
        const int leader = islands.leaderOf(bodies.movable(c.a, c.b));
        Island& island = islands_[leader];
        island.touching = true;
        island.needed = larger(island.needed, columns_.substeps(leader));
        ++island.contacts;
        const double n = ways(c, bodies, step.dt) / kWayPerSubstep;
        if (n > step.settings.substeps) ++island.thin, island.thinSum += n;
        const double ratio = loadRatio(c, bodies, step.gravity);
        if (ratio > kHeavy)
            island.needed = larger(island.needed,
                                   clamped(kSubstepsARatio * ratio, kLeastHeavy, kMostHeavy));
        if (ratio > kVeryHeavy)
            island.needed = larger(island.needed, kSubstepsALevel * columns_.levels(leader));
    }
}

int Substeps::mostOf(const Island& island, const Settings& settings) {
    int most = larger(kMostUsual, settings.substeps);
    if (island.joints > 0 && !island.touching) most = larger(most, kMostJoints / island.joints);
    return smaller(most, larger(settings.maxSubsteps, settings.substeps));
}

int Substeps::choose(DisjointSets& islands, std::span<const Contact> contacts,
                     std::span<const Joint> joints, const Bodies& bodies, const Solver& solver,
                     const SubstepChoice& step) {
    const double dt = step.dt;
    const int least = step.settings.substeps;
    chosen_.resize(bodies.count());
    islands_.resize(bodies.count());
    fastest_.clear();
    for (const int i : bodies.active) islands_[i] = {};
    if (step.settings.maxSubsteps > least) {
        addJoints(islands, joints, bodies, solver, step);
        addContacts(islands, contacts, bodies, solver, step);
        addTurns(bodies, dt);
    }
    for (const int i : bodies.active) {
        if (!bodies.isMoving(i)) continue;
        if (bodies.spans[i] == 0.0) chosen_[i] = {};  // a new body, perhaps with a reused number
        Island& island = islands_[islands.leaderOf(i)];
        Chosen &merged = island.chosen, &own = chosen_[i];
        merged.calm = island.any ? smaller(merged.calm, own.calm) : own.calm;
        merged.current = larger(merged.current, own.current);
        merged.enough = larger(merged.enough, own.enough);
        island.any = true;
    }
    int most = least;
    for (const int i : bodies.active) {
        Island& island = islands_[i];
        if (!island.any) continue;
        Chosen& chosen = island.chosen;
        const int enough = numberFor(island.needed, least, mostOf(island, step.settings));
        chosen.enough = larger(chosen.enough, enough);
        chosen.calm += dt;
        if (enough >= chosen.current) chosen = {enough, least, 0.0};
        if (chosen.calm > (island.joints > 0 && !island.touching ? kCalmOfJoints : kCalm))
            chosen = {chosen.enough, least, 0.0};
        most = larger(most, chosen.current);
    }
    for (const int i : bodies.active)
        if (bodies.isMoving(i)) chosen_[i] = islands_[islands.leaderOf(i)].chosen;
    return most;
}

void Substeps::measure(std::span<const Joint> joints, const Bodies& bodies, const Solver& solver) {
    fastest_.resize(solver.constraints.joints.size());
    for (const int i : solver.trees.whole()) {
        const JointConstraint& c = solver.constraints.joints[i];
        if (c.stride == 0) continue;
        fastest_[i] = larger(fastest_[i], turnOf(c, joints[c.joint], bodies));
    }
}

bool Substeps::raise(DisjointSets& islands, std::span<const Contact> contacts, const Bodies& bodies,
                     const Solver& solver, const SubstepChoice& step) {
    if (fastest_.empty()) return false;
    for (const int i : bodies.active) islands_[i] = {};
    for (const Contact& c : contacts) islands_[islands.leaderOf(bodies.movable(c.a, c.b))].touching = true;
    for (const int i : solver.trees.whole()) {
        const JointConstraint& c = solver.constraints.joints[i];
        Island& island = islands_[islands.leaderOf(bodies.movable(c.a, c.b))];
        ++island.joints;
        island.turn = larger(island.turn, fastest_[i]);
    }
    bool any = false;
    for (const int i : bodies.active) {
        const Island& island = islands_[islands.leaderOf(i)];
        if (island.joints == 0 || island.touching || !bodies.isMoving(i)) continue;
        const int enough = numberFor(step.dt * island.turn / kTurnPerSubstep, step.settings.substeps,
                                     mostOf(island, step.settings));
        if (enough <= chosen_[i].current) continue;
        any = true;
        chosen_[i] = {enough, step.settings.substeps, 0.0};
    }
    return any;
}

}  // namespace engine
