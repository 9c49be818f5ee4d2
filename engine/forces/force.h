/// What the forces of a world say of a sub-step, by the kind of each.
#pragma once
#include <span>

#include "engine/forces/airfoil.h"
#include "engine/forces/constant_force.h"
#include "engine/forces/drag.h"
#include "engine/forces/medium.h"
#include "engine/forces/n_body_gravity.h"
#include "engine/forces/point_gravity.h"
#include "engine/forces/spring_force.h"
#include "engine/step_report.h"

namespace engine {

/// Whether it acts in the span of time that begins at `time` and is `h` long (s): the half of a
/// span and more counts as all of it.
bool acts(const ForceDef& force, double time, double h);

void addLoads(const ForceDef& force, const Bodies& bodies, const ForceMoment& now,
              std::span<Load> loads);

/// J: what the force could give back, in `potential` or `elastic`; of those that have a potential.
void addPotential(const ForceDef& force, const Bodies& bodies, Energy& energy);

}  // namespace engine
