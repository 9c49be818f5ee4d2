/// Which pairs of bodies are close enough to look at: a dynamic tree of fat bounds. Only a body that
/// has left its fat bounds is inserted again and asked for its neighbours; a resting heap costs a walk
/// over its bodies. Planes meet everything that moves.
#pragma once
#include <compare>
#include <vector>

#include "engine/base/workers.h"
#include "engine/collision/tree.h"
#include "engine/dynamics/bodies.h"

namespace engine {

/// The lower body number first: the order of everything that follows from pairs.
struct PairKey {
    int a = 0, b = 0;
    auto operator<=>(const PairKey&) const = default;
};

class BroadPhase {
public:
    /// Moves the bounds with the bodies; they reach `margin` (m) and one step of length dt (s) ahead.
    /// `workers` share the search for neighbours, if there are any.
    void update(const Bodies& bodies, double margin, double dt, Workers* workers = nullptr);
    void remove(int body);
    /// Adds the pairs of bodies that may come farther than their bounds say: `more` (m), by body,
    /// where it is above `least`.
    void lookFarther(const Bodies& bodies, const std::vector<double>& more, double least);

    /// Sorted, each pair once. Of two bodies at least one is dynamic.
    const std::vector<PairKey>& pairs() const { return pairs_; }
    /// Today's bounds, margin and motion included.
    const Bounds& bounds(int body) const { return proxies_[body].tight; }
    /// Of a pair; `more` (m) than the margin apart counts as well.
    bool boundsMeet(const PairKey& pair, double more = 0.0) const {
        const Proxy &a = proxies_[pair.a], &b = proxies_[pair.b];
        return a.leaf < 0 || b.leaf < 0 || a.tight.grownBy(more).overlaps(b.tight);
    }
    const BoundsTree& tree() const { return tree_; }

private:
    struct Proxy {
        Bounds tight;
        int leaf = -1;
        bool moved = false;
    };

    /// Those from `first` on are new; the others are sorted.
    void sortPairs(std::size_t first);
    void forgetPairsOfMoved();
    /// What one thread finds.
    struct Found {
        std::vector<PairKey> pairs;
        std::vector<int> open;  // for tree_.query
    };

    void findPairsOf(const Bodies& bodies, int body, const Bounds& within, Found& found) const;
    void findPairsOfPlane(const Bodies& bodies, int plane, Found& found) const;
    void takeFound();

    BoundsTree tree_;
    std::vector<Proxy> proxies_;
    std::vector<PairKey> pairs_, merged_;
    std::vector<Found> found_;
};

}  // namespace engine
