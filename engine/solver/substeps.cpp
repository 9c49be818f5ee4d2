#include "engine/solver/substeps.h"

namespace engine {
namespace {

constexpr double kSwingPerSubstep = 1.0;  // rad of the links' own oscillation
constexpr double kTurnPerSubstep = 0.1;   // rad
constexpr double kHeavy = 10.0;           // ratio of masses
constexpr int kHeavySubsteps = 8;
constexpr double kCalm = 1.0;             // s

/// omega^2 of a body pulled by the force f at the arm r: f r / I across the arm.
double swingSquared(const InverseMass& mass, const Vec3& arm, double force) {
    const double r = arm.norm();
    if (r == 0.0 || mass.linear == 0.0) return 0.0;
    const Vec3 along = arm / r;
    const double across = 0.5 * (mass.angular.trace() - along.dot(mass.angular * along));
    return force * r * across;
}

/// rad/s; a wheel's spin about its axle turns no arm.
double turnOfB(const Joint& joint, const Bodies& bodies) {
    const int b = joint.def.b.index;
    const Vec3& spin = bodies.velocities[b].angular;
    if (joint.def.type != JointType::wheel) return spin.norm();
    const Vec3 axle = bodies.poses[b].rotation * joint.axis2B;
    return (spin - axle.dot(spin) * axle).norm();
}

double stepsForJoints(std::span<const Joint> joints, const Bodies& bodies, const Solver& solver,
                      double dt) {
    double most = 0.0;
    for (const int i : solver.trees.whole()) {
        const JointConstraint& c = solver.constraints.joints[i];
        const Joint& joint = joints[c.joint];
        const double force = joint.force.norm();
        const double swing = larger(
            swingSquared(bodies.inverseMasses[c.a], bodies.poses[c.a].rotation * joint.def.anchorA,
                         force),
            swingSquared(bodies.inverseMasses[c.b], bodies.poses[c.b].rotation * joint.def.anchorB,
                         force));
        const double turn = larger(bodies.velocities[c.a].angular.norm(), turnOfB(joint, bodies));
        most = larger(most, dt * larger(std::sqrt(swing) / kSwingPerSubstep,
                                        turn / kTurnPerSubstep));
    }
    return most;
}

bool heavyOnLight(std::span<const Contact> contacts, const Bodies& bodies) {
    for (const Contact& contact : contacts) {
        const double a = bodies.masses[contact.a].mass, b = bodies.masses[contact.b].mass;
        if (a > 0.0 && b > 0.0 && (a > kHeavy * b || b > kHeavy * a)) return true;
    }
    return false;
}

/// 4, 6, 8, 12, 16, 24, 32: a power of two times the least, and half as many again.
int nextNumber(int number, int least) {
    int power = least;
    while (2 * power <= number) power *= 2;
    return number + larger(power / 2, 1);
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

int chooseSubsteps(SubstepChooser& chooser, std::span<const Contact> contacts,
                   std::span<const Joint> joints, const Bodies& bodies, const Solver& solver,
                   const Settings& settings, double dt) {
    const int least = settings.substeps, most = larger(settings.maxSubsteps, least);
    double needed = stepsForJoints(joints, bodies, solver, dt);
    if (heavyOnLight(contacts, bodies)) needed = larger(needed, 1.0 * kHeavySubsteps);
    int enough = least;
    while (enough < needed && enough < most) enough = nextNumber(enough, least);
    enough = smaller(enough, most);
    if (enough >= chooser.current) {
        chooser = {enough, least, 0.0};
        return chooser.current;
    }
    chooser.enough = larger(chooser.enough, enough);
    chooser.calm += dt;
    if (chooser.calm > kCalm) chooser = {chooser.enough, least, 0.0};
    return chooser.current;
}

}  // namespace engine
