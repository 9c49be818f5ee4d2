#include "engine/solver/joint_forests.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

#include "engine/base/disjoint_sets.h"

namespace engine {
namespace {

using Joints = std::span<JointConstraint>;
using Masses = std::span<const InverseMass>;

constexpr int kMostForests = 4;
constexpr int kMostLoops = 16;  // that a tree closes: more joints couple with each other by every loop
/// The joints of a body are all coupled with each other, so the cost grows with their number
/// squared. Joints beyond this number are left to the next forest.
constexpr int kMostJointsOfABody = 16;

bool moves(Masses masses, int body) { return masses[body].linear > 0.0; }

/// Connected bodies, by their leader; fixed bodies do not connect.
class Trees {
public:
    explicit Trees(Masses masses) : masses_(masses), held_(masses.size()) {
        sets_.reset(static_cast<int>(masses.size()));
    }

    int of(int body) { return sets_.leaderOf(body); }
    /// The tree of a joint's movable end.
    int of(const JointConstraint& joint) { return of(moves(masses_, joint.a) ? joint.a : joint.b); }
    bool isHeld(int body) { return !moves(masses_, body) || held_[of(body)]; }

    void link(const JointConstraint& joint) {
        const bool held = isHeld(joint.a) || isHeld(joint.b);
        if (moves(masses_, joint.a) && moves(masses_, joint.b)) sets_.join(joint.a, joint.b);
        held_[of(joint)] = held;
    }

private:
    Masses masses_;
    DisjointSets sets_;
    std::vector<char> held_;
};

/// Bodies connected by joints; immovable ones do not connect.
DisjointSets connectedSets(Joints joints, Masses masses) {
    DisjointSets sets;
    sets.reset(static_cast<int>(masses.size()));
    for (const JointConstraint& joint : joints)
        if (moves(masses, joint.a) && moves(masses, joint.b)) sets.join(joint.a, joint.b);
    return sets;
}

/// For every body: whether a joint of its connected set is torn.
std::vector<char> findTorn(Joints joints, Masses masses, DisjointSets& sets) {
    std::vector<char> torn(masses.size(), 0);
    for (const JointConstraint& joint : joints)
        if (joint.torn) torn[sets.leaderOf(moves(masses, joint.a) ? joint.a : joint.b)] = 1;
    for (int i = 0; i < static_cast<int>(masses.size()); ++i) torn[i] = torn[sets.leaderOf(i)];
    return torn;
}

/// For every body: whether its tree may close loops, because its connected set has few of them. Sets where
/// two bodies have two joints, or a joint that must be swept, may not.
std::vector<char> findRings(Joints joints, Masses masses) {
    const int bodies = static_cast<int>(masses.size());
    const auto linksTwo = [&](const JointConstraint& joint) {
        return !joint.spring.isSoft() && !joint.isGear && moves(masses, joint.a) &&
               moves(masses, joint.b);
    };
    DisjointSets sets, linked;
    sets.reset(bodies), linked.reset(bodies);
    for (const JointConstraint& joint : joints)
        if (linksTwo(joint)) sets.join(joint.a, joint.b);
    std::vector<int> loops(bodies, 0);
    std::set<std::pair<int, int>> pairs;
    for (const JointConstraint& joint : joints) {
        if (!linksTwo(joint)) continue;
        int& ofSet = loops[sets.leaderOf(joint.a)];
        const bool first = pairs.insert(std::minmax(joint.a, joint.b)).second;
        if (joint.treeRows == 0 || !first) ofSet += kMostLoops + 1;
        if (linked.leaderOf(joint.a) == linked.leaderOf(joint.b)) ++ofSet;
        linked.join(joint.a, joint.b);
    }
    std::vector<char> rings;
    for (int i = 0; i < bodies; ++i) rings.push_back(loops[sets.leaderOf(i)] <= kMostLoops);
    return rings;
}

/// A gear holds nothing by itself, so it comes after all that may hold a tree a second time.
std::vector<int> gearsLast(Joints joints) {
    std::vector<int> order(joints.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](int i) { return joints[i].isGear; });
    return order;
}

/// Chooses the joints of the next forest; `closes` marks those that hold a tree a second time, or
/// close a loop in it.
std::vector<int> choose(Joints joints, Masses masses, const std::vector<char>& torn,
                        const std::vector<char>& rings, Trees& trees, std::vector<char>& closes) {
    std::vector<int> chosen, degree(masses.size(), 0);
    int looped = 0;
    for (const int i : gearsLast(joints)) {
        JointConstraint& joint = joints[i];
        if (joint.inTree || joint.spring.isSoft() || joint.treeRows == 0) continue;
        bool fits = true;
        for (const int body : {joint.a, joint.b})
            fits = fits && (!moves(masses, body) || degree[body] < kMostJointsOfABody);
        const bool linksTwo = moves(masses, joint.a) && moves(masses, joint.b);
        const bool loop = linksTwo && trees.of(joint.a) == trees.of(joint.b);
        const bool tooMany = joint.isGear ? looped == kMostLoops : !rings[joint.a];
        if (!fits || (loop && tooMany)) continue;
        if (joint.isGear)
            looped += loop;
        else
            closes[i] = linksTwo ? loop || (trees.isHeld(joint.a) && trees.isHeld(joint.b))
                                 : trees.isHeld(moves(masses, joint.a) ? joint.a : joint.b);
        const int body = moves(masses, joint.a) ? joint.a : joint.b;
        if (closes[i] && torn[body] && !rings[body]) continue;
        joint.inTree = true;
        trees.link(joint);
        chosen.push_back(i);
        ++degree[joint.a], ++degree[joint.b];
    }
    return chosen;
}

/// The coupling of joints during elimination.
class Graph {
public:
    Graph(Joints joints, Masses masses, const std::vector<int>& chosen)
        : neighbours_(joints.size()), level_(joints.size(), 0) {
        std::vector<std::vector<int>> jointsOf(masses.size());
        for (const int i : chosen)
            for (const int body : {joints[i].a, joints[i].b}) {
                if (!moves(masses, body)) continue;
                for (const int other : jointsOf[body]) connect(i, other);
                jointsOf[body].push_back(i);
            }
        for (const int i : chosen) ranked_.insert(rank(i));
    }

