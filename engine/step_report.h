/// The results of one step.
#pragma once
#include <vector>

#include "engine/base/math.h"
#include "engine/joint.h"

namespace engine {

/// The six phases of the second seed's loop, for observers.
enum class Phase { forces, velocities, impulses, positions, nudges, collisions };

/// One sweep over all rows of a sub-step.
struct SweepReport {
    double residual = 0.0;  // m/s (rad/s): the largest velocity correction along a row
    double delta = 0.0;     // N s: sum of |change of lambda|
    double distance = -1.0; // m/s (rad/s): largest difference of a velocity from the direct
                            // solution; -1: not requested, or there is none
};

/// The direct solver's result in the worst sub-step of a step; all zero with other solvers.
struct DirectReport {
    int rows = 0;                      // active rows
    int rank = 0;                      // rank; below rows: solved with the least impulses
    std::vector<JointId> redundant;    // joints with a row that depends on others
    bool contradiction = false;        // not all rows could be satisfied: least squares
    bool found = true;                 // false: found no consistent set of contacts; used sweeps
};

/// What went wrong in a step. Except for tooManyRows and tooManyContacts, the rest of the world continues.
enum class Trouble {
    none,              // the step went well
    positionNotFinite, // the body was removed from the world, as by World::remove
    velocityNotFinite, // the same
    positionTooLarge,  // the same: farther than 1e5 m from the origin
    velocityTooLarge,  // the body was slowed down to 1e4 m/s or rad/s
    energyJump,        // tenfold energy in one step, with no force, motor or moving kinematic body
    tooManyRows,       // more than the direct solver accepts (solver/direct.h): no step was done
    tooManyContacts    // more than 200 000, or too many pairs of bodies or of their pieces: the same
};

/// Trouble with one body.
struct Incident {
    Trouble trouble = Trouble::none;
    BodyId body;  // none if no single body is concerned
};

/// The energy of all dynamic bodies.
struct Energy {
    double kinetic = 0.0;    // J
    double potential = 0.0;  // J, in gravity, 0 at the origin
    double elastic = 0.0;    // J, in soft joints
    double total() const { return kinetic + potential + elastic; }  // J
};

/// The report of the last step.
struct StepReport {
    long long step = 0;               // steps done since the start
    double time = 0.0;                // s
    int substeps = 0;                 // sub-steps in this step
    int asleep = 0;                   // sleeping bodies (dynamics/sleep.h)
    Energy energy;
    double residual = 0.0;            // m/s, of the last sweep of the last sub-step
    std::vector<SweepReport> sweeps;  // of all sub-steps, in order
    DirectReport direct;              // from the direct solver
    std::vector<JointId> broken;      // joints that broke in this step, in their order
    std::vector<Incident> incidents;  // bodies removed or slowed down, or an energy jump
    Trouble trouble = Trouble::none;  // not none: the step was undone, further steps do nothing
};

/// The position errors of contacts and joints.
struct ErrorReport {
    int contacts = 0;          // points that touch or may touch within the next step
    double penetration = 0.0;  // m, the deepest
    double separation = 0.0;   // m, largest of a joint; soft joints do not count
};

/// A contact point after the last step: its position and impulses in the solver.
struct ContactState {
    BodyId a, b;               // the two bodies
    Vec3 position;             // m, half way between the two surfaces
    Vec3 normal;               // unit, from a to b
    double penetration = 0.0;  // m; negative: still apart
    double impulse = 0.0;      // N s along the normal, over the whole step
    Vec3 friction;             // N s on b, over the whole step
    int feature = 0;           // same number = same corner or edge pair as in the last step
};

}  // namespace engine
