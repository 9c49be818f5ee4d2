/// Reusable numbers of objects: a number and its generation identify one object. A removed object
/// keeps its number through the next step, which still has to report it.
#pragma once
#include <vector>

namespace engine {

class Slots {
public:
    /// A number for a new object: a free one, else the next.
    int take() {
        if (free_.empty()) {
            generations_.push_back(0);
            return static_cast<int>(generations_.size()) - 1;
        }
        const int i = free_.back();
        free_.pop_back();
        ++generations_[i];
        return i;
    }
    void remove(int i) { removed_.push_back(i); }
    /// Whether this generation is the current, or the last, one of its slot.
    bool knows(int i, unsigned generation) const {
        return i >= 0 && i < static_cast<int>(generations_.size()) &&
               generations_[i] == generation;
    }
    unsigned generation(int i) const { return generations_[i]; }

    void beginStep() { leaving_.swap(removed_); }
    void endStep() {
        free_.insert(free_.end(), leaving_.begin(), leaving_.end());
        leaving_.clear();
    }

    /// What is kept of it in a state (state_bytes.h); `count`: of the objects.
    template <class Bytes>
    void keep(Bytes& bytes, int count) {
        bytes.sized(count, generations_);
        for (std::vector<int>* list : {&removed_, &leaving_, &free_}) {
            bytes.upTo(count, *list);
            if constexpr (Bytes::kReads)
                for (const int i : *list) bytes.require(i >= 0 && i < count);
        }
    }

private:
    std::vector<unsigned> generations_;
    std::vector<int> removed_, leaving_, free_;
};

}  // namespace engine
