/// The motion of a tree where Newton's method fails for RATTLE (joint_nudges.h). A slack chain of light links that
/// snaps taut under a heavy bob is nearly straight: J_0 lets its links turn so that it could grow longer, though it
/// cannot. The sub-step is repeated by implicit Euler, from q_0, for which C = 0 nearly, to the nearest possible
/// poses to q*, where all bodies would be without the tree's impulses (Hairer, Wanner, 'Solving Ordinary
/// Differential Equations II', VII.1):
///   minimise (q - q*).M (q - q*) / 2   so that C(q) = 0,      v = v* + (q - q*) / h
/// by Newton's method with J at the present poses, and the part of J's change that lambda resists:
///   | M + G  J^T | |  dq    |   | M (q* - q) |
///   | J      0   | | -lambda| = | -C         |
///   G: a pull f at the arm r, of length |r|, resists rotations across r by |f| |r|; a rod of length l resists
///      motions of its ends by |f| / l (Andrews, Teichmann, Kry 2017, 'Geometric stiffness for real-time constrained
///      multibody dynamics')
/// Four or five steps are enough. Links that move across the chain lose their energy, as in a real one. It may not
/// grow: on a surface as curved as that of C the nearest point may be far away, and v larger than v*; it is scaled
/// then.
#pragma once
#include "engine/dynamics/energy.h"
#include "engine/dynamics/rotation.h"
#include "engine/solver/tree_part.h"

