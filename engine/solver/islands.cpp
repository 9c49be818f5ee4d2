#include "engine/solver/islands.h"

#include <algorithm>

namespace engine {
namespace {

int find(std::vector<int>& leader, int i) {
    while (leader[i] != i) i = leader[i] = leader[leader[i]];
    return i;
}

/// A movable body of the row; -1 where it moves none.
int bodyOf(const GlobalRow<double>& row) {
    return row.row.massB > 0.0 ? row.b : row.row.massA > 0.0 ? row.a : -1;
}

}  // namespace

std::vector<Island> islandsOf(const GlobalRows<double>& g, int bodies) {
    std::vector<int> leader(bodies);
    for (int i = 0; i < bodies; ++i) leader[i] = i;
    for (const GlobalRow<double>& row : g.rows) {
        if (row.row.massA <= 0.0 || row.row.massB <= 0.0) continue;
        const int a = find(leader, row.a), b = find(leader, row.b);
        leader[std::max(a, b)] = std::min(a, b);
    }
    std::vector<Island> islands;
    std::vector<int> islandOf(bodies, -1), newPlace(g.count(), -1);
    for (int i = 0; i < g.count(); ++i) {
        const int body = bodyOf(g.rows[i]);
        if (body < 0) continue;
        int& number = islandOf[find(leader, body)];
        if (number < 0) {
            number = static_cast<int>(islands.size());
            islands.emplace_back().rows.h = g.h;
        }
        Island& island = islands[number];
        newPlace[i] = island.rows.count();
        GlobalRow<double> row = g.rows[i];
        if (row.normal >= 0) row.normal = newPlace[row.normal];
        island.rows.rows.push_back(row);
        island.rows.wanted.push_back(g.wanted[i]);
        island.rows.force.push_back(g.force[i]);
        island.places.push_back(i);
    }
    return islands;
}

}  // namespace engine
