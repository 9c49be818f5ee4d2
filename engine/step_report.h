/// What one step did, in numbers.
#pragma once
#include <vector>

#include "engine/base/math.h"
#include "engine/joint.h"

namespace engine {

/// The six of the second seed's loop, as an observer sees them go by.
enum class Phase { forces, velocities, impulses, positions, nudges, collisions };

/// One sweep over all rows of a sub-step.
struct SweepReport {
    double residual = 0.0;  // m/s (rad/s): the largest velocity correction along a row
    double delta = 0.0;     // N s: sum of |change of lambda|
    double distance = -1.0; // m/s (rad/s): largest difference of a velocity from the direct
                            // solution; -1: not asked for, or there is none
};

/// What the direct solver found in the worst sub-step of a step; all zero with other solvers.
struct DirectReport {
    int rows = 0;                      // that were active
    int rank = 0;                      // of them; fewer than rows: solved with the least impulses
    std::vector<JointId> redundant;    // joints with a row that follows from others
    bool contradiction = false;        // the rows could not all be met: met as nearly as possible
    bool found = true;                 // false: no consistent set of contacts; sweeps took over
};

/// What went wrong in a step. The rest of the world goes on, but for tooManyRows.
enum class Trouble {
    none,              // the step went well
    positionNotFinite, // the body was taken out of the world, as by World::remove
    velocityNotFinite, // likewise
    positionTooLarge,  // likewise: farther than 1e5 m from the origin
    velocityTooLarge,  // the body was slowed down to 1e4 m/s or rad/s
    energyJump,        // ten times the energy in one step, with no kinematic body to give it
    tooManyRows        // more than the direct solver takes (solver/direct.h): no step was done
};

/// Trouble of one body.
struct Incident {
    Trouble trouble = Trouble::none;
    BodyId body;  // none where it is not one body
};

/// Of all dynamic bodies together.
struct Energy {
    double kinetic = 0.0;    // J
    double potential = 0.0;  // J, in the field of gravity, 0 at the origin
    double elastic = 0.0;    // J, in soft joints
    double total() const { return kinetic + potential + elastic; }  // J
};

/// Everything the last step says of itself.
struct StepReport {
    long long step = 0;               // steps done since the start
    double time = 0.0;                // s
    int substeps = 0;                 // that the step was cut into
    int asleep = 0;                   // bodies that the step left alone (dynamics/sleep.h)
    Energy energy;
    double residual = 0.0;            // m/s, of the last sweep of the last sub-step
    std::vector<SweepReport> sweeps;  // of all sub-steps, in order
    DirectReport direct;              // of the direct solver
    std::vector<JointId> broken;      // joints that the step broke, in their order
    std::vector<Incident> incidents;  // bodies that could not go on as they were
    Trouble trouble = Trouble::none;  // not none: the world is back where the step began, and stays
};

/// How far contacts and joints are from where they should be.
struct ErrorReport {
    int contacts = 0;          // points that touch or may touch within the next step
    double penetration = 0.0;  // m, the deepest
    double separation = 0.0;   // m, of the joint that is farthest apart; soft ones do not count
};

/// A contact point as the last step's solver left it: where it was solved and what it got.
struct ContactState {
    BodyId a, b;               // the two that touch
    Vec3 position;             // m, half way between the two surfaces
    Vec3 normal;               // unit, from a to b
    double penetration = 0.0;  // m; negative: still apart
    double impulse = 0.0;      // N s along the normal, over the whole step
    Vec3 friction;             // N s on b, over the whole step
    int feature = 0;           // same number = same corner or edge pair as before
};

}  // namespace engine