namespace engine {

/// By how much a pull (N s^2) makes the body harder to turn across the arm, relative to its inertia.
inline double stiffnessOf(const InverseMass& mass, const Vec3& arm, double pull) {
    const double r = arm.norm();
    if (r == 0.0 || mass.linear == 0.0) return 0.0;
    const Vec3 along = arm / r;
    return pull * r * 0.5 * (mass.angular.trace() - along.dot(mass.angular * along));
}

template <int N>
bool TreePart<N>::mayRepeat(const Tree& tree, const TreeNudge& nudge) const {
    constexpr double kFits = 1e-3;  // of the lever arms
    if (!tree.whole || tree.damped || !nudge.feeds || nudge.pushed) return false;
    for (int k = tree.first; k < tree.end; ++k)
        if (joints_[k].now.error.cwiseAbs().maxCoeff() > kFits * joints_[k].reach) return false;
    return true;
}

template <int N>
void TreePart<N>::keepLed(const Tree& tree, std::span<const Pose> poses) {
    for (int i = tree.firstMember; i < tree.endMember; ++i) repeats_[i].led = poses[members_[i].body];
}

/// Finds q* and v*, and moves the bodies back to q_0.
template <int N>
void TreePart<N>::findTargets(const Tree& tree, Bodies& bodies) {
    for (int i = tree.firstMember; i < tree.endMember; ++i) moved_[i] = {};
    for (int k = tree.first; k < tree.end; ++k) {
        const TreeJoint<N>& joint = joints_[k];
        apply(joint, joint.lambda, masses_[joint.ownA], masses_[joint.ownB], moved_[joint.ownA], moved_[joint.ownB]);
        fed_[k] = tree.h * joint.lambda;
    }
    for (int i = tree.firstMember; i < tree.endMember; ++i) {
        if (masses_[i].linear == 0.0) continue;
        const Member& member = members_[i];
        Repeat& repeat = repeats_[i];
        const Velocity &v = bodies.velocities[member.body], &byTree = moved_[i];
        repeat.free = {v.linear - byTree.linear, v.angular - byTree.angular};
        repeat.target = {repeat.led.position - tree.h * byTree.linear,
                         cayley(-tree.h * byTree.angular, repeat.led.rotation)};
        bodies.poses[member.body] = {repeat.led.position - tree.h * member.kept.linear, member.start};
    }
}

template <int N>
void TreePart<N>::stiffen(const Tree& tree, const Bodies& bodies) {
    constexpr double kShortest = 1e-3;  // m, of a rod
    for (int i = tree.firstMember; i < tree.endMember; ++i) {
        masses_[i] = bodies.inverseMasses[members_[i].body];
        repeats_[i].inertia = repeats_[i].mass = 1.0;
    }
    for (int k = tree.first; k < tree.end; ++k) {
        const TreeJoint<N>& joint = joints_[k];
        const double pull = pushOf(joint, fed_[k]).norm();
        double ofRod = 0.0;
        if (joint.type == JointType::distance) {
            const Pose &a = bodies.poses[joint.a], &b = bodies.poses[joint.b];
            ofRod = pull / larger((b.toWorld(joint.anchorB) - a.toWorld(joint.anchorA)).norm(), kShortest);
        }
        for (const bool ofB : {false, true}) {
            const int own = ofB ? joint.ownB : joint.ownA;
            const InverseMass& mass = bodies.inverseMasses[members_[own].body];
            repeats_[own].inertia += stiffnessOf(mass, ofB ? joint.now.armB : joint.now.armA, pull);
            repeats_[own].mass += ofRod * mass.linear;
        }
    }
    for (int i = tree.firstMember; i < tree.endMember; ++i)
        masses_[i].linear /= repeats_[i].mass, masses_[i].angular /= repeats_[i].inertia;
}

/// Finds dq and lambda.
template <int N>
void TreePart<N>::solveStep(const Tree& tree, const Bodies& bodies) {
    stiffen(tree, bodies);
    for (int k = tree.first; k < tree.end; ++k) setBlocks(k);
    factors_.factor(tree.first, tree.end);
    for (int i = tree.firstMember; i < tree.endMember; ++i) {
        moved_[i] = {};
        if (masses_[i].linear == 0.0) continue;
        const Repeat& repeat = repeats_[i];
        const Pose& pose = bodies.poses[members_[i].body];
        moved_[i] = {(repeat.target.position - pose.position) / repeat.mass,
                     turnBetween(pose, repeat.target) / repeat.inertia};
    }
    for (int k = tree.first; k < tree.end; ++k) {
        const TreeJoint<N>& joint = joints_[k];
        x_[k] = -joint.now.error - velocityAlong(joint, moved_[joint.ownA], moved_[joint.ownB]);
    }
    factors_.solve(x_, tree.first, tree.end, [&](int k, const TreeRows<N>& lambda) {
        const TreeJoint<N>& joint = joints_[k];
        fed_[k] = lambda;
        apply(joint, lambda, masses_[joint.ownA], masses_[joint.ownB], moved_[joint.ownA], moved_[joint.ownB]);
    });
}

/// Moves by dq, as far as it is a good direction. Returns whether that was all of it.
template <int N>
bool TreePart<N>::takeStep(const Tree& tree, Bodies& bodies) {
    constexpr double kFarthest = 0.3;  // rad
    double most = 0.0;
    for (int i = tree.firstMember; i < tree.endMember; ++i) most = larger(most, moved_[i].angular.norm());
    const double share = most > kFarthest ? kFarthest / most : 1.0;
    for (int i = tree.firstMember; i < tree.endMember; ++i) {
        if (masses_[i].linear == 0.0) continue;
        Pose& pose = bodies.poses[members_[i].body];
        pose = {pose.position + share * moved_[i].linear, cayley(share * moved_[i].angular, pose.rotation)};
    }
    return share == 1.0;
}

/// Sets v, with at most the kinetic energy of v*, unless a body that has its own motion drives the tree.
template <int N>
void TreePart<N>::setVelocities(const Tree& tree, Bodies& bodies) {
    double before = 0.0, after = 0.0;
    bool driven = false;
    for (int i = tree.firstMember; i < tree.endMember; ++i) {
        const int body = members_[i].body;
        driven = driven || bodies.isDriven(body);
        if (masses_[i].linear == 0.0) continue;
        const Repeat& repeat = repeats_[i];
        const Pose& pose = bodies.poses[body];
        bodies.velocities[body] = repeat.free;
        before += kineticEnergyOf(bodies, body);
        bodies.velocities[body].linear += (pose.position - repeat.target.position) / tree.h;
        bodies.velocities[body].angular += turnBetween(repeat.target, pose) / tree.h;
        after += kineticEnergyOf(bodies, body);
    }
    if (driven || after <= before) return;
    const double share = std::sqrt(before / after);
    for (int i = tree.firstMember; i < tree.endMember; ++i) {
        if (masses_[i].linear == 0.0) continue;
        Velocity& v = bodies.velocities[members_[i].body];
        v = {share * v.linear, share * v.angular};
    }
}

/// J and C at the present poses; how large the errors are, relative to the lever arms.
template <int N>
double TreePart<N>::lookAnew(const Tree& tree, std::span<const Joint> joints, std::span<const Pose> poses) {
    double ratio = 0.0;
    for (int k = tree.first; k < tree.end; ++k) {
        TreeJoint<N>& joint = joints_[k];
        joint.now = geometryOf(joint, joints[joint.joint], poses[joint.a], poses[joint.b]);
        if (joint.isGear) setTwistOfA(joints[joint.joint], poses[joint.a], joint);
        ratio = larger(ratio, joint.now.error.cwiseAbs().maxCoeff() / joint.reach);
    }
    return ratio;
}

template <int N>
void TreePart<N>::repeat(Tree& tree, const TreeNudge& nudge, std::span<const Joint> joints, Bodies& bodies) {
    constexpr int kMostSteps = 40;
    constexpr double kReached = 1e-7, kReachable = 1e-4;  // of the lever arms: at best, and after all steps
    for (int i = tree.firstMember; i < tree.endMember; ++i) repeats_[i].nudged = bodies.poses[members_[i].body];
    takeBackFeedback(tree, nudge, bodies);
    findTargets(tree, bodies);
    tree.ratio = lookAnew(tree, joints, bodies.poses);
    for (int step = 0; step < kMostSteps; ++step) {
        solveStep(tree, bodies);
        const bool whole = takeStep(tree, bodies);
        tree.ratio = lookAnew(tree, joints, bodies.poses);
        if (whole && tree.ratio < kReached) break;
    }
    if (tree.ratio > kReachable) {
        for (int i = tree.firstMember; i < tree.endMember; ++i) bodies.poses[members_[i].body] = repeats_[i].nudged;
        return;
    }
    setVelocities(tree, bodies);
    for (int k = tree.first; k < tree.end; ++k)
        book(joints_[k], TreeRows<N>(fed_[k] / tree.h - joints_[k].lambda), 1.0);
}

}  // namespace engine
