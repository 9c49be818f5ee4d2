#include "engine/dynamics/integration.h"

#include "engine/dynamics/rotation.h"

namespace engine {

void integrateVelocities(Bodies& bodies, Gyroscope gyroscope) {
    for (const int i : bodies.active) {
        if (!bodies.isActing(i)) continue;
        const double h = bodies.spans[i];
        Velocity& v = bodies.velocities[i];
        v.linear += h * bodies.accelerations[i].linear;
        v.angular += h * bodies.accelerations[i].angular;
        if (gyroscope == Gyroscope::implicitEuler)
            v.angular = spinAfterGyroscopicTorque(bodies.masses[i], bodies.poses[i].rotation,
                                                  v.angular, h);
    }
}

void turnFreely(const BodyMass& mass, Gyroscope gyroscope, double h, Quat& rotation, Vec3& spin) {
    if (gyroscope == Gyroscope::momentum && mass.mass > 0.0)
        turnKeepingMomentum(mass, h, rotation, spin);
    else
        rotation = turnedBy(h * spin, rotation);
}

void FreeTurns::add(const BodyMass& mass, double h, Quat& rotation, Vec3& spin) {
    if (gyroscope_ != Gyroscope::momentum || !(mass.mass > 0.0))
        return turnFreely(mass, gyroscope_, h, rotation, spin);
    Turn& waiting = waiting_[kindOfTurn(mass)];
    if (waiting.mass == nullptr) {
        waiting = {&mass, h, &rotation, &spin};
        return;
    }
    turnTwo(waiting, {&mass, h, &rotation, &spin});
    waiting = {};
}

void FreeTurns::finish() {
    for (Turn& turn : waiting_) {
        if (turn.mass == nullptr) continue;
        turnKeepingMomentum(*turn.mass, turn.h, *turn.rotation, *turn.spin);
        turn = {};
    }
}

void integratePositions(Bodies& bodies, Gyroscope gyroscope) {
    FreeTurns turns(gyroscope);
    for (const int i : bodies.active) {
        if (!bodies.isGoing(i)) continue;
        const double h = bodies.spans[i];
        Velocity& v = bodies.velocities[i];
        Pose& pose = bodies.poses[i];
        pose.position += h * v.linear;
        turns.add(bodies.masses[i], h, pose.rotation, v.angular);
    }
    turns.finish();
}

}  // namespace engine
