#include "engine/solver/substeps.h"

namespace engine {
namespace {

constexpr double kSwingPerSubstep = 0.8;  // rad of the links' own oscillation
constexpr double kTurnPerSubstep = 0.1;   // rad
constexpr double kHeavy = 10.0;           // ratio of masses
constexpr int kHeavySubsteps = 8;
constexpr double kCalm = 1.0;             // s

/// omega^2 of a body pulled by the force f at the arm r: f r / I across the arm.
double swingSquared(const InverseMass<double>& mass, const Vec3& arm, double force) {
    const double r = arm.norm();
    if (r == 0.0 || mass.linear == 0.0) return 0.0;
    const Vec3 along = arm / r;
    const double across = 0.5 * (mass.angular.trace() - along.dot(mass.angular * along));
    return force * r * across;
}

double stepsForJoints(std::span<const Joint> joints, const Bodies& bodies, const Solver& solver,
                      double dt) {
    double most = 0.0;
    for (const int i : solver.trees.whole()) {
        const JointConstraint<double>& c = solver.constraints.joints[i];
        const Joint& joint = joints[c.joint];
        const double force = joint.force.norm();
        const double swing = larger(
            swingSquared(bodies.inverseMasses[c.a], bodies.poses[c.a].rotation * joint.def.anchorA,
                         force),
            swingSquared(bodies.inverseMasses[c.b], bodies.poses[c.b].rotation * joint.def.anchorB,
                         force));
        const double turn = larger(bodies.velocities[c.a].angular.norm(),
                                   bodies.velocities[c.b].angular.norm());
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

}  // namespace

int chooseSubsteps(SubstepChooser& chooser, std::span<const Contact> contacts,
                   std::span<const Joint> joints, const Bodies& bodies, const Solver& solver,
                   const Settings& settings, double dt) {
    const int least = settings.substeps, most = larger(settings.maxSubsteps, least);
    double needed = stepsForJoints(joints, bodies, solver, dt);
    if (heavyOnLight(contacts, bodies)) needed = larger(needed, 1.0 * kHeavySubsteps);
    // Before the first step no tension is known: the safe end, if there is a tree at all.
    if (chooser.current == 0) chooser.current = solver.trees.empty() ? least : most;
    while (chooser.current < needed && chooser.current * 2 <= most)
        chooser.current *= 2, chooser.calm = 0.0;
    chooser.calm = needed <= 0.5 * chooser.current ? chooser.calm + dt : 0.0;
    if (chooser.calm > kCalm && chooser.current / 2 >= least)
        chooser.current /= 2, chooser.calm = 0.0;
    chooser.current = smaller(larger(chooser.current, least), most);
    return chooser.current;
}

}  // namespace engine
