#include "engine/wide/schedule.h"

#include <algorithm>

namespace engine {

void Schedule::begin(int bodies) {
    batches_.clear();
    used_.clear();
    open_.assign(1, 0);
    last_.assign(bodies, -1);
}

int Schedule::firstOpen(int batch) {
    while (open_[batch] != batch) batch = open_[batch] = open_[open_[batch]];
    return batch;
}

void Schedule::add(std::span<const BodyPair> pairs, std::span<const int> order) {
    const int first = static_cast<int>(batches_.size());
    // Batches that an earlier list left partly empty are not used.
    if (first > 0) open_[firstOpen(first - 1)] = first;
    for (const int contact : order) {
        const BodyPair& pair = pairs[contact];
        int after = first - 1;
        if (pair.a >= 0) after = std::max(after, last_[pair.a]);
        if (pair.b >= 0) after = std::max(after, last_[pair.b]);
        const int batch = firstOpen(after + 1);
        if (batch == static_cast<int>(batches_.size())) {
            batches_.emplace_back().fill(-1);
            used_.push_back(0);
            open_.push_back(batch + 1);
        }
        batches_[batch][used_[batch]++] = contact;
        if (used_[batch] == 8) open_[batch] = batch + 1;
        if (pair.a >= 0) last_[pair.a] = batch;
        if (pair.b >= 0) last_[pair.b] = batch;
    }
}

}  // namespace engine
