/// Pairs of bodies that joints keep from colliding: two that a joint joins, and all that rigid joints make one
/// piece. Parts of a piece may overlap, and no impulse of a contact could ever separate them.
#pragma once
#include <span>
#include <vector>

#include "engine/collision/broad_phase.h"

namespace engine {

class JointedPairs {
public:
    /// All pairs that joints join, and those of them whose joint leaves no freedom.
    void list(std::span<const PairKey> joined, std::span<const PairKey> rigid, const Bodies& bodies);
    bool contains(const PairKey& pair, const Bodies& bodies) const;

    /// What is kept of it in a state (base/state_bytes.h).
    template <class Bytes>
    void keep(Bytes& bytes) {
        bytes(joined_, pieces_);
    }

private:
    static constexpr int kNone = -1, kWorld = 0;  // pieces_: of no other body; of the fixed bodies

    /// Which piece a body belongs to.
    int pieceOf(int body, const Bodies& bodies) const;

    std::vector<PairKey> joined_;  // sorted
    std::vector<int> pieces_;      // by body; newer bodies may be missing
};

}  // namespace engine
