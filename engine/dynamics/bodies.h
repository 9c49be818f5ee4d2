/// The bodies of a world, with one array per use: the data that a solver gathers (velocity, inverse mass) is
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

/// M^-1 of one body: 1/m and the inverse inertia in world axes. All zero: impulses do not move the body.
struct InverseMass {
    double linear = 0.0;          // 1/kg
    Mat3 angular = Mat3::Zero();  // 1/(kg m^2)
};

/// Mass properties in body axes, constant over steps.
struct BodyMass {
    double mass = 0.0;                        // kg
    Mat3 inertia = Mat3::Zero();              // kg m^2
    Mat3 inverseInertia = Mat3::Zero();
    bool isRound = false;                     // equal about every axis: a ball, a cube
    int topAxis = -1;                         // of a symmetric top: equal about the other two
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
    std::vector<double> thicknesses;  // m, of the shapes' bounds: their smallest side; planes have no end
    std::vector<double> massFactors;  // constraints treat the body as this much heavier (pressed_bodies.h)
    std::vector<Load> loads;                         // for the coming step
    std::vector<Acceleration> accelerations;         // in this sub-step
    std::vector<double> spans;                       // s: the body's own sub-step (solver/paces.h)
    std::vector<int> strides;                        // the same, in the world's sub-steps
    std::vector<char> acts;                          // 0: waits in this sub-step of the world
    std::vector<char> present;                       // 0: removed
    std::vector<int> asleep;   // lowest body number of its sleeping island (sleep.h); -1: awake
    std::vector<char> placed;  // 1: placed by the caller since the last step
    /// Sorted: all that move, and those that were placed or have stopped moving since the last step. A step
    /// visits no others, so what sleeps or is fixed costs nothing.
    std::vector<int> active;
    bool activeShrinks = false;  // some of them may rest now
    long long activeChanges = 0; // counted
    bool restStale = false;      // whether `restMoment` has to be summed again
    Vec3 restMoment = Vec3::Zero();  // kg m: sum of m x over the dynamic bodies that are not active
    bool hasSensors = false;

    int count() const { return static_cast<int>(defs.size()); }
    bool isDynamic(int i) const { return present[i] && defs[i].kind == BodyKind::dynamic; }
    bool isAsleep(int i) const { return asleep[i] >= 0; }
    bool isAwake(int i) const { return isDynamic(i) && !isAsleep(i); }
    /// isActing: forces and impulses move it in this sub-step. isGoing: it moves in this sub-step.
    bool isActing(int i) const { return acts[i] && isAwake(i); }
    bool isGoing(int i) const { return acts[i] && isMoving(i); }
    /// What impulses or its own velocity move; all others are the same at any time of a step.
    bool mayWait(int i) const { return isAwake(i) || isDriven(i); }
    /// It has moved ahead and waits for the others, or keeps its contacts when others look for theirs (world_looks.h);
    /// or one of two does. Between steps none waits.
    bool waits(int i) const { return !acts[i] && mayWait(i); }
    bool waits(int a, int b) const { return waits(a) || waits(b); }
    /// m: that of the thinner dynamic one of two bodies, one of which is dynamic.
    double thinner(int a, int b) const {
        const double ofA = thicknesses[a], ofB = thicknesses[b];
        return !isDynamic(a) ? ofB : isDynamic(b) && ofB < ofA ? ofB : ofA;
    }
    /// Of two bodies that touch or are joined, one that impulses can move, if any.
    int movable(int a, int b) const { return isDynamic(a) ? a : b; }
    /// Whether what two bodies share acts in this sub-step.
    bool act(int a, int b) const { return acts[movable(a, b)]; }
    /// Present, awake and not fixed: steps move it.
    bool isMoving(int i) const {
        return present[i] && defs[i].kind != BodyKind::fixed && !isAsleep(i);
    }
    /// It may make new contacts.
    bool stirs(int i) const {
        return placed[i] || (!isAsleep(i) && (isDynamic(i) || isDriven(i)));
    }
    /// A moving kinematic body.
    bool isDriven(int i) const {
        return present[i] && defs[i].kind == BodyKind::kinematic && !isStill(i);
    }
    bool isStill(int i) const {
        return velocities[i].linear.isZero(0.0) && velocities[i].angular.isZero(0.0);
    }
};

/// Puts a body into a free slot or the next one. Fills in values that the definition leaves open.
void addBody(Bodies& bodies, const BodyDef& def, int slot);

/// Adds a body to the active ones; or takes out all that rest, before a step.
void activate(Bodies& bodies, int body);
void leaveOutResting(Bodies& bodies);

/// Makes all bodies act, with sub-steps of h (s).
void setSpans(Bodies& bodies, double h);

/// Updates M^-1 in world axes after rotation: of one body, or of all acting bodies.
void updateInverseInertia(Bodies& bodies, int i);
void updateInverseInertias(Bodies& bodies);

}  // namespace engine
