/// Eight contacts side by side, as the wide solver streams them: plain floats, lane after lane. What
/// they are is in constraints/contact_constraint.h; here the arms of b follow from those of a,
///   r_b = r_a + (x_a - x_b)
/// so that the point's relative velocity needs one cross product:
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
    float arm[3][8];           // r_a, m
    float frictionMass[3][8];  // K_t^-1: 11, 12, 22
    float slideMass[8];        // 1 / largest eigenvalue of K_t
    float slideK[8];           // that eigenvalue
    float bias[8];             // b and the velocity along n before solving, m/s
    float slip[2][8];          // the velocity along t1, t2 before solving, m/s
    float lambda[8];           // N s along n
    float friction[2][8];      // N s along t1, t2
    float bounce[8];           // N s, from the impact pass of this sub-step
};

struct alignas(32) ContactBatch {
    static constexpr int kPoints = 4;
    int a[8], b[8];            // bodies; a lane without a contact names the last two slots
    int writeA[8], writeB[8];  // where their velocities go: the last slots, if nothing moves them
    float n[3][8], t1[3][8], t2[3][8];
    float offset[3][8];        // d, m
    float massA[8], massB[8];  // 1/kg
    float turnA[6][8], turnB[6][8];  // I^-1, world axes: xx xy xz yy yz zz
    float mu[8];
    float k[10][8];            // J M^-1 J^T of the normals, diagonal raised: 00 01 02 03 11 12 ...
    float inverse[10][8];      // 0 in the rows of points that do not exist
    WidePoint point[kPoints];
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
