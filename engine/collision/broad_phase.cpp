#include "engine/collision/broad_phase.h"

#include <algorithm>
#include <iterator>

#include "engine/collision/time_of_impact.h"

namespace engine {
namespace {

constexpr int kBodiesAThread = 128;  // at least
constexpr double kStepsAhead = 3.0;
constexpr std::size_t kMostPairs = 4'000'000;  // found in one step, some of them twice: 32 MB

bool isPlane(const Bodies& bodies, int i) {
    return bodies.defs[i].shape.type == ShapeType::plane;
}

/// True when neither ignores a group of the other.
bool heeds(const BodyDef& a, const BodyDef& b) {
    return (a.groups & b.ignores) == 0 && (b.groups & a.ignores) == 0;
}

bool mayMeet(const Bodies& bodies, int i, int j) {
    return (bodies.isDynamic(i) || bodies.isDynamic(j)) && heeds(bodies.defs[i], bodies.defs[j]);
}

/// Bounds of where the body may be during the next step. Rotation moves no point farther than the
/// sweep, nor out of the ball around the body.
Bounds reachOf(const Shape& shape, const Motion& motion, double margin, double dt) {
    const Bounds upright = boundsOf(shape, motion.start);
    const Vec3 way = dt * motion.velocity;
    const Vec3 half = 0.5 * (upright.high - upright.low);
    const bool isRound = shape.type == ShapeType::sphere || shape.type == ShapeType::capsule;
    const double round = isRound ? shape.radius : 0.0;
    const Vec3 ball = (motion.reach + round) * Vec3::Ones();
    const Vec3 turn = (dt * motion.sweep * Vec3::Ones()).cwiseMin(ball - half).cwiseMax(0.0);
    const Bounds now{upright.low - turn, upright.high + turn};
    const Bounds then{now.low + way, now.high + way};
    return now.with(then).grownBy(margin);
}

/// The bounds of a leaf: larger by a twentieth of its size on each side, so that a slow body stays in it for
/// many steps, and on by kStepsAhead times its way in a step (m), so that a fast one does for a few.
Bounds leafOf(const Bounds& tight, const Vec3& way) {
    const Bounds fat = tight.grownBy(0.05 * (tight.high - tight.low).maxCoeff());
    const Vec3 ahead = kStepsAhead * way;
    return {fat.low + ahead.cwiseMin(0.0), fat.high + ahead.cwiseMax(0.0)};
}

}  // namespace

void BroadPhase::update(const Bodies& bodies, double margin, double dt, Workers* workers) {
    proxies_.resize(bodies.count());
    for (const int i : moved_) proxies_[i].moved = false;
    moved_.clear();
    if (crowded_)
        for (int i = 0; i < bodies.count(); ++i) renew(bodies, i, margin, dt);
    else
        for (const int i : bodies.active)
            if (!bodies.isAsleep(i)) renew(bodies, i, margin, dt);
    found_.resize(workers ? workers->count() : 1);
    if (moved_.empty()) return;
    awakeStale_ = true;
    forgetPairsOfMoved();
    const std::size_t before = pairs_.size();
    const auto look = [&](int first, int end, int part) {
        for (int k = first; k < end && found_[part].pairs.size() <= kMostPairs; ++k)
            if (const int i = moved_[k]; proxies_[i].leaf >= 0)
                findPairsOf(bodies, i, tree_.bounds(proxies_[i].leaf), found_[part]);
    };
    const int count = static_cast<int>(moved_.size());
    workers ? workers->share(count, kBodiesAThread, look) : look(0, count, 0);
    for (const int plane : planes_)
        if (found_[0].pairs.size() <= kMostPairs) findPairsOfPlane(bodies, plane, found_[0]);
    takeFound();
    sortPairs(before);
}

void BroadPhase::renew(const Bodies& bodies, int i, double margin, double dt) {
    if (!bodies.present[i] || !bodies.defs[i].collide) return;
    Proxy& proxy = proxies_[i];
    if (isPlane(bodies, i)) {  // has no leaf: `moved` only when it is new
        if (proxy.leaf == kPlane && !crowded_) return;
        if (proxy.leaf == kNew) planes_.push_back(i);
        proxy.leaf = kPlane;
    } else {
        const Motion motion = motionOf(bodies, i, dt);
        proxy.tight = reachOf(bodies.defs[i].shape, motion, 0.5 * margin, dt);
        if (proxy.leaf >= 0 && !crowded_ && tree_.bounds(proxy.leaf).contains(proxy.tight)) return;
        if (proxy.leaf >= 0) tree_.remove(proxy.leaf);
        proxy.leaf = tree_.insert(leafOf(proxy.tight, dt * motion.velocity), i);
    }
    proxy.moved = true;
    moved_.push_back(i);
}

const std::vector<PairKey>& BroadPhase::awakePairs(const Bodies& bodies) {
    if (!awakeStale_ && listedAt_ == bodies.activeChanges) return awakePairs_;
    awakePairs_.clear();
    const auto rests = [&](int i) { return !bodies.isMoving(i) && !bodies.placed[i]; };
    for (const PairKey& pair : pairs_)
        if (!rests(pair.a) || !rests(pair.b)) awakePairs_.push_back(pair);
    awakeStale_ = false;
    listedAt_ = bodies.activeChanges;
    return awakePairs_;
}

void BroadPhase::takeFound() {
    std::size_t all = pairs_.size();
    for (const Found& found : found_) all += found.pairs.size();
    crowded_ = all > kMostPairs;
    for (Found& found : found_) {
        if (!crowded_) pairs_.insert(pairs_.end(), found.pairs.begin(), found.pairs.end());
        found.pairs.clear();
    }
}

void BroadPhase::sortPairs(std::size_t first) {
    const auto middle = pairs_.begin() + first;
    std::sort(middle, pairs_.end());
    merged_.clear();
    std::merge(pairs_.begin(), middle, middle, pairs_.end(), std::back_inserter(merged_));
    merged_.erase(std::unique(merged_.begin(), merged_.end()), merged_.end());
    pairs_.swap(merged_);
}

void BroadPhase::lookFarther(const Bodies& bodies, std::span<const int> which,
                             std::span<const double> more, double least) {
    const std::size_t before = pairs_.size();
    for (const int i : which) {
        if (more[i] <= least || proxies_[i].leaf < 0) continue;
        const Bounds farther = proxies_[i].tight.grownBy(more[i]);
        if (found_[0].pairs.size() <= kMostPairs &&
            !tree_.bounds(proxies_[i].leaf).contains(farther))
            findPairsOf(bodies, i, farther, found_[0]);
    }
    takeFound();
    if (pairs_.size() == before) return;
    sortPairs(before);
    awakeStale_ = true;
}

void BroadPhase::forgetPairsOfMoved() {
    std::erase_if(pairs_, [&](const PairKey& pair) {
        return proxies_[pair.a].moved || proxies_[pair.b].moved;
    });
}

void BroadPhase::findPairsOf(const Bodies& bodies, int i, const Bounds& within,
                             Found& found) const {
    tree_.query(within, found.open, [&](int j) {
        if (j != i && mayMeet(bodies, i, j))
            found.pairs.push_back({std::min(i, j), std::max(i, j)});
    });
}

void BroadPhase::findPairsOfPlane(const Bodies& bodies, int plane, Found& found) const {
    const auto look = [&](int j) {
        if (bodies.isDynamic(j) && bodies.defs[j].collide &&
            heeds(bodies.defs[plane], bodies.defs[j]))
            found.pairs.push_back({std::min(plane, j), std::max(plane, j)});
    };
    if (proxies_[plane].moved)
        for (int j = 0; j < bodies.count(); ++j) look(j);
    else
        std::ranges::for_each(moved_, look);
}

void BroadPhase::remove(int body) {
    if (body >= static_cast<int>(proxies_.size())) return;
    if (proxies_[body].leaf >= 0) tree_.remove(proxies_[body].leaf);
    proxies_[body] = {};
    awakeStale_ = true;
    std::erase(planes_, body);
    std::erase(moved_, body);
    std::erase_if(pairs_, [&](const PairKey& p) { return p.a == body || p.b == body; });
}

}  // namespace engine
