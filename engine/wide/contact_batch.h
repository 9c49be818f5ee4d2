/// Eight contacts side by side, as the wide solver streams them: plain floats, lane after lane. What
/// they are is in constraints/contact_constraint.h; here everything is said in a contact's own frame
/// (t1, t2, n) at its centre c. The points of a manifold lie in one plane across n, so that three
/// numbers hold how they move along it, and three how they slip:
///   along n     v_i = s_n + y_i w_1 - x_i w_2
///   across n    v_i = (s_1 - y_i w_n,  s_2 + x_i w_n)
/// The arms of b follow from those of a, r_b = r_a + (x_a - x_b), so that c's velocity needs one cross
/// product for each of the two bodies' difference:
///   v_b + w_b x r_b - v_a - w_a x r_a  =  (v_b - v_a + w_b x d) + (w_b - w_a) x r_a,   d = x_a - x_b
#pragma once

namespace engine {

/// The gap of a point that does not exist, m: no such point is ever met.
inline constexpr float kNoPoint = 1e6f;

/// What solving has changed of [v; w] of one body, in single precision; the fourth floats are 0. Changes
/// and not velocities: a body that slides at 10 m/s is braked by 0.01 m/s a sub-step, and of the sum a
/// float would keep four digits of that. Also used for ways and turns.
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

/// Two rows across each other: constraints/cone.h.
struct WideCone {
    float stop[3][8];          // K^-1: 11, 12, 22
    float mass[8];             // 1 / largest eigenvalue of K
    float k[8];                // that eigenvalue
};

/// Rolling resistance: constraints/rolling.h. Read where there is any.
struct WideRolling {
    float turn[2][8];          // rad/s about t1, t2, before solving
    float moment[2][8];        // N m s
    WideCone cone;
};

struct alignas(32) ContactBatch {
    static constexpr int kPoints = 4;
    int a[8], b[8];            // bodies; a lane without a contact names the last two slots
    int writeA[8], writeB[8];  // where their velocities go: the last slots, if nothing moves them
    float n[3][8], t1[3][8], t2[3][8];
    float centre[3][8];        // r_a of c, m
    float offset[3][8];        // d, m
    float massA[8], massB[8];  // 1/kg
    float turnA[6][8], turnB[6][8];  // I^-1, world axes: xx xy xz yy yz zz
    float mu[8];
    float reach[8];            // m, of the points from c
    float slip[3][8];          // s_1, s_2 (m/s) and w_n (rad/s) before solving
    float k[10][8];            // J M^-1 J^T of the normals, diagonal raised: 00 01 02 03 11 12 ...
    float inverse[10][8];      // of the rows that pushed last; 0 in the others
    float coupling[9][8];      // what impulses along n change of the slip, row after row
    float twistK[6][8];        // J M^-1 J^T of s_1, s_2, w_n
    float twistMass[6][8];     // its inverse; without w_n where there is one point only
    float rolling[8];          // rho, m
    WidePoint point[kPoints];
    WideCone slide[kPoints];   // friction at one point alone, for manifolds that slip
    WideRolling roll;
};

/// What a batch keeps besides, read a few times a step instead of in every sweep.
struct alignas(32) ContactRecord {
    int contact[8];                     // which, by place; -1: none in this lane
    float restitution[8];
    float approach[4][8];               // the velocity along n before solving, m/s
    float gapAtStart[4][8];             // C when the rows were made, m; large where there is no point
    float separation[4][8];             // C now
    float total[4][8];                  // N s along n, over the whole step
    float totalFriction[4][2][8];
};

}  // namespace engine
