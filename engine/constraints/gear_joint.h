/// Gear: two bodies turn at a fixed ratio, each about its own axis.
///   C = phi_b - r phi_a       phi: angle a body has turned about its axis since the gear was made,
///                             the twist of q q_0^-1 about h as it was then (turning.h, with w of
///                             that body alone)
///   J = [0, -r rate_a, 0, rate_b]
/// The axes must be held by hinges on something at rest, because phi is measured in the world. External teeth
/// have r = -n_a / n_b, an internal ring or a chain r = n_a / n_b.
#pragma once
#include "engine/constraints/joint_constraint.h"

namespace engine {

inline Angle turnOfA(const JointGeometry& g) {
    return twistAbout(g.startAxisA, g.sinceStartA, g.near[0]);
}
inline Angle turnOfB(const JointGeometry& g) {
    return twistAbout(g.startAxisB, g.sinceStartB, g.near[1]);
}

inline void addGearRow(const JointGeometry& g, JointRows& rows) {
    const Angle a = turnOfA(g), b = turnOfB(g);
    rows.add({Vec3::Zero(), Vec3(-g.ratio * a.rate), b.rate}, b.value - g.ratio * a.value);
}

inline void addGearCoordinates(const JointGeometry& g, JointRows& coordinates) {
    const Angle a = turnOfA(g), b = turnOfB(g);
    coordinates.add({Vec3::Zero(), a.rate, Vec3::Zero()}, a.value);
    coordinates.add({Vec3::Zero(), Vec3::Zero(), b.rate}, b.value);
}

}  // namespace engine
