/// Which contacts are solved side by side. A sweep has an order (from the top down); two contacts that
/// share a movable body must keep it, all others may change places. So every contact goes into the
/// first batch of eight that comes after the batches of its two bodies and has a lane left: the
/// result is that of solving one after the other in the given order, to the last bit.
#pragma once
#include <array>
#include <span>
#include <vector>

namespace engine {

/// Two bodies; -1 for one that no impulse moves.
struct BodyPair {
    int a = -1, b = -1;
};

class Schedule {
public:
    /// The contacts of one list after another, in the order of `order`; a list begins new batches.
    void begin(int bodies);
    void add(std::span<const BodyPair> pairs, std::span<const int> order);

    /// By place in `pairs`; -1 in lanes that are left empty.
    std::span<const std::array<int, 8>> batches() const { return batches_; }

private:
    int firstOpen(int batch);

    std::vector<std::array<int, 8>> batches_;
    std::vector<int> used_;   // lanes of every batch
    std::vector<int> open_;   // the next batch that is not full, a chain with shortened links
    std::vector<int> last_;   // of every body: its latest batch
};

}  // namespace engine
