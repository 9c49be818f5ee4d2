/// Decides which contacts are solved side by side. A sweep has an order (from the top down); contacts that
/// share a movable body must keep it, all others may be reordered. So every contact goes into the first batch
/// of eight that is after the batches of its two bodies and has a free lane: the result is that of solving
/// them one by one in the given order, to the last bit.
#pragma once
#include <array>
#include <span>
#include <vector>

namespace engine {

/// Two bodies; -1 for an immovable one.
struct BodyPair {
    int a = -1, b = -1;
};

class Schedule {
public:
    /// Adds the contacts of one list in the order of `order`; every list begins a new batch.
    void begin(int bodies);
    void add(std::span<const BodyPair> pairs, std::span<const int> order);

    /// Indices in `pairs`; -1 in empty lanes.
    std::span<const std::array<int, 8>> batches() const { return batches_; }

private:
    int firstOpen(int batch);

    std::vector<std::array<int, 8>> batches_;
    std::vector<int> used_;   // lanes used, by batch
    std::vector<int> open_;   // the next batch that is not full: a union-find chain
    std::vector<int> last_;   // by body: its latest batch
};

}  // namespace engine
