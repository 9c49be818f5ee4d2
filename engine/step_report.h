/// What one step did, in numbers.
#pragma once
#include <vector>

#include "engine/base/math.h"
#include "engine/body.h"

namespace engine {

/// The six of the second seed's loop, as an observer sees them go by.
enum class Phase { forces, velocities, impulses, positions, nudges, collisions };

/// One sweep over all rows of a sub-step.
struct SweepReport {
    double residual = 0.0;  // m/s (rad/s): the largest velocity correction along a row
    double delta = 0.0;     // N s: sum of |change of lambda|
};

enum class Trouble {
    none,
    positionNotFinite,
    velocityNotFinite,
    positionTooLarge,  // farther than 1e5 m from the origin
    velocityTooLarge,  // faster than 1e4 m/s or rad/s
    energyJump         // ten times the energy in one step, with no kinematic body to give it
};

struct Energy {
    double kinetic = 0.0;    // J
    double potential = 0.0;  // J, in the field of gravity, 0 at the origin
    double total() const { return kinetic + potential; }
};

struct StepReport {
    long long step = 0;               // steps done since the start
    double time = 0.0;                // s
    int substeps = 0;                 // that the step was cut into
    int contacts = 0;                 // points that touch or may touch within the next step
    double worstPenetration = 0.0;    // m
    double worstSeparation = 0.0;     // m, of joints
    Energy energy;
    double residual = 0.0;            // m/s, of the last sweep of the last sub-step
    std::vector<SweepReport> sweeps;  // of all sub-steps, in order
    Trouble trouble = Trouble::none;  // not none: the world is back where the step began, and stays
    BodyId troubledBody;
};

/// A contact point as the last step's solver left it: where it was solved and what it got.
struct ContactState {
    BodyId a, b;
    Vec3 position;             // m, half way between the two surfaces
    Vec3 normal;               // unit, from a to b
    double penetration = 0.0;  // m; negative: still apart
    double impulse = 0.0;      // N s along the normal, over the whole step
    Vec3 friction;             // N s on b, over the whole step
    int feature = 0;           // same number = same corner or edge pair as before
};

}  // namespace engine
