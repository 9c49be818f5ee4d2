#include "engine/collision/jointed_pairs.h"

#include <algorithm>

#include "engine/base/disjoint_sets.h"

namespace engine {

void JointedPairs::list(std::span<const PairKey> joined, std::span<const PairKey> rigid, const Bodies& bodies) {
    joined_.assign(joined.begin(), joined.end());
    std::sort(joined_.begin(), joined_.end());
    pieces_.clear();
    if (rigid.empty()) return;
    const auto isFixed = [&](int body) { return bodies.defs[body].kind == BodyKind::fixed; };
    const auto number = [&](int body) { return isFixed(body) ? kWorld : body + 1; };
    DisjointSets sets;
    sets.reset(bodies.count() + 1);
    for (const PairKey& pair : rigid) sets.join(number(pair.a), number(pair.b));
    std::vector<int> sizes(bodies.count() + 1, 0);
    sizes[kWorld] = 1;
    for (int i = 0; i < bodies.count(); ++i) ++sizes[sets.leaderOf(i + 1)];
    for (int i = 0; i < bodies.count(); ++i) {
        const int leader = sets.leaderOf(i + 1);
        pieces_.push_back(sizes[leader] > 1 ? leader : kNone);
    }
}

int JointedPairs::pieceOf(int body, const Bodies& bodies) const {
    if (bodies.defs[body].kind == BodyKind::fixed) return kWorld;
    return std::size_t(body) < pieces_.size() ? pieces_[body] : kNone;
}

bool JointedPairs::contains(const PairKey& pair, const Bodies& bodies) const {
    if (std::binary_search(joined_.begin(), joined_.end(), pair)) return true;
    if (pieces_.empty()) return false;
    const int piece = pieceOf(pair.a, bodies);
    return piece != kNone && piece == pieceOf(pair.b, bodies);
}

}  // namespace engine
