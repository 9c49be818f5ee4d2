/// Union-find over n elements (Tarjan 1975). The leader of a set is its smallest member, so the result does
/// not depend on the order of joining.
#pragma once
#include <numeric>
#include <vector>

namespace engine {

class DisjointSets {
public:
    void reset(int count) {
        leader_.resize(count);
        std::iota(leader_.begin(), leader_.end(), 0);
    }
    int leaderOf(int i) {
        while (leader_[i] != i) i = leader_[i] = leader_[leader_[i]];
        return i;
    }
    void join(int i, int j) {
        const int a = leaderOf(i), b = leaderOf(j);
        leader_[a > b ? a : b] = a < b ? a : b;
    }

private:
    std::vector<int> leader_;
};

}  // namespace engine
