/// Union-find over n elements (Tarjan 1975). The leader of a set is its smallest member, so the result does
/// not depend on the order of joining.
#pragma once
#include <numeric>
#include <span>
#include <vector>

namespace engine {

class DisjointSets {
public:
    /// Makes sets of one of all elements.
    void reset(int count) {
        leader_.resize(count);
        std::iota(leader_.begin(), leader_.end(), 0);
    }
    /// Makes sets of one of the elements `which`, and of those from the last count on.
    void reset(int count, std::span<const int> which) {
        for (int i = static_cast<int>(leader_.size()); i < count; ++i) leader_.push_back(i);
        for (const int i : which) leader_[i] = i;
    }
    int leaderOf(int i) {
        while (leader_[i] != i) i = leader_[i] = leader_[leader_[i]];
        return i;
    }
    void join(int i, int j) {
        const int a = leaderOf(i), b = leaderOf(j);
        leader_[a > b ? a : b] = a < b ? a : b;
    }

    /// What is kept of it in a state (state_bytes.h).
    template <class Bytes>
    void keep(Bytes& bytes) {
        bytes(leader_);
        if constexpr (Bytes::kReads)
            for (int i = 0; i < static_cast<int>(leader_.size()); ++i)
                bytes.require(leader_[i] >= 0 && leader_[i] <= i);
    }

private:
    std::vector<int> leader_;
};

}  // namespace engine
