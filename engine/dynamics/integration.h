/// Semi-implicit Euler: velocities first, then positions with the new velocities.
///   v1 = v0 + a h
///   x1 = x0 + v1 h
/// (Second seed, 'Integration'. The order is what keeps an oscillator's energy bounded.)
#pragma once
#include "engine/dynamics/bodies.h"
#include "engine/settings.h"

namespace engine {

/// Step 2 of the loop, with the accelerations of step 1 (dynamics/forces.h): h is Bodies::spans, for those
/// that act.
void integrateVelocities(Bodies& bodies, Gyroscope gyroscope);

/// Step 4 of the loop. The inverse inertias are made again after the nudges, which turn bodies as well.
void integratePositions(Bodies& bodies, Gyroscope gyroscope);

/// A body's rotation and spin after a time h (s) without torque.
void turnFreely(const BodyMass& mass, Gyroscope gyroscope, double h, Quat& rotation, Vec3& spin);

}  // namespace engine
