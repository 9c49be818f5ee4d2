#include "engine/collision/sensors.h"

#include "engine/collision/collide.h"
#include "engine/collision/piece_pairs.h"

namespace engine {
namespace {

/// Collects the points where pieces overlap, and the first normal.
class Overlap {
public:
    void add(const Manifold& m) {
        for (int i = 0; i < m.count; ++i) {
            if (m.separation(i) > 0.0) continue;
            if (count_ == 0) normal_ = m.normal;
            sum_ += 0.5 * (m.points[i].onA + m.points[i].onB);
            ++count_;
        }
    }
    int count() const { return count_; }
    Vec3 middle() const { return sum_ / count_; }
    const Vec3& normal() const { return normal_; }

private:
    Vec3 sum_ = Vec3::Zero(), normal_ = Vec3::UnitY();
    int count_ = 0;
};

/// Adds the number of pairs of pieces to `looked`.
Overlap overlapOf(const Bodies& bodies, const PairKey& pair, const BroadPhase& broadPhase, long& looked) {
    const Shape &a = bodies.defs[pair.a].shape, &b = bodies.defs[pair.b].shape;
    const Pose &poseA = bodies.poses[pair.a], &poseB = bodies.poses[pair.b];
    const bool plane = a.type == ShapeType::plane || b.type == ShapeType::plane;
    const Bounds everywhere{Vec3::Constant(-1e9), Vec3::Constant(1e9)};
    Overlap overlap;
    forPieces(a, poseA, plane ? everywhere : broadPhase.bounds(pair.b), [&](const Piece& ofA) {
        forPieces(b, poseB, plane ? everywhere : boundsOf(ofA, poseA), [&](const Piece& ofB) {
            if ((looked += costOf(ofA, ofB)) <= kMostPiecePairs) overlap.add(collide(ofA, poseA, ofB, poseB, 0.0));
        });
    });
    return overlap;
}

}  // namespace

bool findSensed(const Bodies& bodies, const BroadPhase& broadPhase, std::vector<Sensed>& sensed) {
    sensed.clear();
    long looked = 0;
    for (const PairKey& pair : broadPhase.pairs()) {
        if (!isSensed(bodies, pair) || !broadPhase.boundsMeet(pair)) continue;
        const Overlap overlap = overlapOf(bodies, pair, broadPhase, looked);
        if (overlap.count() > 0) sensed.push_back({pair, overlap.middle(), overlap.normal()});
    }
    return looked <= kMostPiecePairs;
}

}  // namespace engine
