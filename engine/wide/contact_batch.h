/// Eight contacts side by side in the memory layout of the wide solver: plain floats, lane by lane. See
/// constraints/contact_constraint.h for their meaning. All values are in a contact's own frame (t1, t2, n) at
/// its centre c. The points of a manifold are in one plane perpendicular to n, so three numbers describe
/// their motion along n, and three their slip:
///   along n     v_i = s_n + y_i w_1 - x_i w_2
///   across n    v_i = (s_1 - y_i w_n,  s_2 + x_i w_n)
/// The arms of b follow from those of a, r_b = r_a + (x_a - x_b), so the velocity at c needs only two cross
/// products:
///   v_b + w_b x r_b - v_a - w_a x r_a  =  (v_b - v_a + w_b x d) + (w_b - w_a) x r_a,   d = x_a - x_b
#pragma once

namespace engine {

/// The gap of a missing point, m: such a point never touches.
inline constexpr float kNoPoint = 1e6f;
inline constexpr float kNotMade = -1.0f;  // of a cone

/// The change of [v; w] of one body by the solver, in single precision; the fourth floats are 0. It is a
/// change because a body that slides at 10 m/s is braked by 0.01 m/s per sub-step, and in the sum a float
/// would keep only four digits of that. Also used for translations and rotations.
struct alignas(32) WideVelocity {
    float linear[4] = {}, angular[4] = {};
};

struct WidePoint {
    float x[8], y[8];          // m, from c along t1 and t2
    float bias[8];             // b and the velocity along n before solving, m/s
    float lambda[8];           // N s along n
    float friction[2][8];      // N s along t1, t2
    float bounce[8];           // N s, from the impact pass of this sub-step
};

/// Two perpendicular rows: constraints/cone.h.
struct WideCone {
    float stop[3][8];          // K^-1: 11, 12, 22
    float mass[8];             // 1 / largest eigenvalue of K
    float k[8];                // that eigenvalue
};

/// Rolling resistance: constraints/rolling.h. Read only if there is any.
struct WideRolling {
    float turn[2][8];          // rad/s about t1, t2, before solving
    float moment[2][8];        // N m s
    WideCone cone;
};

struct alignas(32) ContactBatch {
    static constexpr int kPoints = 4;
    int a[8], b[8];            // bodies; an empty lane refers to the last slots
    int writeA[8], writeB[8];  // where velocities are written: the last slots for immovable bodies
    float n[3][8], t1[3][8], t2[3][8];
    float centre[3][8];        // r_a of c, m
    float offset[3][8];        // d, m
    float massA[8], massB[8];  // 1/kg
    float turnA[6][8], turnB[6][8];  // I^-1, world axes: xx xy xz yy yz zz
    float mu[8];
    float reach[8];            // m, largest coordinate of a point from c
    float slip[3][8];          // s_1, s_2 (m/s) and w_n (rad/s) before solving
    float k[10][8];            // J M^-1 J^T of the normals, with raised diagonal: 00 01 02 03 11 12 ...
    float inverse[10][8];      // for the rows that pushed last; 0 in the others
    float coupling[9][8];      // change of slip by impulses along n, row by row
    float twistMass[6][8];     // inverse of J M^-1 J^T of s_1, s_2, w_n; without w_n for a single point
    float rolling[8];          // rho, m
    WidePoint point[kPoints];
    WideRolling roll;
};

/// What a sweep reads only of batches in which a manifold slips: large piles are swept as fast as memory is read.
struct alignas(32) ContactSlip {
    float twistK[6][8];        // J M^-1 J^T of s_1, s_2, w_n
    WideCone slide[ContactBatch::kPoints];  // of single points, made when a manifold slips; k[0] < 0: not made
};

/// The rest of a batch's data, read a few times per step, not in every sweep.
struct alignas(32) ContactRecord {
    int contact[8];                     // index of the contact; -1: empty lane
    float restitution[8];
    float gapAtStart[4][8];             // C when the rows were made, m; large for a missing point
    float separation[4][8];             // C now
    float total[4][8];                  // N s along n, over the whole step
    float totalFriction[4][2][8];
};

}  // namespace engine
