/// A joint as it is given to a World, and as it is read from one.
#pragma once
#include <array>
#include <compare>
#include <limits>
#include <vector>

#include "engine/base/math.h"
#include "engine/body.h"

namespace engine {

/// What the bodies share, and what is left free: free[0], free[1] ... of the joint, its coordinates.
///   ball              a point; 0: twist about the axis, 1: swing of the axis (rad), at least 0
///   distance          two points at `length` (a rod); free only if limited or driven, 0: distance
///   hinge             a point and an axis; 0: angle about it, turns counted
///   weld              everything
///   slider            all but the way along the axis; 0: that way (m)
///   universal         a point, and axis of a across axis2 of b; 0, 1: angles about the two
///   constantVelocity  a point, and the turn about the shafts `axis` of a, axis2 of b; 1: swing
///   lookAt            the axis of b points from anchorB to anchorA; free to turn about it
///   axis              `axis` of a and axis2 of b stay parallel; places are free; 0: angle about it
///   sixDof            what its six coordinates lock; 0..2: ways along, 3..5: turns about x, y, z
///   gear              turns: that of b about axis2 is `ratio` times that of a about `axis`, either
///                     seen from the world; 0, 1: their turns, counted, for reading only
///   wheel             b rides along the axis of a and spins about axis2; 0: way, 1: spin angle
///   path              anchorB lies on a curve fixed in a; 0: the way along it (m)
enum class JointType {
    ball, distance, hinge, weld, slider, universal, constantVelocity, lookAt, axis, sixDof, gear,
    wheel, path
};

/// A joint of a world, as BodyId is a body.
struct JointId {
    int index = -1;  // -1: none
    unsigned generation = 0;  // how often the number was used before
    auto operator<=>(const JointId&) const = default;
};

/// Makes a joint soft (constraints/soft.h): by how the masses it joins swing, or, where hz is 0, by
/// numbers of its own.
struct Spring {
    double hz = 0.0;          // frequency of the masses it joins, along a row
    double damping = 0.0;     // ratio: 0 swings on, 1 just does not overshoot
    double stiffness = 0.0;   // k, N/m; about an axis N m/rad
    double resistance = 0.0;  // c, N s/m; about an axis N m s/rad. Alone: a damper
    bool isSoft() const { return hz > 0.0 || stiffness > 0.0 || resistance > 0.0; }  // else rigid
    /// k, of a row whose inverse effective mass is `inverseMass` (1/kg, or 1/(kg m^2)).
    double stiffnessOf(double inverseMass) const {
        const double w = 6.283185307179586 * hz;
        return hz > 0.0 ? w * w / inverseMass : stiffness;
    }
    /// c, likewise.
    double resistanceOf(double inverseMass) const {
        return hz > 0.0 ? 2.0 * damping * (6.283185307179586 * hz) / inverseMass : resistance;
    }
};

/// No limit, and a strength that is never too small.
constexpr double kUnlimited = std::numeric_limits<double>::infinity();

/// Where a free coordinate has to stay: m or rad. Angles may go beyond a turn.
struct Limits {
    double low = -kUnlimited, high = kUnlimited;  // at most `high`
    bool any() const { return low > -kUnlimited || high < kUnlimited; }  // on either side
};

/// Brings a free coordinate to a speed, as far as its strength goes. With speed 0 it is a brake.
struct Motor {
    double speed = 0.0;     // m/s or rad/s
    double strength = 0.0;  // N or N m at most; 0: no motor; kUnlimited: whatever it takes
    bool isOn() const { return strength > 0.0; }  // also a brake
};

/// What acts along a coordinate that a joint leaves free: nothing unless it is set.
struct Freedom {
    bool locked = false;  // held at 0; sixDof only
    Limits limits;
    Motor motor;
    Spring spring;        // soft; pulls towards `rest`
    double rest = 0.0;    // m or rad
    double inertia = 0.0; // I, kg or kg m^2: of a rotor that turns as the coordinate does, but that
                          // nothing else moves. Geared n : 1, it is n^2 times the rotor's own
    /// If the coordinate is free.
    bool acts() const {
        return limits.any() || motor.isOn() || spring.isSoft() || inertia > 0.0;
    }
};

/// Everything about a joint that is given to World::add, which says what has to hold.
struct JointDef {
    JointType type = JointType::ball;
    BodyId a, b;                 // two bodies, one of them dynamic
    Vec3 anchorA{0, 0, 0};       // m, in a's body axes from its centre of mass
    Vec3 anchorB{0, 0, 0};       // m, in b's
    Vec3 axis{0, 0, 1};          // world axes, at the moment of adding, any length
    Vec3 axis2{0, 0, 0};         // likewise; 0: `axis`. universal, wheel: across `axis`, never 0.
                                 // sixDof: x is along `axis`, y along axis2; 0: the world's axes
    double length = 0.0;         // m, distance joint; positive unless it is limited or driven
    Spring spring;               // of all rows that hold; of a limited distance: towards `length`
    std::array<Freedom, 6> free; // by coordinate, see JointType; angles from the moment of adding
    double ratio = 1.0;          // gear; below 0: they turn opposite ways
    std::vector<Vec3> path;      // m, in a's body axes: the points the curve goes through, 2 or more
    bool closed = false;         // the path goes on from its last point to its first
    double breakForce = kUnlimited;   // N and N m, of JointState: more, and the joint is removed
    double breakTorque = kUnlimited;  // at the end of the step (StepReport::broken)

    /// Whether anything acts along one of its coordinates.
    bool acts() const {
        for (const Freedom& f : free)
            if (f.acts()) return true;
        return false;
    }
};

/// A joint as the last step left it.
struct JointState {
    JointDef def;
    Vec3 worldA, worldB;         // m, the two anchors
    Vec3 worldAxis, worldAxis2;  // unit: `axis` as a carries it, axis2 as b does
    Vec3 worldAxis2A;            // unit: axis2 as a carries it; with worldAxis, a sixDof's frame
    double separation = 0.0;     // m: |C| of the rows in metres, and what limits are missed by
    double position = 0.0;       // m or rad: coordinate 0; angles are counted over turns
    double speed = 0.0;          // m/s or rad/s, of it
    std::array<double, 6> positions{}, speeds{};  // of all coordinates
    Vec3 force{0, 0, 0};         // N, on b, mean over the last step
    Vec3 torque{0, 0, 0};        // N m, on b about its anchor, mean over the last step
    bool removed = false;        // by the caller, with one of its bodies, or broken
    bool broken = false;         // and that is why it was removed
};

}  // namespace engine
