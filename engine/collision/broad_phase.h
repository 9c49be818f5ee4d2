/// Finds the pairs of bodies that may touch, with a dynamic tree of enlarged (fat) bounds. Only a body that
/// has left its fat bounds is reinserted and searches for its neighbours; a resting heap costs one loop over
/// its active bodies. Planes are paired with every dynamic body.
#pragma once
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/workers.h"
#include "engine/collision/tree.h"
#include "engine/dynamics/bodies.h"

namespace engine {

/// The lower body number comes first. Everything derived from pairs follows their order.
struct PairKey {
    int a = 0, b = 0;
    auto operator<=>(const PairKey&) const = default;
};

class BroadPhase {
public:
    /// Updates the bounds, which include the margin (m) and the motion of one step of length dt (s).
    /// `workers`, if given, share the search for neighbours.
    void update(const Bodies& bodies, double margin, double dt, Workers* workers = nullptr);
    void remove(int body);
    /// Adds the pairs of those bodies in `which` that may move farther than their bounds allow: by `more`
    /// (m, indexed by body), where that exceeds `least`.
    void lookFarther(const Bodies& bodies, std::span<const int> which, std::span<const double> more,
                     double least);

    /// More pairs than can be handled, whatever the number of threads: they are incomplete, and all are
    /// searched again in the next update.
    bool isCrowded() const { return crowded_; }
    /// Sorted and unique. At least one body of each pair is dynamic.
    const std::vector<PairKey>& pairs() const { return pairs_; }
    /// Those with a body that is active; perhaps a few more.
    const std::vector<PairKey>& awakePairs(const Bodies& bodies);
    /// The current bounds, with margin and motion.
    const Bounds& bounds(int body) const { return proxies_[body].tight; }
    /// Whether the bounds of a pair overlap; those up to `more` (m) farther apart count as well.
    bool boundsMeet(const PairKey& pair, double more = 0.0) const {
        const Proxy &a = proxies_[pair.a], &b = proxies_[pair.b];
        return a.leaf < 0 || b.leaf < 0 || a.tight.grownBy(more).overlaps(b.tight);
    }
    int bodyCount() const { return static_cast<int>(proxies_.size()); }
    const BoundsTree& tree() const { return tree_; }

    /// What is kept of it in a state (base/state_bytes.h). The tree is built again from its leaves: its shape
    /// decides nothing but the time that a search takes.
    template <class Bytes>
    void keep(Bytes& bytes);

private:
    static constexpr int kNew = -1, kPlane = -2;  // in place of a leaf
    struct Proxy {
        Bounds tight;
        int leaf = kNew;
        bool moved = false;
    };

    /// Puts a body that has left its leaf, or has none, into a new one; all of them if crowded.
    void renew(const Bodies& bodies, int body, double margin, double dt);
    /// Merges the new pairs, from `first` on, into the sorted ones before them.
    void sortPairs(std::size_t first);
    void forgetPairsOfMoved();
    /// The results of one thread.
    struct Found {
        std::vector<PairKey> pairs;
        std::vector<int> open;  // for tree_.query
    };

    void findPairsOf(const Bodies& bodies, int body, const Bounds& within, Found& found) const;
    void findPairsOfPlane(const Bodies& bodies, int plane, Found& found) const;
    void takeFound();

    BoundsTree tree_;
    std::vector<Proxy> proxies_;
    std::vector<int> moved_;   // bodies whose leaf is new
    std::vector<int> planes_;
    std::vector<PairKey> pairs_, merged_, awakePairs_;
    bool awakeStale_ = true;
    long long listedAt_ = -1;  // Bodies::activeChanges
    std::vector<Found> found_;
    bool crowded_ = false;
};

template <class Bytes>
void BroadPhase::keep(Bytes& bytes) {
    if constexpr (Bytes::kReads) *this = {};
    auto count = static_cast<std::uint64_t>(proxies_.size());
    bytes(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        Bounds fat;
        if constexpr (Bytes::kReads) {
            if (!bytes.isGood()) return;
            proxies_.emplace_back();
        } else if (proxies_[i].leaf >= 0) {
            fat = tree_.bounds(proxies_[i].leaf);
        }
        Proxy& proxy = proxies_[i];
        const auto body = static_cast<int>(i);
        int place = smaller(proxy.leaf, 0);
        bytes.within(place, kPlane, 0);
        bytes(proxy.tight.low, proxy.tight.high, fat.low, fat.high);
        if constexpr (!Bytes::kReads) continue;
        proxy.leaf = place == 0 ? tree_.insert(fat, body) : place;
        if (place == kPlane) planes_.push_back(body);
    }
    bytes(pairs_, crowded_);
}

}  // namespace engine
