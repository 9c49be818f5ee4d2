/// Evaluates the forces of a world for a sub-step, by their kind.
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

/// Whether the force acts in the sub-step that begins at `time` and has length `h` (s): it does if
/// it acts at its middle.
bool acts(const ForceDef& force, double time, double h);

/// Whether the load of one of its bodies depends on the others, which then need the same sub-steps.
bool linksBodies(const ForceDef& force);

/// Adds the loads of those bodies that act in the present sub-step, each with a length h of its own.
void addLoads(const ForceDef& force, const Bodies& bodies, ForceMoment now, std::span<Load> loads);

/// Adds the potential energy of the force (J), if it has any, to `potential` or `elastic`.
void addPotential(const ForceDef& force, const Bodies& bodies, Energy& energy);

}  // namespace engine
