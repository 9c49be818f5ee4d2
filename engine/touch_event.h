/// What World::touches tells.
#pragma once
#include "engine/body.h"

namespace engine {

/// Two bodies began to touch, or have parted.
struct TouchEvent {
    /// Which of the two.
    enum class Kind { begin, end };
    Kind kind = Kind::begin;
    BodyId a, b;                     // a < b
    bool sensor = false;             // one of them is a sensor: no impulse ever
    long long step = 0;              // the step that saw it, from 1
    double time = 0.0;               // s, at the end of that step
    Vec3 position = Vec3::Zero();    // m, amid the points that touch; end: of the last ones
    Vec3 normal = Vec3::UnitY();     // unit, from a to b
    double speed = 0.0;              // m/s, begin: at which the two approached before the step
    double impulse = 0.0;            // N s along the normal; begin: in this step; end: since the
                                     // beginning
};

}  // namespace engine
