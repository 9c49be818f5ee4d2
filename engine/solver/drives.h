/// Limits, motors and springs of joints in a step (constraints/drive.h). A joint that has some is
/// solved as ever, in its tree or in the sweep, and these rows come after it.
#pragma once
#include "engine/solver/solver.h"

namespace engine {

/// Rows of a joint for which something acts; for when joints come or go.
JointDrive makeDrive(const Joint& joint, int number);

/// J, K and C at the bodies' present poses; turns are counted on.
void prepareDrives(std::span<Joint> joints, const Bodies& bodies, Constraints& c);

/// b, softness and bounds of a sub-step of length h (s).
void setDriveBiases(Constraints& c, const Settings& settings, double h);

/// The rates that inertias keep: after a solve, and before a step where the caller has set velocities.
void keepRates(Constraints& c, std::span<const Velocity> v);

void warmStartDrives(Constraints& c, double keep, std::span<Velocity> v);

void sweepDrives(Constraints& c, std::span<Velocity> v, Correction& correction);

/// One nudge of what has passed its limit in a sub-step of length h (s):  lambda_n = -beta C / K, C < 0
void nudgeDrives(std::span<const Joint> joints, Bodies& bodies, const Constraints& c,
                 const Settings& settings, double h);

/// Impulses go back to where the next step finds them, and into the joints' mean forces.
void storeDrives(const Constraints& c, const Bodies& bodies, std::span<Joint> joints, double dt);

/// J, in the springs along a joint's coordinates.
double driveEnergy(const Joint& joint, const Bodies& bodies, double h);

/// J, of the inertias along them.
double rotorEnergy(const Joint& joint, const Bodies& bodies);

}  // namespace engine
