/// A joint of a tree, stored without rows: the point and the twist that it constrains.
///   point  u = v_b + w_b x r_b - v_a - w_a x r_a        three rows, along x, y and z
///   twist  t_i.(w_b - w_a)                              two more for a hinge, three for a weld
/// As matrices, with R_s = [r_s x; t] (its rows are r_s x e and t) and E = [1; 0]:
///   J = [-E, -R_a, E, R_b]
///   J M^-1 J^T = (1/m_a + 1/m_b) E E^T + R_a I_a^-1 R_a^T + R_b I_b^-1 R_b^T
/// It is the J of ball_joint.h, hinge_joint.h, weld_joint.h (for small errors, u = 0 there) and
/// distance_joint.h in a form a quarter of the size of rows. Of the point, a rod holds the component along n,
/// and a slider (slider_joint.h) those across its axis, with a's arm to p_b: B u instead of u, where
///   B = [n; 0; 0],   B = [t_1; t_2; 0]
/// Universal (universal_joint.h) and constant velocity joints are ball joints with one twist. Of six degrees of
/// freedom (six_dof_joint.h), those that are locked are taken, directions of the point as a slider's. A gear
/// (gear_joint.h) holds no point, B = 0, and has different twists on its bodies: r rate_a and rate_b. N is 3,
/// 5 or 6; a joint with fewer rows than its tree has zeros in the last ones, and so has B.
#pragma once
#include <array>

#include "engine/constraints/joint_constraint.h"

