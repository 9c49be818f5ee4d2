#include "engine/solver/islands.h"

#include "engine/base/disjoint_sets.h"

namespace engine {
namespace {

/// A movable body of the row; -1 if there is none.
int bodyOf(const GlobalRow& row) {
    return row.row.massB > 0.0 ? row.b : row.row.massA > 0.0 ? row.a : -1;
}

}  // namespace

std::vector<Island> islandsOf(const GlobalRows& g, int bodies) {
    DisjointSets sets;
    sets.reset(bodies);
    for (const GlobalRow& row : g.rows) {
        if (row.row.massA <= 0.0 || row.row.massB <= 0.0) continue;
        sets.join(row.a, row.b);
    }
    std::vector<Island> islands;
    std::vector<int> islandOf(bodies, -1), newPlace(g.count(), -1);
    for (int i = 0; i < g.count(); ++i) {
        const int body = bodyOf(g.rows[i]);
        if (body < 0) continue;
        int& number = islandOf[sets.leaderOf(body)];
        if (number < 0) {
            number = static_cast<int>(islands.size());
            islands.emplace_back().rows.h = g.h;
        }
        Island& island = islands[number];
        newPlace[i] = island.rows.count();
        GlobalRow row = g.rows[i];
        if (row.normal >= 0) row.normal = newPlace[row.normal];
        island.rows.rows.push_back(row);
        island.rows.wanted.push_back(g.wanted[i]);
        island.rows.force.push_back(g.force[i]);
        island.places.push_back(i);
    }
    return islands;
}

}  // namespace engine
