#include "demos/mjcf/freedom.h"

#include <cmath>

namespace demos::mjcf {
namespace {

constexpr double kOutOfReach = 1e6;  // rad/s or m/s: at this target speed a motor gives its maximum

double strength(Attributes& attributes, const char* name) {
    return attributes.number(name, kStrength).value_or(0.0);
}

}  // namespace

void actAlong(Attributes& attributes, AffineForce force, double rest, double ref,
              engine::Freedom& freedom) {
    const double stiffness = strength(attributes, "stiffness");
    const AffineForce own{stiffness * rest, stiffness, strength(attributes, "damping")};
    freedom.spring.stiffness = own.stiffness;
    freedom.spring.resistance = own.resistance;
    freedom.rest = rest - ref;
    freedom.motor.strength = strength(attributes, "frictionloss");
    freedom.inertia = strength(attributes, "armature");
    if (force.constant == 0.0 && force.isConstant()) return;
    force += own;
    if (force.stiffness < 0.0 || force.resistance < 0.0)
        return attributes.note("", "an actuator that makes stiffness or damping negative is "
                                   "not supported; left out");
    freedom.spring.stiffness = force.stiffness;
    freedom.spring.resistance = force.resistance;
    if (force.stiffness > 0.0) {
        freedom.rest = force.constant / force.stiffness - ref;
    } else if (force.constant != 0.0) {
        if (freedom.motor.isOn())
            attributes.note("frictionloss", "frictionloss with the constant force of an actuator "
                                            "is not supported; left out");
        freedom.motor = {std::copysign(kOutOfReach, force.constant), std::abs(force.constant)};
    }
}

bool isLimited(Attributes& attributes, const char* limited, const char* range, bool autoLimits) {
    const auto said = attributes.word(limited, {"true", "false", "auto"});
    if (!said || *said == "auto") return autoLimits && attributes.has(range);
    return *said == "true";
}

}  // namespace demos::mjcf
