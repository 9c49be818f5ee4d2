/// Extreme worlds, by number: the same on every machine.
#pragma once
#include <cmath>
#include <string>

#include "tests/support/worlds.h"

namespace torture {

inline double logarithmic(support::Random& r, double low, double high) {
    return low * std::pow(high / low, r.number(0, 1));
}
inline bool chance(support::Random& r, double share) { return r.number(0, 1) < share; }

enum class Kind {
    rain,        // any shapes, aspect 1 to 100, 1 g to 1 t, thrown into a box
    shots,       // up to 300 m/s and 200 rad/s, from wall to wall
    terrain,     // onto a random height field
    triangles,   // onto a random mesh of slivers and needles
    limbs,       // trees of joints of every type, limits and motors, among loose bodies
    loops,       // rings of joints that do not quite fit, above a heap
    weights,     // heavy on light, 1 to a million
    overlaps,    // every body begins inside another
    torn,        // joints whose ends are apart at the start
    bounces,     // restitution 1, no friction, or a lot of both
    movers,      // kinematic paddles and pistons in a heap
    machines,    // cars, gears, beads on rails, bodies that look at or stay parallel to others
    count
};
constexpr int kKinds = static_cast<int>(Kind::count);
const char* nameOf(Kind kind);

/// A world, and the bounds it must keep.
struct Case {
    engine::World world;
    Kind kind = Kind::rain;
    std::string name;
    std::vector<engine::BodyId> bodies;  // dynamic
    double ceiling = 0.0;   // J: maximum energy at the start; 0: paddles may add any
    double power = 0.0;     // W: what all motors together can add
    double half = 0.0;      // m: the box, open above, is x, z in [-half, half], y > 0
    std::vector<double> heights;  // m, of its height field, row by row; empty: flat
    int columns = 0;
    double spacing = 0.0;   // m

    /// How far (m) the centre of a body is outside its enclosure; at most 0 while it is inside.
    double outside(engine::BodyId id) const;
};

/// World number `number` of a kind.
Case makeCase(Kind kind, int number, const engine::Settings& settings);

/// Adds a joint, and the power of its motors to that of the case.
void addJoint(Case& c, const engine::JointDef& def);
void addMachines(Case& c, support::Random& r);

}  // namespace torture
