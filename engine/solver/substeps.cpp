#include "engine/solver/substeps.h"

namespace engine {
namespace {

constexpr double kSwingPerSubstep = 1.0;  // rad of the links' own oscillation
constexpr double kTurnPerSubstep = 0.1;   // rad
constexpr double kHeavy = 10.0;           // ratio of masses
constexpr int kHeavySubsteps = 8;
constexpr double kSubstepsALevel = 0.4, kFewSubsteps = 2.0;
constexpr double kCalm = 1.0;             // s
constexpr double kCalmOfJoints = 10.0;    // s

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

/// A rod's own turning, and its swing across its pull: the bodies at its ends need not turn with it.
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

double stepsForJoints(std::span<const Joint> joints, const Bodies& bodies, const Solver& solver,
                      double dt) {
    double most = 0.0;
    for (const int i : solver.trees.whole()) {
        const JointConstraint& c = solver.constraints.joints[i];
        const Joint& joint = joints[c.joint];
        const double force = joint.force.norm();
        double swing = larger(
            swingSquared(bodies.inverseMasses[c.a], bodies.poses[c.a].rotation * joint.def.anchorA,
                         force),
            swingSquared(bodies.inverseMasses[c.b], bodies.poses[c.b].rotation * joint.def.anchorB,
                         force));
        double turn = larger(bodies.velocities[c.a].angular.norm(), turnOfB(joint, bodies));
        if (joint.def.type == JointType::distance) addRod(joint, bodies, force, swing, turn);
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

void choose(SubstepChooser::Cause& cause, double needed, double calm, const Settings& settings,
            double dt) {
    const int least = settings.substeps, most = larger(settings.maxSubsteps, least);
    int enough = least;
    while (enough < needed && enough < most) enough = nextNumber(enough, least);
    enough = smaller(enough, most);
    if (enough >= cause.current) {
        cause = {enough, least, 0.0};
        return;
    }
    cause.enough = larger(cause.enough, enough);
    cause.calm += dt;
    if (cause.calm > calm) cause = {cause.enough, least, 0.0};
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
    const double heavy = heavyOnLight(contacts, bodies) ? 1.0 * kHeavySubsteps : 0.0;
    choose(chooser.joints, stepsForJoints(joints, bodies, solver, dt), kCalmOfJoints, settings, dt);
    const double tall = kSubstepsALevel * chooser.columns.tallest(contacts, bodies) - kFewSubsteps;
    choose(chooser.masses, heavy, kCalm, settings, dt);
    choose(chooser.heights, tall, kCalm, settings, dt);
    return larger(chooser.joints.current, larger(chooser.masses.current, chooser.heights.current));
}

}  // namespace engine