    bool empty() const { return ranked_.empty(); }
    int next() const { return std::get<2>(*ranked_.begin()); }

    /// Couples all neighbours of i with each other; returns them.
    std::set<int> eliminate(int i) {
        ranked_.erase(rank(i));
        const std::set<int> around = neighbours_[i];
        for (const int k : around) ranked_.erase(rank(k));
        for (const int k : around) {
            neighbours_[k].erase(i);
            level_[k] = std::max(level_[k], level_[i] + 1);
            for (const int l : around)
                if (l != k) connect(k, l);
        }
        for (const int k : around) ranked_.insert(rank(k));
        return around;
    }

private:
    void connect(int i, int k) {
        neighbours_[i].insert(k);
        neighbours_[k].insert(i);
    }
    /// Degree, then level (eliminations needed before), then number.
    std::tuple<int, int, int> rank(int i) const {
        return {static_cast<int>(neighbours_[i].size()), level_[i], i};
    }

    std::vector<std::set<int>> neighbours_;
    std::vector<int> level_;
    std::set<std::tuple<int, int, int>> ranked_;
};

int commonBody(const JointConstraint& x, const JointConstraint& y, Masses masses) {
    for (const int body : {x.a, x.b})
        if (moves(masses, body) && (body == y.a || body == y.b)) return body;
    return -1;
}

void addPlaces(Joints joints, Masses masses, const std::vector<int>& chosen, ForestPlan& plan) {
    Graph graph(joints, masses, chosen);
    std::vector<int> placeOf(joints.size(), -1);
    std::vector<std::set<int>> around;
    while (!graph.empty()) {
        const int i = graph.next();
        placeOf[i] = static_cast<int>(plan.places.size());
        plan.places.emplace_back().joint = i;
        around.push_back(graph.eliminate(i));
    }
    for (int k = 0; k < static_cast<int>(plan.places.size()); ++k) {
        ForestPlan::Place& place = plan.places[k];
        for (const int i : around[k])
            place.later.push_back({placeOf[i], commonBody(joints[place.joint], joints[i], masses)});
        std::sort(place.later.begin(), place.later.end(),
                  [](const auto& x, const auto& y) { return x.place < y.place; });
    }
}

void addTrees(Joints joints, Masses masses, const std::vector<char>& torn, Trees& trees,
              ForestPlan& plan) {
    std::vector<int> number(masses.size(), -1);
    for (ForestPlan::Place& place : plan.places) {
        const JointConstraint& joint = joints[place.joint];
        int& tree = number[trees.of(joint)];
        if (tree < 0) {
            tree = static_cast<int>(plan.trees.size());
            plan.trees.emplace_back();
        }
        place.tree = tree;
        plan.trees[tree].rows = std::max(plan.trees[tree].rows, joint.treeRows);
        plan.trees[tree].closed = plan.trees[tree].closed || place.closes;
        plan.trees[tree].torn = plan.trees[tree].torn || torn[moves(masses, joint.a) ? joint.a : joint.b];
    }
}

/// Trees do not depend on each other: in this order, each is solved on its own.
void sortByTree(ForestPlan& plan) {
    const int count = static_cast<int>(plan.places.size());
    std::vector<int> order(count), now(count);
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](int k) { return plan.places[k].tree; });
    for (int k = 0; k < count; ++k) now[order[k]] = k;
    std::vector<ForestPlan::Place> sorted;
    for (const int k : order) {
        sorted.push_back(std::move(plan.places[k]));
        for (ForestPlan::Link& link : sorted.back().later) link.place = now[link.place];
    }
    plan.places = std::move(sorted);
}

