#include "engine/solver/columns.h"

#include <cmath>

#include "engine/shape.h"

namespace engine {
namespace {

constexpr int kMostOfALevel = 4;
constexpr int kMostPasses = 4;
constexpr int kAboveAll = 1 << 20;
constexpr double kReachOfACube = 0.866;  // times its side
constexpr double kSlow = 0.5;            // m: larger bodies sway slower, but are given as many sub-steps
constexpr double kThick = 0.05;  // m: its contacts, made 2 cm ahead, are with what it touches

bool bears(const Contact& c, const Bodies& bodies) {
    const double thickness = smaller(bodies.thicknesses[c.a], bodies.thicknesses[c.b]);
    if (thickness >= kThick) return true;
    const Pose &a = bodies.poses[c.a], &b = bodies.poses[c.b];
    for (int i = 0; i < c.count; ++i) {
        const ContactPoint& p = c.points[i];
        if (c.normal.dot(b.toWorld(p.anchorB) - a.toWorld(p.anchorA)) < 0.5 * thickness) return true;
    }
    return false;
}

}  // namespace

void Columns::findBearing(std::span<const Contact> contacts, std::span<const int> order,
                          const Bodies& bodies) {
    bearing_.clear();
    for (const int k : order)
        if (bears(contacts[k], bodies)) bearing_.push_back({contacts[k].a, contacts[k].b});
}

void Columns::number(const Bodies& bodies) {
    levels_.resize(bodies.count());
    for (const int i : bodies.active) levels_[i] = kAboveAll;
    for (const BodyPair& c : bearing_) {
        const bool a = bodies.isDynamic(c.a), b = bodies.isDynamic(c.b);
        if (!a || !b) levels_[a ? c.a : c.b] = 1;
    }
    bool changed = true;
    for (int pass = 0; pass < kMostPasses && changed; ++pass) {  // one is nearly enough, from the floor up
        changed = false;
        for (std::size_t k = bearing_.size(); k-- > 0;) {
            const BodyPair& c = bearing_[k];
            if (!bodies.isDynamic(c.a) || !bodies.isDynamic(c.b)) continue;
            int &a = levels_[c.a], &b = levels_[c.b];
            if (a > b + 1) a = b + 1, changed = true;
            if (b > a + 1) b = a + 1, changed = true;
        }
    }
}

void Columns::measure(std::span<const Contact> contacts, std::span<const int> order,
                      const Bodies& bodies, DisjointSets& islands) {
    findBearing(contacts, order, bodies);
    number(bodies);
    islands_.resize(bodies.count());
    for (const int i : bodies.active) islands_[i] = {};
    for (const int i : bodies.active) {
        if (levels_[i] >= kAboveAll) continue;
        Island& island = islands_[islands.leaderOf(i)];
        ++island.bodies, island.reach += reachOf(bodies.defs[i].shape);
        if (levels_[i] == 1) ++island.onTheFloor;
        island.levels = larger(island.levels, levels_[i]);
    }
    for (const int i : bodies.active) islands_[i].substeps = substepsOf(islands_[i]);
}

int Columns::levels(int leader) const { return levelsOf(islands_[leader]); }

int Columns::levelsOf(const Island& island) {
    return island.bodies < kMostOfALevel * island.levels ? island.levels : 0;
}

double Columns::substepsOf(const Island& island) {
    if (island.levels == 0) return 0.0;
    const double levels = island.levels;
    const double side = island.reach / (kReachOfACube * island.bodies);
    const double sway = larger(1.0, std::sqrt(kSlow / side));
    if (levelsOf(island) > 0) return sway * (0.4 * levels - 1.3) - 0.7;
    const double carried = smaller(1.0 * island.bodies / island.onTheFloor, levels);
    return sway * 0.2 * carried * carried / levels;
}

}  // namespace engine
