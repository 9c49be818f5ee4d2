/// Bounces, before the sweeps: Newton's law of restitution, one manifold after the other, until none
/// approaches faster than the bounce speed.
///   J v2 = -e J v1  where  J v1 < -bounceSpeed  and the gap closes within this sub-step
/// Solved together with everything else, a blow on a row of touching balls sets all of them in motion;
/// one pair at a time it travels through to the last, as it does in Newton's cradle. The impulses are
/// kept apart from the accumulated ones, or the sweeps would take the rebound back as too much of a
/// push. (Guendelman, Bridson and Fedkiw 2003: collisions first, then contacts without restitution.)
#pragma once
#include "engine/solver/constraints.h"

namespace engine {

void solveImpacts(Constraints& c, std::span<Velocity> v, const Settings& settings, double h);

}  // namespace engine
