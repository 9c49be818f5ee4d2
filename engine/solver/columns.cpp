#include "engine/solver/columns.h"

namespace engine {
namespace {

constexpr int kMostOfALevel = 4;
constexpr int kMostLevels = 100;
constexpr int kAboveAll = 1 << 20;

}  // namespace

int Columns::tallest(std::span<const Contact> contacts, const Bodies& bodies) {
    islands_.reset(bodies.count());
    levels_.assign(bodies.count(), kAboveAll);
    for (const Contact& c : contacts) {
        const bool a = bodies.isDynamic(c.a), b = bodies.isDynamic(c.b);
        if (a && b) islands_.join(c.a, c.b);
        else levels_[a ? c.a : c.b] = 1;
    }
    sizes_.assign(bodies.count(), 0);
    for (int i = 0; i < bodies.count(); ++i) ++sizes_[islands_.leaderOf(i)];
    narrow_.clear();
    for (int k = 0; k < static_cast<int>(contacts.size()); ++k) {
        const Contact& c = contacts[k];
        if (!bodies.isDynamic(c.a) || !bodies.isDynamic(c.b)) continue;
        if (sizes_[islands_.leaderOf(c.a)] < kMostOfALevel * kMostLevels) narrow_.push_back(k);
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
    int tallest = 0;
    for (const int k : narrow_)
        for (const int i : {contacts[k].a, contacts[k].b}) {
            const int size = sizes_[islands_.leaderOf(i)];
            if (levels_[i] < kAboveAll && size < kMostOfALevel * levels_[i])
                tallest = larger(tallest, levels_[i]);
        }
    return tallest;
}

}  // namespace engine