namespace engine {

template <int N>
using TreeRows = Eigen::Matrix<double, N, 1>;
template <int N>
using TreeBlock = Eigen::Matrix<double, N, N>;

template <int N>
using Twist = std::array<Vec3, N - 3>;

/// The inputs of a joint's J and C, in world axes.
template <int N>
struct TreeGeometry {
    Vec3 armA, armB;                         // m
    Twist<N> twist;                          // unit; of a gear: on b
    Vec3 along;                              // hinge: its axis
    Vec3 point[2];                           // rod: n; slider: t_1, t_2
    TreeRows<N> error = TreeRows<N>::Zero(); // C, m or rad
};

template <int N>
struct TreeJoint {
    int a = -1, b = -1;        // bodies
    int ownA = -1, ownB = -1;  // their indices in the tree's own list
    int joint = -1;            // number in the world
    int constraint = -1;       // index in the constraint list
    int tree = -1;
    JointType type = JointType::ball;
    int pointRows = 3;         // 3: x, y and z
    bool isGear = false;
    bool hasOwnRows = true;    // its rows here are those of rowsOf()
    bool closes = false;       // holds its tree at a second fixed body, or closes a loop
    Vec3 anchorA, anchorB;     // m, in the bodies' axes
    double reach = 0.0;        // m, the longest of its lever arms
    Twist<N> across;           // hinge, slider: perpendicular to its axis, in a's axes
    Twist<N> twistOfA;         // gear: on a
    TreeGeometry<N> now;
    TreeRows<N> lambda = TreeRows<N>::Zero();                  // N s, N m s; of this sub-step
    TreeRows<N> bend = TreeRows<N>::Zero();                    // kappa (chords.h), m/s, rad/s; 0 with RATTLE
    TreeRows<N> softness = TreeRows<N>::Zero();                // gamma, 1/kg, 1/(kg m^2)
    Vec3 impulse = Vec3::Zero(), torque = Vec3::Zero();        // on b, over the whole step
};

/// How many directions of the point a joint holds.
inline int pointRowsOf(const JointDef& def) {
    switch (def.type) {
        case JointType::gear: return 0;
        case JointType::distance: return 1;
        case JointType::slider: return 2;
        case JointType::sixDof: return lockedOf(def, 0);
        default: return 3;
    }
}

/// The angle that one body of a gear has turned about its axis.
inline Angle turnOf(const Vec3& axis, const Quat& rotation, const Quat& start, double near) {
    return twistAbout(start * axis, rotation * start.conjugate(), near);
}
inline Angle turnOfA(const Joint& gear, const Pose& a) {
    return turnOf(gear.axisA, a.rotation, gear.startA, gear.position[0]);
}
inline Angle turnOfB(const Joint& gear, const Pose& b) {
    return turnOf(gear.axis2B, b.rotation, gear.startB, gear.position[1]);
}

/// Sets the other twist of a gear.
template <int N>
inline void setTwistOfA(const Joint& def, const Pose& a, TreeJoint<N>& joint) {
    if constexpr (N > 3) {
        for (Vec3& t : joint.twistOfA) t.setZero();
        joint.twistOfA[0] = def.def.ratio * turnOfA(def, a).rate;
    }
}

/// The axes of a sixDof's frame.
inline std::array<Vec3, 3> frameOf(const Joint& def, const Pose& a) {
    const Vec3 x = a.rotation * def.axisA, y = a.rotation * def.axis2A;
    return {x, y, x.cross(y)};
}

template <int N>
inline void addLockedTwists(const Joint& def, const Pose& a, const Pose& b, TreeGeometry<N>& g) {
    const std::array<Vec3, 3> frame = frameOf(def, a);
    const Quat turn = b.rotation * (a.rotation * def.turnAtStart).conjugate();
    for (int i = 0, k = 0; i < 3; ++i) {
        if (!def.def.free[3 + i].locked) continue;
        const Angle twist = heldTwist(frame[i], turn);
        g.twist[k] = twist.rate;
        g.error[3 + k++] = twist.value;
    }
}

/// The directions of the point that a sixDof holds if it does not hold all of them.
template <int N>
inline void addLockedDirections(const Joint& def, const Pose& a, const Vec3& between,
                                TreeGeometry<N>& g) {
    const std::array<Vec3, 3> frame = frameOf(def, a);
    g.armA += between;
    for (int i = 0, k = 0; i < 3; ++i) {
        if (!def.def.free[i].locked) continue;
        g.point[k] = frame[i];
        g.error[k++] = frame[i].dot(between);
    }
}

template <int N>
inline void addTwist(const TreeJoint<N>& joint, const Joint& def, const Pose& a, const Pose& b,
              TreeGeometry<N>& g) {
    if constexpr (N > 3) {
        for (Vec3& t : g.twist) t.setZero();
        if (joint.isGear) {
            const Angle turn = turnOfB(def, b);
            g.twist[0] = turn.rate;
            g.error[3] = turn.value - def.def.ratio * turnOfA(def, a).value;
        }
        if (joint.type == JointType::hinge) {
            g.along = b.rotation * def.axisB;
            for (int i = 0; i < 2; ++i) {  // C = t.h,  dC/dt = -(t x h).(w_b - w_a)
                const Vec3 across = a.rotation * joint.across[i];
                g.twist[i] = g.along.cross(across);
                g.error[3 + i] = across.dot(g.along);
            }
        }
        if (joint.type == JointType::universal) {
            const Vec3 pinA = a.rotation * def.axisA, pinB = b.rotation * def.axis2B;
            g.twist[0] = pinB.cross(pinA);
            g.error[3] = pinA.dot(pinB);
        } else if (joint.type == JointType::constantVelocity) {
            const Quat turn = b.rotation * (a.rotation * def.turnAtStart).conjugate();
            const Angle twist = heldTwist(a.rotation * def.axisA, turn);
            g.twist[0] = twist.rate;
            g.error[3] = twist.value;
        } else if (joint.type == JointType::sixDof) {
            addLockedTwists(def, a, b, g);
        }
        if constexpr (N == 6) {
            if (joint.type != JointType::weld && joint.type != JointType::slider) return;
            Quat tooFar = b.rotation * (a.rotation * def.turnAtStart).conjugate();
            if (tooFar.w() < 0.0) tooFar.coeffs() = -tooFar.coeffs();  // the shorter rotation
            for (int i = 0; i < 3; ++i) g.twist[i] = Vec3::Unit(i);
            g.error.template tail<3>() = 2.0 * tooFar.vec();
        }
    }
}

template <int N>
inline TreeGeometry<N> geometryOf(const TreeJoint<N>& joint, const Joint& def, const Pose& a,
                           const Pose& b) {
    TreeGeometry<N> g;
    g.armA = a.rotation * joint.anchorA;
    g.armB = b.rotation * joint.anchorB;
    const Vec3 between = (b.position + g.armB) - (a.position + g.armA);
    if (joint.type == JointType::distance) {
        const double distance = between.norm();
        g.point[0] = distance > 0.0 ? Vec3(between / distance) : Vec3(Vec3::UnitY());
        g.error[0] = distance - def.def.length;
    } else if (joint.type == JointType::slider) {
        g.armA += between;
        for (int i = 0; i < smaller(N - 3, 2); ++i) {
            g.point[i] = a.rotation * joint.across[i];
            g.error[i] = g.point[i].dot(between);
        }
    } else if (joint.type == JointType::sixDof && joint.pointRows < 3) {
        addLockedDirections(def, a, between, g);
    } else if (!joint.isGear) {
        g.error.template head<3>() = between;
    }
    addTwist(joint, def, a, b, g);
    return g;
}

/// The twist on a or b.
template <int N>
inline const Twist<N>& twistOn(const TreeJoint<N>& joint, bool b) {
    return joint.isGear && !b ? joint.twistOfA : joint.now.twist;
}

/// B u
template <int N>
inline Vec3 heldOf(const TreeJoint<N>& joint, const Vec3& u) {
    const int rows = joint.pointRows;
    if (rows == 3) return u;
    if (rows == 0) return Vec3::Zero();
    return {joint.now.point[0].dot(u), rows > 1 ? joint.now.point[1].dot(u) : 0.0, 0.0};
}

/// B^T lambda
template <int N>
inline Vec3 pushOf(const TreeJoint<N>& joint, const TreeRows<N>& lambda) {
    const int rows = joint.pointRows;
    if (rows == 3) return lambda.template head<3>();
    if (rows == 0) return Vec3::Zero();
    const Vec3 first = lambda[0] * joint.now.point[0];
    return rows > 1 ? Vec3(first + lambda[1] * joint.now.point[1]) : first;
}

/// C at poses other than those of J.
template <int N>
inline TreeRows<N> errorAlong(const TreeJoint<N>& joint, const Joint& def, const Pose& a, const Pose& b) {
    return geometryOf(joint, def, a, b).error;
}

/// J v
template <int N>
inline TreeRows<N> velocityAlong(const TreeJoint<N>& joint, const Velocity& a, const Velocity& b) {
    TreeRows<N> result;
    result.template head<3>() = heldOf(joint, (b.linear - a.linear) +
                                                  b.angular.cross(joint.now.armB) -
                                                  a.angular.cross(joint.now.armA));
    if constexpr (N > 3) {
        const Vec3 turning = b.angular - a.angular;
        for (int i = 0; i < N - 3; ++i) result[3 + i] = joint.now.twist[i].dot(turning);
        if (joint.isGear)
            result[3] = joint.now.twist[0].dot(b.angular) - joint.twistOfA[0].dot(a.angular);
    }
    return result;
}

/// The sum of the twists of lambda on a or b, N m s.
template <int N>
inline Vec3 twistOf(const TreeJoint<N>& joint, const TreeRows<N>& lambda, bool b) {
    const Twist<N>& twist = twistOn(joint, b);
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < N - 3; ++i) sum += lambda[3 + i] * twist[i];
    return sum;
}

