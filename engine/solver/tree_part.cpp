#include "engine/solver/tree_part.h"

#include <algorithm>

#include "engine/dynamics/integration.h"
#include "engine/dynamics/rotation.h"
#include "engine/solver/chords.h"
#include "engine/solver/tree_implicit.h"

namespace engine {
namespace {

constexpr double kGain = 0.5;    // Newton continues while a step leaves at most this share of the errors
constexpr int kMostNudges = 8;   // Newton steps of a tree that moves again; two or three are enough
constexpr double kSmall = 1e-3;  // of the lever arms: an error allowed in a loop that does not fit
constexpr double kMet = 1e-8;    // of the lever arms; at 1e-6 a four-bar gains 2 % in ten minutes
/// Hinges between two held ends constrain the perpendicular directions twice, except for a play so small that
/// dividing by it gives huge impulses: the last hinge yields by this share of its K.
constexpr double kPlay = 1e-2;
/// Of K, added to all rows of a closed tree whose joints are torn, or that is part of a net: they cannot all be
/// closed, or not without the others, and what is nearly dependent gets small impulses instead of huge ones.
constexpr double kDamping = 1e-3;
/// Of K: gamma of the rows of a net. With 1e-7, a net of 20 by 20 balls still asks for 25 sub-steps, instead of 6;
/// with 1e-5, joints of a welded plate open by 3 mm in preset fast.
constexpr double kSoftness = 3e-6;

/// The share of a tree's nudge that becomes velocity: all while the errors are small compared with the arms,
/// none where linearization fails.
double feedbackShare(double ratio) { return clamped((0.04 - ratio) / 0.02, 0.0, 1.0); }

template <int N>
TreeJoint<N> treeJoint(const ForestPlan::Place& place, const JointConstraint& constraint,
                       const Joint& joint) {
    TreeJoint<N> t;
    t.a = constraint.a, t.b = constraint.b;
    t.joint = constraint.joint, t.constraint = place.joint;
    t.type = joint.def.type;
    t.closes = place.closes;
    t.anchorA = joint.def.anchorA, t.anchorB = joint.def.anchorB;
    t.reach = larger(larger(t.anchorA.norm(), t.anchorB.norm()), larger(joint.def.length, 1e-3));
    t.isGear = t.type == JointType::gear;
    t.pointRows = pointRowsOf(joint.def);
    t.hasOwnRows = t.type != JointType::slider && t.type != JointType::sixDof && !t.isGear;
    if (t.isGear) t.reach = larger(std::abs(joint.def.ratio), 1.0);  // rad
    if constexpr (N > 3) {
        for (Vec3& across : t.across) across.setZero();
        if (t.type == JointType::hinge || t.type == JointType::slider)
            tangents(joint.axisA, t.across[0], t.across[1]);
    }
    if (t.hasOwnRows)
        for (int i = 0; i < constraint.count; ++i) t.lambda[i] = constraint.lambda[i];
    return t;
}

/// Only a gear may join two bodies that another joint of the tree joins.
template <int N>
bool sharesTwo(const TreeJoint<N>& i, const TreeJoint<N>& k) {
    const bool same = (i.a == k.a && i.b == k.b) || (i.a == k.b && i.b == k.a);
    return same && (i.isGear || k.isGear);
}

/// Adds play to K of a closing hinge or weld.
template <int N>
void addPlay(const TreeJoint<N>& joint, TreeBlock<N>& k) {
    if constexpr (N > 3) {
        const double across = kPlay / 3.0 * k.template topLeftCorner<3, 3>().trace();
        if (joint.type == JointType::hinge)
            k.template topLeftCorner<3, 3>() +=
                across * joint.now.along * joint.now.along.transpose();
        for (int i = 3; i < N; ++i) k(i, i) += kPlay * k(i, i);
    }
}

}  // namespace

template <int N>
int TreePart<N>::own(int body, std::vector<int>& places) {
    if (places[body] < 0) {
        places[body] = static_cast<int>(members_.size());
        members_.push_back({body});
    }
    return places[body];
}

template <int N>
void TreePart<N>::build(const ForestPlan& plan, int fewest, std::span<const JointConstraint> list,
                        std::span<const Joint> joints) {
    std::vector<int> placeHere(plan.places.size(), -1), ownPlaces;
    const auto isHere = [&](const ForestPlan::Place& place) {
        return plan.trees[place.tree].rows > fewest && plan.trees[place.tree].rows <= N;
    };
    int count = 0, bodies = 0;
    for (const JointConstraint& c : list) bodies = larger(bodies, larger(c.a, c.b) + 1);
    for (std::size_t k = 0; k < plan.places.size(); ++k)
        if (isHere(plan.places[k])) placeHere[k] = count++;
    ownPlaces.assign(bodies, -1);
    for (const ForestPlan::Tree& tree : plan.trees) {
        Tree& made = trees_.emplace_back();
        made.whole = tree.whole, made.closed = tree.closed, made.damped = tree.closed && tree.torn;
        made.inNet = tree.inNet;
    }
    for (const ForestPlan::Place& place : plan.places) {
        Tree& tree = trees_[place.tree];
        tree.closings += place.closes;
        tree.geared = tree.geared || place.gear;
    }
    for (const ForestPlan::Place& place : plan.places) {
        if (!isHere(place)) continue;
        const JointConstraint& c = list[place.joint];
        TreeJoint<N>& joint = joints_.emplace_back(treeJoint<N>(place, c, joints[c.joint]));
        joint.tree = place.tree;
        Tree& tree = trees_[place.tree];
        if (tree.end == 0) {
            tree.first = static_cast<int>(joints_.size()) - 1;
            tree.firstMember = static_cast<int>(members_.size());
            here_.push_back(place.tree);
        }
        joint.ownA = own(c.a, ownPlaces);
        joint.ownB = own(c.b, ownPlaces);
        tree.end = static_cast<int>(joints_.size());
        tree.endMember = static_cast<int>(members_.size());
        std::vector<typename BlockFactors<N>::Link> later;
        for (const ForestPlan::Link& link : place.later)
            later.push_back({placeHere[link.place], link.body, TreeBlock<N>::Zero()});
        const bool open = !tree.closed && !tree.geared;  // no row can depend on the others
        factors_.addPlace(later, open                           ? kVanishedInOpenTree
                                 : tree.closings > kFewClosings ? kVanishedInSheet
                                                                : kVanished);
    }
    factors_.connect();
    masses_.resize(members_.size());
    repeats_.resize(members_.size());
    moved_.resize(members_.size());
    x_.resize(joints_.size());
    fed_.resize(joints_.size());
}

template <int N>
void TreePart<N>::place(std::span<const int> trees, std::span<const Joint> joints, std::span<const Pose> poses) {
    for (const int number : trees) {
        trees_[number].before = -1.0;
        for (TreeJoint<N>& joint : jointsIn(number)) {
            joint.now = geometryOf(joint, joints[joint.joint], poses[joint.a], poses[joint.b]);
            if (joint.isGear) setTwistOfA(joints[joint.joint], poses[joint.a], joint);
        }
        for (Member& member : membersIn(number)) member.start = poses[member.body].rotation;
    }
}

template <int N>
void TreePart<N>::bend(std::span<const int> trees, std::span<const Joint> joints, const Bodies& bodies) {
    for (const int number : trees) {
        if (trees_[number].whole || trees_[number].inNet) continue;
        for (TreeJoint<N>& joint : jointsIn(number)) {
            const Chord chord(bodies, joint.a, joint.b);
            joint.bend.setZero();
            if (chord.h == 0.0) continue;
            const TreeRows<N> rate = velocityAlong(joint, bodies.velocities[joint.a], bodies.velocities[joint.b]);
            joint.bend = (errorAlong(joint, joints[joint.joint], chord.a, chord.b) - joint.now.error) / chord.h - rate;
        }
    }
}

template <int N>
TreeBlock<N> TreePart<N>::coupling(const TreeJoint<N>& i, const TreeJoint<N>& k, int body) const {
    const bool ofB = i.b == body, toB = k.b == body;
    TreeBlock<N> block = couplingThrough<N>(
        masses_[toB ? k.ownB : k.ownA], ofB ? i.now.armB : i.now.armA, twistOn(i, ofB),
        toB ? k.now.armB : k.now.armA, twistOn(k, toB));
    if (ofB != toB) block = -block;
    return block;
}

template <int N>
void TreePart<N>::factor(std::span<const int> trees, std::span<const InverseMass> masses) {
    for (const int number : trees) {
        const Tree& tree = trees_[number];
        for (int i = tree.firstMember; i < tree.endMember; ++i) masses_[i] = masses[members_[i].body];
        for (int k = tree.first; k < tree.end; ++k) setBlocks(k);
        factors_.factor(tree.first, tree.end);
    }
}

template <int N>
void TreePart<N>::setBlocks(int k) {
    TreeJoint<N>& joint = joints_[k];
    const TreeGeometry<N>& g = joint.now;
    const Twist<N>& twistA = twistOn(joint, false);
    TreeBlock<N> own = couplingThrough<N>(masses_[joint.ownA], g.armA, twistA, g.armA, twistA);
    own += couplingThrough<N>(masses_[joint.ownB], g.armB, g.twist, g.armB, g.twist);
    lookAlong(joint, joint, own);
    if (joint.closes) addPlay(joint, own);
    const Tree& tree = trees_[joint.tree];
    joint.softness = (tree.inNet ? kSoftness : 0.0) * own.diagonal();
    own.diagonal() += joint.softness;
    if (tree.yields()) own.diagonal() *= 1.0 + kDamping;
    factors_.setDiagonal(k, own);
    for (typename BlockFactors<N>::Link& link : factors_.links(k)) {
        if (link.body < 0) {
            link.block.setZero();
            continue;
        }
        const TreeJoint<N>& other = joints_[link.place];
        link.block = coupling(other, joint, link.body);
        if (sharesTwo(other, joint))  // 0 through a body that does not move
            link.block += coupling(other, joint, joint.a == link.body ? joint.b : joint.a);
        lookAlong(other, joint, link.block);
    }
}

template <int N>
void TreePart<N>::warmStart(std::span<const int> trees, double keep, std::span<Velocity> v) {
    for (const int number : trees)
        for (TreeJoint<N>& joint : jointsIn(number)) {
            const TreeRows<N> lambda = keep * joint.lambda;
            joint.lambda.setZero();
            if (keep == 0.0 || !trees_[number].inNet) continue;
            book(joint, lambda, 1.0);
            apply(joint, lambda, masses_[joint.ownA], masses_[joint.ownB], v[joint.a], v[joint.b]);
        }
}

template <int N>
void TreePart<N>::solveVelocities(std::span<const int> trees, double biasRate, std::span<Velocity> v,
                                  Correction& correction) {
    for (const int number : trees) {
        const Tree& tree = trees_[number];
        for (int k = tree.first; k < tree.end; ++k) {
            const TreeJoint<N>& joint = joints_[k];
            x_[k] = -velocityAlong(joint, v[joint.a], v[joint.b]) - biasRate * joint.now.error - joint.bend -
                    joint.softness.cwiseProduct(joint.lambda);
            correction.add(x_[k].cwiseAbs().maxCoeff(), 0.0);
        }
        factors_.solve(x_, tree.first, tree.end, [&](int k, const TreeRows<N>& lambda) {
            TreeJoint<N>& joint = joints_[k];
            book(joint, lambda, 1.0);
            apply(joint, lambda, masses_[joint.ownA], masses_[joint.ownB], v[joint.a], v[joint.b]);
            correction.add(0.0, lambda.cwiseAbs().sum());
        });
    }
}

template <int N>
void TreePart<N>::respond(int tree, std::span<Velocity> v, std::vector<double>& impulses) {
    const int first = trees_[tree].first, end = trees_[tree].end;
    for (int k = first; k < end; ++k) x_[k] = -velocityAlong(joints_[k], v[joints_[k].a], v[joints_[k].b]);
    factors_.solve(x_, first, end, [&](int k, const TreeRows<N>& lambda) {
        const TreeJoint<N>& joint = joints_[k];
        apply(joint, lambda, masses_[joint.ownA], masses_[joint.ownB], v[joint.a], v[joint.b]);
    });
    for (int k = first; k < end; ++k) impulses.insert(impulses.end(), x_[k].begin(), x_[k].end());
}

template <int N>
void TreePart<N>::bookResponse(int tree, std::span<const double> impulses, double share) {
    const int first = trees_[tree].first, end = trees_[tree].end;
    for (int k = first; k < end; ++k)
        book(joints_[k], TreeRows<N>(Eigen::Map<const TreeRows<N>>(impulses.data() + N * (k - first))), share);
}

template <int N>
void TreePart<N>::evaluateErrors(Tree& tree, std::span<const Joint> joints,
                                 std::span<const Pose> poses) {
    tree.worst = tree.ratio = tree.sum = 0.0;
    for (int k = tree.first; k < tree.end; ++k) {
        const TreeJoint<N>& joint = joints_[k];
        x_[k] = -errorAlong(joint, joints[joint.joint], poses[joint.a], poses[joint.b]);
        const double worst = x_[k].cwiseAbs().maxCoeff();
        tree.worst = larger(tree.worst, worst);
        tree.sum += worst;
        tree.ratio = larger(tree.ratio, worst / joint.reach);
    }
}

template <int N>
void TreePart<N>::keepStart(std::span<const int> trees, std::span<const Velocity> v) {
    for (const int number : trees)
        for (Member& member : membersIn(number)) {
            member.kept = v[member.body];
            member.spin = member.kept.angular;
        }
}

template <int N>
void TreePart<N>::keepEnd(std::span<const int> trees, std::span<const Pose> poses) {
    for (const int number : trees) {
        if (!trees_[number].whole) continue;
        for (Member& member : membersIn(number)) member.end = poses[member.body].rotation;
    }
}

template <int N>
void TreePart<N>::chooseGain(Tree& tree, const TreeNudge& nudge, const Bodies& bodies) const {
    const bool feeds = tree.whole && !tree.damped && nudge.feeds;
    double share = feeds ? feedbackShare(tree.ratio) : 0.0;
    if (tree.closed && share < 1.0) share = 0.0;  // perhaps it cannot be closed
    tree.h = bodies.spans[bodies.movable(joints_[tree.first].a, joints_[tree.first].b)];
    tree.gain = share > 0.0 ? share / tree.h : 0.0;
    tree.anew = share == 1.0;
    if (nudge.pushed) tree.before = -1.0;
}

template <int N>
void TreePart<N>::takeBackFeedback(Tree& tree, const TreeNudge& nudge, Bodies& bodies) {
    for (int i = tree.firstMember; i < tree.endMember; ++i) {
        const Member& member = members_[i];
        if (masses_[i].linear == 0.0) continue;
        Quat unused = member.start;
        bodies.velocities[member.body] = member.kept;
        turnFreely(bodies.masses[member.body], nudge.gyroscope, tree.h, unused,
                   bodies.velocities[member.body].angular);
    }
    for (int k = tree.first; k < tree.end; ++k) {
        book(joints_[k], fed_[k], -1.0);
        fed_[k].setZero();
    }
    tree.anew = false;
}

template <int N>
bool TreePart<N>::goesOn(Tree& tree, const TreeNudge& nudge, Bodies& bodies) {
    const bool better = tree.sum < kGain * tree.before;
    // No step removes the error of a loop that does not quite fit.
    if (tree.anew && !better && tree.ratio > (tree.closed ? kSmall : kMet)) {
        takeBackFeedback(tree, nudge, bodies);
        return false;
    }
    return better && tree.ratio > kMet && (tree.anew || (tree.whole && !nudge.feeds));
}

template <int N>
void TreePart<N>::nudge(std::span<const int> trees, const TreeNudge& nudge, std::span<const Joint> joints,
                        Bodies& bodies) {
    for (const int number : trees) {
        Tree& tree = trees_[number];
        evaluateErrors(tree, joints, bodies.poses);
        chooseGain(tree, nudge, bodies);
        for (int k = tree.first; k < tree.end; ++k) fed_[k].setZero();
        const bool mayBeRepeated = mayRepeat(tree, nudge);
        if (mayBeRepeated) keepLed(tree, bodies.poses);
        nudgeUntilMet(tree, nudge, joints, bodies);
        const bool failed = !tree.anew && tree.ratio > (tree.closed ? kSmall : kMet);
        if (mayBeRepeated && failed) repeat(tree, nudge, joints, bodies);
    }
}

template <int N>
void TreePart<N>::nudgeUntilMet(Tree& tree, const TreeNudge& nudge, std::span<const Joint> joints, Bodies& bodies) {
    nudgeOnce(tree, nudge, bodies);
    for (int i = 1; i < kMostNudges; ++i) {
        evaluateErrors(tree, joints, bodies.poses);
        if (!goesOn(tree, nudge, bodies)) break;
        nudgeOnce(tree, nudge, bodies);
    }
}

template <int N>
void TreePart<N>::nudgeOnce(Tree& tree, const TreeNudge& nudge, Bodies& bodies) {
    const double share = isInVain(tree)            ? 0.0
                         : tree.worst > nudge.most ? nudge.most / tree.worst
                                                   : 1.0;
    for (int k = tree.first; k < tree.end; ++k)
        if (share != 1.0) x_[k] *= share;
    for (int i = tree.firstMember; i < tree.endMember; ++i) moved_[i] = {};
    factors_.solve(x_, tree.first, tree.end, [&](int k, const TreeRows<N>& lambda) {
        const TreeJoint<N>& joint = joints_[k];
        apply(joint, lambda, masses_[joint.ownA], masses_[joint.ownB], moved_[joint.ownA],
              moved_[joint.ownB]);
    });
    limitMoves(tree, share * tree.sum);
    tree.before = tree.sum;
    for (int k = tree.first; k < tree.end; ++k) {
        book(joints_[k], x_[k], tree.gain);
        fed_[k] += tree.gain * x_[k];
    }
    move(tree, nudge, bodies);
}

template <int N>
void TreePart<N>::limitMoves(Tree& tree, double sum) {
    constexpr double kFar = 4.0;    // times the sum of the errors
    constexpr double kWide = 0.04;  // of the lever arms: below it, the solution of an open tree is good
    if (!tree.closed && tree.ratio < kWide) return;
    const auto wayOf = [&](int member, const Vec3& arm) {
        const Velocity& moved = moved_[member];
        return masses_[member].linear > 0.0 ? moved.linear.norm() + moved.angular.norm() * arm.norm()
                                            : 0.0;
    };
    double farthest = 0.0;
    for (int k = tree.first; k < tree.end; ++k) {
        const TreeJoint<N>& joint = joints_[k];
        farthest = larger(farthest, larger(wayOf(joint.ownA, joint.now.armA),
                                           wayOf(joint.ownB, joint.now.armB)));
    }
    if (!(farthest > kFar * sum)) return;
    tree.gain = 0.0, tree.anew = false;
    const double share = kFar * sum / farthest;
    for (int i = tree.firstMember; i < tree.endMember; ++i) {
        moved_[i].linear *= share;
        moved_[i].angular *= share;
    }
}

template <int N>
void TreePart<N>::move(const Tree& tree, const TreeNudge& nudge, Bodies& bodies) {
    FreeTurns turns(nudge.gyroscope);
    for (int i = tree.firstMember; i < tree.endMember; ++i) {
        if (masses_[i].linear == 0.0) continue;
        Member& member = members_[i];
        Pose& pose = bodies.poses[member.body];
        Velocity& v = bodies.velocities[member.body];
        pose.position += moved_[i].linear;
        v.linear += tree.gain * moved_[i].linear;
        if (tree.anew) {
            member.spin += moved_[i].angular / tree.h;
            member.before = member.end, member.end = member.start, v.angular = member.spin;
            turns.add(bodies.masses[member.body], tree.h, member.end, v.angular);
            continue;
        }
        pose.rotation = cayley(moved_[i].angular, pose.rotation);
        v.angular += tree.gain * moved_[i].angular;
    }
    turns.finish();
    if (tree.anew) turnToEnd(tree, bodies);
}

template <int N>
void TreePart<N>::turnToEnd(const Tree& tree, Bodies& bodies) const {
    for (int i = tree.firstMember; i < tree.endMember; ++i) {
        if (masses_[i].linear == 0.0) continue;
        const Member& member = members_[i];
        Quat& rotation = bodies.poses[member.body].rotation;
        rotation = renormalized(rotation * (member.before.conjugate() * member.end));
    }
}

template class TreePart<3>;
template class TreePart<5>;
template class TreePart<6>;

}  // namespace engine
