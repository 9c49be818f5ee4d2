/// Limits, motors and springs of joints in a step (constraints/drive.h). The joint itself is solved as usual,
/// in its tree or in the sweep, and these rows follow it.
#pragma once
#include "engine/solver/solver.h"

namespace engine {

/// Sets the masses of a joint that is made, for springs that are given by a frequency.
void measureMasses(Joint& joint, const Bodies& bodies);

/// Makes the rows of a joint with drives, when joints are added or removed.
JointDrive makeDrive(const Joint& joint, int number);

/// Computes J, K and C of a group at the present poses; full turns are counted.
void prepareDrives(std::span<Joint> joints, const Bodies& bodies, int group, Constraints& c);

/// Sets b, softness and bounds of all that act, for a sub-step of the world of h (s).
void setDriveBiases(Constraints& c, const Settings& settings, double h);

/// Sets the rates of springs of joints that act, before a sub-step's forces act (constraints/soft.h).
void measureSprings(Constraints& c, const Bodies& bodies);

/// Stores the rates that inertias keep, of joints that act: after a solve, and before a step if the caller has set
/// velocities.
void keepRates(Constraints& c, const Bodies& bodies);

void warmStartDrives(Constraints& c, double keep, std::span<Velocity> v);

void sweepDrive(JointDrive& drive, std::span<Velocity> v, Correction& correction);

/// Nudges the coordinates of a group that are beyond a limit once, in a sub-step of the world of h (s):
///   lambda_n = -beta C / K,  C < 0
/// True if bodies were moved.
bool nudgeDrives(std::span<const Joint> joints, Bodies& bodies, const Constraints& c, int group,
                 const Settings& settings, double h);

/// Stores the impulses for the next step, and adds them to the joints' mean forces.
void storeDrives(const Constraints& c, const Bodies& bodies, std::span<Joint> joints, double dt);

/// Energy of the springs along a joint's coordinates, J.
double driveEnergy(const Joint& joint, const Bodies& bodies, double h);

/// Energy of the inertias along them, J.
double rotorEnergy(const Joint& joint, const Bodies& bodies);

}  // namespace engine
