/// The impulses that contacts keep from the last sub-step are a guess. After a blow it is a bad one: what
/// stopped a ton on a gram throws the gram away in the next sub-step, and a few sweeps do not take all of
/// that back. The impulses lambda of an island have brought the energy
///   f = lambda . (J v0 + b) + lambda . J dv / 2,   dv = M^-1 J^T lambda
/// where v0 are the velocities before. From lambda = 0 each sweep over the normals reduces f, and friction
/// takes energy too. So f > 0 comes from what was kept, and the island would be better off without: it takes
/// its impulses back, and is swept again from 0. A moving surface may give energy to bodies; that does not
/// count, because J v is what the two do relative to each other.
///
/// f is measured only where the last sweep still changed a velocity by more than 0.5 m/s: what rests keeps
/// its impulses, and a blow that the sweeps carry to the end costs nothing. A contact cannot be measured
/// alone: each contact of a stack seems to bring the energy that the next one takes. To allow a share of the
/// kinetic energy keeps a few more bits, but a ton that lies on grams then throws them away. Islands with
/// joints: joined_start.h.
///
/// This is for rows in double precision; in lanes it is WideContacts::takeBack.
#pragma once
#include "engine/solver/constraints.h"
#include "engine/wide/groups.h"

namespace engine {

/// f of one contact; a, b: the velocities of its bodies midway, v0 + dv / 2.
double broughtBy(const ContactConstraint& c, const Velocity& a, const Velocity& b);
/// Takes back its impulses.
void takeBack(ContactConstraint& c, std::span<Velocity> v);

class FreshStart {
public:
    /// Takes back the impulses of the islands of these contacts that have brought energy; returns whether
    /// there was one. No other impulses act on the bodies of the islands.
    bool takeBack(Constraints& c, std::span<const int> contacts, const ContactGroups& groups,
                  std::span<Velocity> v);

private:
    void measure(const Constraints& c, std::span<const int> contacts, const ContactGroups& groups,
                 std::span<const Velocity> v);
    std::vector<double> brought_;    // f in J, by island
    std::vector<Velocity> changes_;  // dv, by body
};

}  // namespace engine
