/// The numbers 0, 1, ... sorted into groups, ascending in each (counting sort).
#pragma once
#include <span>
#include <vector>

namespace engine {

class ByGroup {
public:
    /// `groupOf(i)`: the group of a number, or -1 for none.
    template <class GroupOf>
    void sort(int count, int groups, const GroupOf& groupOf) {
        first_.assign(groups + 1, 0);
        group_.clear();
        for (int i = 0; i < count; ++i) {
            group_.push_back(groupOf(i));
            if (group_[i] >= 0) ++first_[group_[i] + 1];
        }
        for (int g = 0; g < groups; ++g) first_[g + 1] += first_[g];
        next_ = first_;
        sorted_.resize(first_[groups]);
        for (int i = 0; i < count; ++i)
            if (group_[i] >= 0) sorted_[next_[group_[i]]++] = i;
    }
    std::span<const int> of(int group) const {
        return std::span(sorted_).subspan(first_[group], first_[group + 1] - first_[group]);
    }

private:
    std::vector<int> first_, next_;  // by group; first_ has the end too
    std::vector<int> group_, sorted_;
};

}  // namespace engine
