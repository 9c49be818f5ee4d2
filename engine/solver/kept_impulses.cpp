#include "engine/solver/kept_impulses.h"

#include <algorithm>

#include "engine/dynamics/energy.h"

namespace engine {
namespace {

constexpr double kMostBrought = 0.25;  // of the kinetic energy

/// Calls what(joint, i) for every row of the joints outside the trees.
template <class What>
void eachRow(Constraints& c, int group, What what) {
    for (const int k : c.jointsOutside.of(group))
        for (int i = 0; i < c.joints[k].count; ++i) what(c.joints[k], i);
}

void applyShare(Constraints& c, int group, double share, std::span<Velocity> v) {
    eachRow(c, group, [&](JointConstraint& joint, int i) {
        push(joint, i, share * joint.lambda[i], v[joint.a], v[joint.b]);
    });
}

/// lambda . J v
double rateAlong(Constraints& c, int group, std::span<const Velocity> v) {
    double sum = 0.0;
    eachRow(c, group, [&](const JointConstraint& joint, int i) {
        sum += joint.lambda[i] * velocityAlong(joint.rows[i].j, v[joint.a], v[joint.b]);
    });
    return sum;
}

bool anyTurns(const Constraints& c, int group) {
    return std::ranges::any_of(c.jointsOutside.of(group),
                               [&](int k) { return c.joints[k].kept < 1.0; });
}

/// Of a guess that was applied: the share to keep. Takes it away.
double shareToKeep(Constraints& c, JointTrees& trees, int group, double energy,
                   std::span<Velocity> v) {
    Correction unused;
    trees.solveVelocities(group, v, unused);
    const double with = rateAlong(c, group, v);
    applyShare(c, group, -1.0, v);
    trees.solveVelocities(group, v, unused);
    const double without = rateAlong(c, group, v);
    double slope = without, curvature = with - without;
    eachRow(c, group, [&](const JointConstraint& joint, int i) {
        slope += joint.lambda[i] * joint.bias[i];
        curvature += joint.softness[i] * joint.lambda[i] * joint.lambda[i];
    });
    if (slope + 0.5 * curvature <= kMostBrought * energy) return 1.0;
    return slope < 0.0 && curvature > 0.0 ? smaller(-slope / curvature, 1.0) : 0.0;
}

}  // namespace

void KeptImpulses::measure(const Bodies& bodies, int groups, const Constraints& c) {
    energies_.assign(groups, 0.0);
    for (int group = 0; group < groups; ++group) {
        if (c.jointsOutside.of(group).empty()) continue;
        for (const int k : c.jointsByGroup.of(group))
            for (const int body : {c.joints[k].a, c.joints[k].b})
                if (bodies.isDynamic(body)) energies_[group] += kineticEnergyOf(bodies, body);
    }
}

void KeptImpulses::check(Constraints& c, JointTrees& trees, std::span<Velocity> v) const {
    for (int group = 0; group < static_cast<int>(energies_.size()); ++group) {
        if (!anyTurns(c, group)) continue;
        const double share = shareToKeep(c, trees, group, energies_[group], v);
        applyShare(c, group, share, v);
        eachRow(c, group, [&](JointConstraint& joint, int i) { joint.lambda[i] *= share; });
    }
}

}  // namespace engine
