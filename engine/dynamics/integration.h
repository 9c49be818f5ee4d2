/// Semi-implicit Euler: velocities first, then positions with the new velocities.
///   v1 = v0 + a h
///   x1 = x0 + v1 h
/// (Second seed, 'Integration'. This order keeps the energy of an oscillator bounded.)
#pragma once
#include <array>

#include "engine/dynamics/bodies.h"
#include "engine/dynamics/rotation.h"
#include "engine/settings.h"

namespace engine {

/// Step 2 of the loop, with the accelerations of step 1 (dynamics/forces.h), for acting bodies. h is
/// Bodies::spans.
void integrateVelocities(Bodies& bodies, Gyroscope gyroscope);

/// Step 4 of the loop. The inverse inertias are updated after the nudges, which rotate bodies as well.
void integratePositions(Bodies& bodies, Gyroscope gyroscope);

/// A body's rotation and spin after a time h (s) without torque.
void turnFreely(const BodyMass& mass, Gyroscope gyroscope, double h, Quat& rotation, Vec3& spin);

/// The same for many bodies, two of a kind at a time. What is added must stay where it is until finish().
class FreeTurns {
public:
    explicit FreeTurns(Gyroscope gyroscope) : gyroscope_(gyroscope) {}
    void add(const BodyMass& mass, double h, Quat& rotation, Vec3& spin);
    void finish();

private:
    Gyroscope gyroscope_;
    std::array<Turn, 3> waiting_;  // by kind; no mass: none
};

}  // namespace engine
