#include "engine/solver/substeps.h"

namespace engine {
namespace {

constexpr double kSwingPerSubstep = 1.0;  // rad of the links' own oscillation
constexpr double kTurnPerSubstep = 0.1;   // rad
constexpr double kTurnInTouch = 0.3;      // rad, with contacts
constexpr double kTurnInNet = 0.5;        // rad
constexpr double kHeavy = 10.0;           // ratio of masses
constexpr double kSubstepsARatio = 8.0 / 50.0, kLeastHeavy = 4.0, kMostHeavy = 8.0;
constexpr double kVeryHeavy = 100.0, kSubstepsALevel = 3.2;
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

/// Adds a rod's own rotation and its swing across the pull: the bodies at its ends need not turn with it.
void addRod(const Joint& joint, const Bodies& bodies, double force, double& swing, double& turn) {
    const int a = joint.def.a.index, b = joint.def.b.index;
    const Pose &poseA = bodies.poses[a], &poseB = bodies.poses[b];
    const Vec3 armA = poseA.rotation * joint.def.anchorA, armB = poseB.rotation * joint.def.anchorB;
    const Vec3 along = poseB.position + armB - poseA.position - armA;
    const double length = larger(along.norm(), 1e-3);
    const Velocity &va = bodies.velocities[a], &vb = bodies.velocities[b];
    const Vec3 apart = vb.linear + vb.angular.cross(armB) - va.linear - va.angular.cross(armA);
    turn = larger(turn, along.cross(apart).norm() / (length * length));
    swing = larger(swing, force / length *
                              (bodies.inverseMasses[a].linear + bodies.inverseMasses[b].linear));
}

/// What one joint of a tree needs: the rate of its swing under tension, and how fast it turns, rad/s.
struct JointRates {
    double swing = 0.0, turn = 0.0;
};

JointRates ratesOf(const JointConstraint& c, const Joint& joint, const Bodies& bodies) {
    const double force = joint.force.norm();
    double swing = larger(
        swingSquared(bodies.inverseMasses[c.a], bodies.poses[c.a].rotation * joint.def.anchorA, force),
        swingSquared(bodies.inverseMasses[c.b], bodies.poses[c.b].rotation * joint.def.anchorB, force));
    double turn = larger(bodies.velocities[c.a].angular.norm(), turnOfB(joint, bodies));
    if (joint.def.type == JointType::distance) addRod(joint, bodies, force, swing, turn);
    return {std::sqrt(swing), turn};
}

/// How many times as heavy a body is as the one it rests on; 0 if one of the two is immovable.
double loadRatio(const Contact& c, const Bodies& bodies, const Vec3& gravity) {
    const double a = bodies.masses[c.a].mass, b = bodies.masses[c.b].mass;
    if (a <= 0.0 || b <= 0.0) return 0.0;
    const double below = gravity.dot(c.normal);  // positive: a is above b
    return larger(below >= 0.0 ? a / b : 0.0, below <= 0.0 ? b / a : 0.0);
}

/// 4, 8, 12, 16, 24, 32: a power of two times the least, or 1.5 times that; all are multiples of the least.
int nextNumber(int number, int least) {
    int power = least;
    if (number == least) return 2 * least;
    while (2 * power <= number) power *= 2;
    return number + larger(power / 2, 1);
}

int numberFor(double needed, const Settings& settings) {
    const int least = settings.substeps, most = larger(settings.maxSubsteps, least);
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
    solver.trees.begin(0.0, 0.0, v);
    solver.trees.solveVelocities(v, unused);
    solver.trees.report(joints, dt);
}

void Substeps::addJoints(DisjointSets& islands, std::span<const Joint> joints, const Bodies& bodies,
                         const Solver& solver, double dt) {
    for (const int i : solver.trees.whole()) {
        const JointConstraint& c = solver.constraints.joints[i];
        Island& island = islands_[islands.leaderOf(bodies.movable(c.a, c.b))];
        island.jointed = true;
        const JointRates rates = ratesOf(c, joints[c.joint], bodies);
        island.needed = larger(island.needed, dt * rates.swing / kSwingPerSubstep);
        island.turn = larger(island.turn, rates.turn);
    }
    for (const int i : solver.trees.inNets()) {
        const JointConstraint& c = solver.constraints.joints[i];
        Island& island = islands_[islands.leaderOf(bodies.movable(c.a, c.b))];
        const JointRates rates = ratesOf(c, joints[c.joint], bodies);
        island.needed = larger(island.needed, dt * rates.swing / kSwingPerSubstep);
        island.needed = larger(island.needed, dt * rates.turn / kTurnInNet);
    }
}

void Substeps::addTurns(const Bodies& bodies, double dt) {
    for (const int i : bodies.active) {
        Island& island = islands_[i];
        const double most = island.touching ? kTurnInTouch : kTurnPerSubstep;
        island.needed = larger(island.needed, dt * island.turn / most);
    }
}

void Substeps::addContacts(DisjointSets& islands, std::span<const Contact> contacts,
                           const Bodies& bodies, const Vec3& gravity, const Solver& solver) {
    columns_.measure(contacts, solver.order, bodies, islands);
    for (const Contact& c : contacts) {
        const int leader = islands.leaderOf(bodies.movable(c.a, c.b));
        Island& island = islands_[leader];
        island.touching = true;
        island.needed = larger(island.needed, columns_.substeps(leader));
        const double ratio = loadRatio(c, bodies, gravity);
        if (ratio > kHeavy)
            island.needed = larger(island.needed,
                                   clamped(kSubstepsARatio * ratio, kLeastHeavy, kMostHeavy));
        if (ratio > kVeryHeavy)
            island.needed = larger(island.needed, kSubstepsALevel * columns_.levels(leader));
    }
}

int Substeps::choose(DisjointSets& islands, std::span<const Contact> contacts,
                     std::span<const Joint> joints, const Bodies& bodies, const Solver& solver,
                     const Vec3& gravity, const Settings& settings, double dt) {
    const int least = settings.substeps;
    chosen_.resize(bodies.count());
    islands_.resize(bodies.count());
    for (const int i : bodies.active) islands_[i] = {};
    if (settings.maxSubsteps > least) {
        addJoints(islands, joints, bodies, solver, dt);
        addContacts(islands, contacts, bodies, gravity, solver);
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
        const int enough = numberFor(island.needed, settings);
        chosen.enough = larger(chosen.enough, enough);
        chosen.calm += dt;
        if (enough >= chosen.current) chosen = {enough, least, 0.0};
        if (chosen.calm > (island.jointed && !island.touching ? kCalmOfJoints : kCalm))
            chosen = {chosen.enough, least, 0.0};
        most = larger(most, chosen.current);
    }
    for (const int i : bodies.active)
        if (bodies.isMoving(i)) chosen_[i] = islands_[islands.leaderOf(i)].chosen;
    return most;
}

}  // namespace engine