/// A tree is not whole if a rigid joint outside it acts on it.
void findWhole(Joints joints, Masses masses, Trees& trees, ForestPlan& plan) {
    std::vector<char> pulled(masses.size(), 0), inPlan(joints.size(), 0);
    for (const ForestPlan::Place& place : plan.places) inPlan[place.joint] = 1;
    for (int i = 0; i < static_cast<int>(joints.size()); ++i)
        if (!inPlan[i] && !joints[i].spring.isSoft())
            for (const int body : {joints[i].a, joints[i].b})
                if (moves(masses, body)) pulled[trees.of(body)] = 1;
    for (const ForestPlan::Place& place : plan.places)
        if (pulled[trees.of(joints[place.joint])]) plan.trees[place.tree].whole = false;
}

/// A net: joints of a connected set are in several forests.
void markNets(Joints joints, Masses masses, DisjointSets& sets, std::vector<ForestPlan>& plans) {
    const auto setOf = [&](const ForestPlan::Place& place) {
        const JointConstraint& joint = joints[place.joint];
        return sets.leaderOf(moves(masses, joint.a) ? joint.a : joint.b);
    };
    std::vector<char> inSeveral(masses.size(), 0);
    for (std::size_t i = 1; i < plans.size(); ++i)
        for (const ForestPlan::Place& place : plans[i].places) inSeveral[setOf(place)] = 1;
    for (ForestPlan& plan : plans)
        for (const ForestPlan::Place& place : plan.places) {
            ForestPlan::Tree& tree = plan.trees[place.tree];
            tree.inNet = !tree.whole && inSeveral[setOf(place)];
        }
}

}  // namespace

std::vector<ForestPlan> planForests(Joints joints, Masses masses) {
    std::vector<ForestPlan> plans;
    std::vector<char> closes(joints.size(), 0);
    DisjointSets sets = connectedSets(joints, masses);
    const std::vector<char> torn = findTorn(joints, masses, sets);
    const std::vector<char> rings = findRings(joints, masses);
    for (JointConstraint& joint : joints) joint.inTree = false;
    for (int i = 0; i < kMostForests; ++i) {
        Trees trees(masses);
        const std::vector<int> chosen = choose(joints, masses, torn, rings, trees, closes);
        if (chosen.empty()) break;
        ForestPlan& plan = plans.emplace_back();
        addPlaces(joints, masses, chosen, plan);
        for (ForestPlan::Place& place : plan.places) {
            place.closes = closes[place.joint];
            place.gear = joints[place.joint].isGear;
        }
        addTrees(joints, masses, torn, trees, plan);
        findWhole(joints, masses, trees, plan);
        sortByTree(plan);
    }
    markNets(joints, masses, sets, plans);
    return plans;
}

}  // namespace engine
