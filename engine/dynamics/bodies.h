/// The bodies of a world, an array per use: what a solver gathers (velocity, inverse mass) lies
/// close together.
#pragma once
#include <vector>

#include "engine/base/math.h"
#include "engine/body.h"

namespace engine {

/// [v; w], m/s and rad/s in world axes, w about the centre of mass.
struct Velocity {
    Vec3 linear = Vec3::Zero();
    Vec3 angular = Vec3::Zero();
};

/// M^-1 of one body: 1/m and the inverse inertia in world axes. All zero: no impulse moves it.
struct InverseMass {
    double linear = 0.0;          // 1/kg
    Mat3 angular = Mat3::Zero();  // 1/(kg m^2)
};

/// Mass in body axes: what does not change from step to step.
struct BodyMass {
    double mass = 0.0;                        // kg
    Mat3 inertia = Mat3::Zero();              // kg m^2
    Mat3 inverseInertia = Mat3::Zero();
    bool isRound = false;                     // the same about every axis: a ball, a cube
};

/// m/s^2 and rad/s^2
struct Acceleration {
    Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
};

struct Bodies {
    std::vector<BodyDef> defs;
    std::vector<Pose> poses;
    std::vector<Velocity> velocities;
    std::vector<InverseMass> inverseMasses;  // world axes, of the current pose
    std::vector<BodyMass> masses;
    std::vector<double> massFactors;  // constraints take a body for so much heavier (pressed_bodies.h)
    std::vector<Load> loads;                         // of the coming step
    std::vector<Acceleration> accelerations;         // of this sub-step
    std::vector<double> spans;                       // s: their own sub-steps (solver/paces.h)
    std::vector<int> strides;                        // as many of the world's sub-steps
    std::vector<char> acts;                          // 0: they wait in this one of the world's
    std::vector<char> present;                       // 0: removed
    std::vector<int> asleep;   // the least body of its sleeping island (sleep.h); -1: awake
    std::vector<char> placed;  // 1: by the caller, after the last step
    bool hasSensors = false;

    int count() const { return static_cast<int>(defs.size()); }
    bool isDynamic(int i) const { return present[i] && defs[i].kind == BodyKind::dynamic; }
    bool isAsleep(int i) const { return asleep[i] >= 0; }
    bool isAwake(int i) const { return isDynamic(i) && !isAsleep(i); }
    /// It is its turn in this sub-step, and forces and impulses move it; something carries it on.
    bool isActing(int i) const { return acts[i] && isAwake(i); }
    bool isGoing(int i) const { return acts[i] && isMoving(i); }
    /// Of two bodies that touch or are jointed, one that impulses move, if there is one.
    int movable(int a, int b) const { return isDynamic(a) ? a : b; }
    /// Steps carry it on.
    bool isMoving(int i) const {
        return present[i] && defs[i].kind != BodyKind::fixed && !isAsleep(i);
    }
    /// It may come to touch what it did not touch before.
    bool stirs(int i) const {
        return placed[i] || (!isAsleep(i) && (isDynamic(i) || isDriven(i)));
    }
    /// A kinematic body under way.
    bool isDriven(int i) const {
        return present[i] && defs[i].kind == BodyKind::kinematic && !isStill(i);
    }
    bool isStill(int i) const {
        return velocities[i].linear.isZero(0.0) && velocities[i].angular.isZero(0.0);
    }
};

/// Puts a body in a slot, the one after the last or one that is free; what the definition leaves open
/// is filled in.
void addBody(Bodies& bodies, const BodyDef& def, int slot);

/// All bodies act, in sub-steps of h (s).
void setSpans(Bodies& bodies, double h);

/// M^-1 in world axes, after the body was turned; of all that act.
void updateInverseInertia(Bodies& bodies, int i);
void updateInverseInertias(Bodies& bodies);

}  // namespace engine