/// Adds a share of lambda to the joint's totals.
template <int N>
inline void book(TreeJoint<N>& joint, const TreeRows<N>& lambda, double share) {
    joint.lambda += share * lambda;
    joint.impulse += share * pushOf(joint, lambda);
    if constexpr (N > 3) joint.torque += share * twistOf(joint, lambda, true);
}

/// v += M^-1 J^T lambda
template <int N>
inline void apply(const TreeJoint<N>& joint, const TreeRows<N>& lambda, const InverseMass& massA,
                  const InverseMass& massB, Velocity& a, Velocity& b) {
    const Vec3 push = pushOf(joint, lambda);
    Vec3 turnA = joint.now.armA.cross(push), turnB = joint.now.armB.cross(push);
    if constexpr (N > 3) {
        const Vec3 twist = twistOf(joint, lambda, true);
        turnA += joint.isGear ? twistOf(joint, lambda, false) : twist;
        turnB += twist;
    }
    a.linear -= massA.linear * push;
    a.angular -= massA.angular * turnA;
    b.linear += massB.linear * push;
    b.angular += massB.angular * turnB;
}

/// R m, with the R of one arm; m has three rows.
template <int N, class Matrix>
Eigen::Matrix<double, N, Matrix::ColsAtCompileTime> leverTimes(const Vec3& r, const Twist<N>& twist,
                                                               const Matrix& m) {
    Eigen::Matrix<double, N, Matrix::ColsAtCompileTime> result;
    for (int j = 0; j < Matrix::ColsAtCompileTime; ++j) {
        const double x = m(0, j), y = m(1, j), z = m(2, j);
        result(0, j) = r.z() * y - r.y() * z;
        result(1, j) = r.x() * z - r.z() * x;
        result(2, j) = r.y() * x - r.x() * y;
        for (int i = 0; i < N - 3; ++i)
            result(3 + i, j) = twist[i].x() * x + twist[i].y() * y + twist[i].z() * z;
    }
    return result;
}

/// R_i I^-1 R_k^T + E E^T / m: the coupling through one body from the arm of k to that of i.
template <int N>
inline TreeBlock<N> couplingThrough(const InverseMass& mass, const Vec3& armI,
                                    const Twist<N>& twistI, const Vec3& armK,
                                    const Twist<N>& twistK) {
    const Eigen::Matrix<double, 3, N> turn =
        leverTimes<N>(armK, twistK, mass.angular).transpose();  // I^-1 is symmetric
    TreeBlock<N> block = leverTimes<N>(armI, twistI, turn);
    for (int i = 0; i < 3; ++i) block(i, i) += mass.linear;
    return block;
}

/// m B^T
template <int N>
inline void lookAlong(const TreeJoint<N>& joint, TreeBlock<N>& m) {
    for (int i = 0; i < N; ++i) {
        const Vec3 row = m.template block<1, 3>(i, 0).transpose();
        m.template block<1, 3>(i, 0) = heldOf(joint, row).transpose();
    }
}

/// B_i m B_k^T
template <int N>
inline void lookAlong(const TreeJoint<N>& i, const TreeJoint<N>& k, TreeBlock<N>& m) {
    if (k.pointRows < 3) lookAlong(k, m);
    if (i.pointRows == 3) return;
    m.transposeInPlace();
    lookAlong(i, m);
    m.transposeInPlace();
}

}  // namespace engine
