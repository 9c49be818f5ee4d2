/// A joint, as given to a World and as read from it.
#pragma once
#include <array>
#include <compare>
#include <limits>
#include <vector>

#include "engine/base/math.h"
#include "engine/body.h"

namespace engine {

/// What the two bodies share, and what is free: the coordinates free[0], free[1] ... of the joint.
///   ball              a point; 0: twist about the axis, 1: swing of the axis (rad), never negative
///   distance          two points at `length` (a rod); free only if limited or driven, 0: distance
///   hinge             a point and an axis; 0: angle about it, full turns counted
///   weld              everything
///   slider            all but the position along the axis; 0: that position (m)
///   universal         a point; `axis` of a is perpendicular to axis2 of b; 0, 1: angles about them
///   constantVelocity  a point, and the rotation about the shafts `axis` of a, axis2 of b; 1: swing
///   lookAt            the axis of b points from anchorB to anchorA; rotation about it is free
///   axis              `axis` of a and axis2 of b stay parallel; positions are free; 0: angle about it
///   sixDof            the coordinates that are locked; 0..2: along, 3..5: rotation about x, y, z
///   gear              rotation: that of b about axis2 is `ratio` times that of a about `axis`, both
///                     in the world; 0, 1: the two angles, full turns counted, read only
///   wheel             b moves along the axis of a and spins about axis2; 0: position, 1: angle
///   path              anchorB lies on a curve fixed in a; 0: the distance along it (m)
enum class JointType {
    ball, distance, hinge, weld, slider, universal, constantVelocity, lookAt, axis, sixDof, gear,
    wheel, path
};

/// Identifies a joint of a world, like BodyId a body.
struct JointId {
    int index = -1;  // -1: none
    unsigned generation = 0;  // how often the number was used before
    auto operator<=>(const JointId&) const = default;
};

/// Makes a joint soft (constraints/soft.h): by the frequency at which the joined masses swing, or, if hz is
/// 0, by stiffness and resistance. k and c follow from a frequency when the joint is made and stay: a stiffness
/// that changed with the masses' position would put energy in.
struct Spring {
    double hz = 0.0;          // frequency of the joined masses, along a row, where the joint is made
    double damping = 0.0;     // damping ratio: 0 none, 1 critical
    double stiffness = 0.0;   // k, N/m; about an axis N m/rad
    double resistance = 0.0;  // c, N s/m; about an axis N m s/rad. Alone: a damper
    bool isSoft() const { return hz > 0.0 || stiffness > 0.0 || resistance > 0.0; }  // else rigid
    /// k for a row whose inverse effective mass is `inverseMass` (1/kg, or 1/(kg m^2)).
    double stiffnessOf(double inverseMass) const {
        const double w = 6.283185307179586 * hz;
        return hz > 0.0 ? w * w / inverseMass : stiffness;
    }
    /// c for such a row.
    double resistanceOf(double inverseMass) const {
        return hz > 0.0 ? 2.0 * damping * (6.283185307179586 * hz) / inverseMass : resistance;
    }
    /// The same for that row, by k and c; none for a row that nothing can move.
    Spring fixedFor(double inverseMass) const {
        if (hz > 0.0 && !(inverseMass > 0.0)) return {};
        return {0.0, 0.0, stiffnessOf(inverseMass), resistanceOf(inverseMass)};
    }
};

/// No limit, or unlimited strength.
constexpr double kUnlimited = std::numeric_limits<double>::infinity();

/// The range of a free coordinate, m or rad. Angles may exceed a full turn.
struct Limits {
    double low = -kUnlimited, high = kUnlimited;  // at most `high`
    bool any() const { return low > -kUnlimited || high < kUnlimited; }  // on either side
};

/// Drives a free coordinate to a speed, with limited strength. With speed 0 it is a brake. Of an angle, the speed
/// and the strength fade where it is undefined, as a twist is after a swing by half a turn.
struct Motor {
    double speed = 0.0;     // m/s or rad/s
    double strength = 0.0;  // N or N m, maximum; 0: no motor; kUnlimited: no maximum
    bool isOn() const { return strength > 0.0; }  // also a brake
};

/// What acts along a free coordinate of a joint; by default nothing.
struct Freedom {
    bool locked = false;  // held at 0; sixDof only
    Limits limits;
    Motor motor;
    Spring spring;        // pulls towards `rest`; an angle's fades where the angle is undefined, as a
                          // twist is after a swing by half a turn
    double rest = 0.0;    // m or rad
    double inertia = 0.0; // I, kg or kg m^2: of a rotor that moves with the coordinate and is
                          // driven by nothing else. Geared n : 1, it is n^2 times the rotor's own
    /// Whether anything acts, if the coordinate is free.
    bool acts() const {
        return limits.any() || motor.isOn() || spring.isSoft() || inertia > 0.0;
    }
};

/// Everything that World::add needs to know about a joint; the valid values are documented there.
struct JointDef {
    JointType type = JointType::ball;
    BodyId a, b;                 // two bodies, one of them dynamic
    Vec3 anchorA{0, 0, 0};       // m, in a's body axes from its centre of mass
    Vec3 anchorB{0, 0, 0};       // m, in b's
    Vec3 axis{0, 0, 1};          // world axes, at the moment of adding, any length
    Vec3 axis2{0, 0, 0};         // the same; 0: `axis`. universal, wheel: perpendicular to `axis`, not 0.
                                 // sixDof: x is along `axis`, y along axis2; 0: the world's axes
    double length = 0.0;         // m, distance joint; positive unless limited or driven
    Spring spring;               // of all fixed rows; of a limited distance: towards `length`
    std::array<Freedom, 6> free; // by coordinate, see JointType; angles from the moment of adding
    double ratio = 1.0;          // gear; below 0: opposite directions
    std::vector<Vec3> path;      // m, in a's body axes: points that the curve passes through, at least 2
    bool closed = false;         // the path continues from its last point to its first
    double breakForce = kUnlimited;   // N and N m, see JointState: above them the joint is removed
    double breakTorque = kUnlimited;  // at the end of the step (StepReport::broken)

    /// Whether anything acts along one of its coordinates.
    bool acts() const {
        for (const Freedom& f : free)
            if (f.acts()) return true;
        return false;
    }
};

/// The state of a joint after the last step.
struct JointState {
    JointDef def;
    Vec3 worldA, worldB;         // m, the two anchors
    Vec3 worldAxis, worldAxis2;  // unit: `axis` moving with a, axis2 moving with b
    Vec3 worldAxis2A;            // unit: axis2 moving with a; with worldAxis, a sixDof's frame
    double separation = 0.0;     // m: |C| of the rows in metres, and violation of limits
    double position = 0.0;       // m or rad: coordinate 0; full turns are counted
    double speed = 0.0;          // m/s or rad/s, of coordinate 0
    std::array<double, 6> positions{}, speeds{};  // of all coordinates
    Vec3 force{0, 0, 0};         // N, on b, mean over the last step
    Vec3 torque{0, 0, 0};        // N m, on b about its anchor, mean over the last step
    bool removed = false;        // by the caller, with one of its bodies, or because it broke
    bool broken = false;         // it was removed because it broke
};

}  // namespace engine
