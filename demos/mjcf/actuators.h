/// <actuator> and <keyframe>: the forces of actuators at constant controls.
#pragma once
#include "demos/mjcf/affine_force.h"
#include "demos/mjcf/geoms.h"

namespace demos::mjcf {

struct Actuation {
    ForcesByName joints, tendons;
};

/// The controls are those of the first <key> that has some, else 0. With affine gain and bias
///   force = gain ctrl + bias,  gain = g0 + g1 l + g2 dl/dt,  bias = b0 + b1 l + b2 dl/dt
/// where l = gear q is the length of the actuator: an affine force along its joint or tendon.
/// `root`: <mujoco>.
Actuation readActuators(const Element& root, const Context& context);

}  // namespace demos::mjcf
