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

/// World number k is of kind k % kKinds.
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
    double ceiling = 0.0;   // J: maximum energy; 0: motors and paddles may add some
    double half = 0.0;      // m: the box, open above, is x, z in [-half, half], y > 0
    std::vector<double> heights;  // m, of its height field, row by row; empty: flat
    int columns = 0;
    double spacing = 0.0;   // m

    /// How far (m) the centre of a body is outside its enclosure; at most 0 while it is inside.
    double outside(engine::BodyId id) const;
};

Case makeCase(int number, const engine::Settings& settings);

}  // namespace torture
