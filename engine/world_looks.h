/// Contact detection within a step: a look. A fast body that hits something may fly anywhere in the rest of the
/// step, and a body that turns about its contact may come down elsewhere (collision/moving_contacts.h).
///
/// Only islands look that such a body may reach, in the ball around it that its speed allows; and from their bodies
/// on those that a hit passed on may bring them to. All others keep their contacts with the rows that these have, and
/// their sub-steps (solver/paces.h).
#pragma once
#include "engine/world_state.h"

namespace engine {

/// Before a step of dt (s), after its islands were found: how many looks it needs, the first of which is before
/// it. Sets WorldState::looks.
int chooseLooks(WorldState& s, double dt);

/// Whether any island looks before this sub-step of the world, of h (s).
bool looksAgain(WorldState& s, int substep, double h);
void findContactsWithin(WorldState& s, int substep, double h);

}  // namespace engine
