#include "engine/solver/columns.h"

namespace engine {
namespace {

constexpr int kMostOfALevel = 4;
constexpr int kMostLevels = 100;
constexpr int kAboveAll = 1 << 20;

}  // namespace

void Columns::measure(std::span<const Contact> contacts, const Bodies& bodies,
                      DisjointSets& islands) {
    levels_.assign(bodies.count(), kAboveAll);
    tallest_.assign(bodies.count(), 0);
    sizes_.assign(bodies.count(), 0);
    for (const Contact& c : contacts) {
        const bool a = bodies.isDynamic(c.a), b = bodies.isDynamic(c.b);
        if (!a || !b) levels_[a ? c.a : c.b] = 1;
    }
    for (int i = 0; i < bodies.count(); ++i) ++sizes_[islands.leaderOf(i)];
    narrow_.clear();
    for (int k = 0; k < static_cast<int>(contacts.size()); ++k) {
        const Contact& c = contacts[k];
        if (!bodies.isDynamic(c.a) || !bodies.isDynamic(c.b)) continue;
        if (sizes_[islands.leaderOf(c.a)] < kMostOfALevel * kMostLevels) narrow_.push_back(k);
    }
    bool changed = !narrow_.empty();
    for (int pass = 0; pass < kMostLevels && changed; ++pass) {  // most are numbered from the floor up
        changed = false;
        for (const int k : narrow_) {
            int &a = levels_[contacts[k].a], &b = levels_[contacts[k].b];
            if (a > b + 1) a = b + 1, changed = true;
            if (b > a + 1) b = a + 1, changed = true;
        }
    }
    for (const int k : narrow_)
        for (const int i : {contacts[k].a, contacts[k].b}) {
            const int leader = islands.leaderOf(i);
            if (levels_[i] < kAboveAll && sizes_[leader] < kMostOfALevel * levels_[i])
                tallest_[leader] = larger(tallest_[leader], levels_[i]);
        }
}

}  // namespace engine
