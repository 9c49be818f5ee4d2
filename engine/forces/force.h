/// A force of a world: what it is, on which bodies, and when. World::add takes it; every sub-step
/// asks it anew, with the bodies where they are by then.
#pragma once
#include <limits>
#include <span>
#include <variant>
#include <vector>

#include "engine/forces/airfoil.h"
#include "engine/forces/constant_force.h"
#include "engine/forces/drag.h"
#include "engine/forces/medium.h"
#include "engine/forces/n_body_gravity.h"
#include "engine/forces/point_gravity.h"
#include "engine/forces/spring_force.h"
#include "engine/step_report.h"

namespace engine {

struct ForceId {
    int index = -1;
    auto operator<=>(const ForceId&) const = default;
};

using ForceKind = std::variant<ConstantForce, Drag, Medium, PointGravity, NBodyGravity,
                               SpringForce, Airfoil>;

struct ForceDef {
    ForceKind kind;
    std::vector<BodyId> on;  // a spring: its two bodies
    double from = 0.0;       // s
    double until = std::numeric_limits<double>::infinity();  // s
};

/// Whether it acts in the span of time that begins at `time` and is `h` long (s): the half of a
/// span and more counts as all of it.
bool acts(const ForceDef& force, double time, double h);

void addLoads(const ForceDef& force, const Bodies& bodies, const ForceMoment& now,
              std::span<Load> loads);

/// J: what the force could give back, in `potential` or `elastic`; of those that have a potential.
void addPotential(const ForceDef& force, const Bodies& bodies, Energy& energy);

}  // namespace engine
