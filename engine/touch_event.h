/// The events that World::touches returns.
#pragma once
#include "engine/body.h"

namespace engine {

/// Two bodies began or ceased to touch.
struct TouchEvent {
    /// Beginning or end.
    enum class Kind { begin, end };
    Kind kind = Kind::begin;
    BodyId a, b;                     // a < b
    bool sensor = false;             // one of them is a sensor: there is no impulse
    long long step = 0;              // the step that detected it, from 1
    double time = 0.0;               // s, at the end of that step
    Vec3 position = Vec3::Zero();    // m, mean of the touching points; end: of the last ones
    Vec3 normal = Vec3::UnitY();     // unit, from a to b
    double speed = 0.0;              // m/s, begin: approach speed before the step
    double impulse = 0.0;            // N s along the normal; begin: in this step; end: since the
                                     // beginning
};

}  // namespace engine
