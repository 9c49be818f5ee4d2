#include "engine/solver/joint_trees.h"

#include <algorithm>
#include <set>
#include <utility>

namespace engine {
namespace {

/// A body that many joints meet in couples each of them with all others, which costs their number
/// squared; what comes after this many is left to the sweep.
constexpr int kMostJointsOfABody = 16;
/// A pivot that elimination has reduced to this share of itself was nearly a difference of equals:
/// its row follows from the others but for a little play, and dividing by that would tear at the
/// bodies.
constexpr double kVanished = 1e-6;

int find(std::vector<int>& leader, int i) {
    while (leader[i] != i) i = leader[i] = leader[leader[i]];
    return i;
}

/// c -= a b^T of an (n x k) and a (m x k) corner.
template <class Block>
void subtractProduct(Block& c, const Block& a, const Block& b, int n, int m, int k) {
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < m; ++j) {
            double sum = 0.0;
            for (int l = 0; l < k; ++l) sum += a(i, l) * b(j, l);
            c(i, j) -= sum;
        }
}

/// The inverse by sweeping one pivot after the other; rows whose pivot has vanished are left out.
template <class Block>
void invertKept(Block& m, int n, const double* scale) {
    bool kept[6];
    for (int p = 0; p < n; ++p) {
        const double pivot = m(p, p);
        kept[p] = pivot > kVanished * scale[p];
        if (!kept[p]) continue;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                if (i != p && j != p) m(i, j) -= m(i, p) * m(p, j) / pivot;
        for (int i = 0; i < n; ++i)
            if (i != p) m(i, p) /= pivot, m(p, i) /= pivot;
        m(p, p) = -1.0 / pivot;
    }
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) m(i, j) = kept[i] && kept[j] ? -m(i, j) : 0.0;
}

/// Which joints are coupled, as elimination goes on.
struct Graph {
    std::vector<std::set<int>> neighbours;
    std::set<std::pair<int, int>> byDegree;  // (degree, joint): ties go to the lower number

    void connect(int i, int k) {
        neighbours[i].insert(k);
        neighbours[k].insert(i);
    }
    void rank(int i) { byDegree.insert({static_cast<int>(neighbours[i].size()), i}); }
    void unrank(int i) { byDegree.erase({static_cast<int>(neighbours[i].size()), i}); }
};

int commonBody(const JointConstraint<double>& x, const JointConstraint<double>& y,
               std::span<const InverseMass<double>> masses) {
    for (const int body : {x.a, x.b})
        if (masses[body].linear > 0.0 && (body == y.a || body == y.b)) return body;
    return -1;
}

}  // namespace

void JointTrees::choose(std::span<JointConstraint<double>> joints,
                        std::span<const InverseMass<double>> masses) {
    std::vector<int> leader(masses.size()), degree(masses.size(), 0);
    std::vector<char> held(masses.size(), 0);  // by leader: the tree hangs on something immovable
    for (int i = 0; i < static_cast<int>(leader.size()); ++i) leader[i] = i;
    for (JointConstraint<double>& joint : joints) {
        bool fits = !joint.spring.isSoft();
        for (const int body : {joint.a, joint.b})
            fits = fits && (masses[body].linear == 0.0 || degree[body] < kMostJointsOfABody);
        const bool linksTwo = masses[joint.a].linear > 0.0 && masses[joint.b].linear > 0.0;
        const int a = find(leader, joint.a), b = find(leader, joint.b);
        const bool heldA = masses[joint.a].linear == 0.0 || held[a];
        const bool heldB = masses[joint.b].linear == 0.0 || held[b];
        // Hinges and welds between two held ends hold the directions across twice.
        const bool heldTwice = heldA && heldB && joint.count > 3;
        joint.inTree = fits && !(linksTwo && a == b) &&
                       !(heldTwice && (linksTwo || held[masses[joint.a].linear > 0.0 ? a : b]));
        if (!joint.inTree) continue;
        if (linksTwo) leader[std::max(a, b)] = std::min(a, b);
        held[masses[joint.a].linear > 0.0 ? find(leader, a) : find(leader, b)] = heldA || heldB;
        ++degree[joint.a], ++degree[joint.b];
    }
}

void JointTrees::build(std::span<JointConstraint<double>> joints,
                       std::span<const InverseMass<double>> masses) {
    choose(joints, masses);
    Graph graph;
    graph.neighbours.resize(joints.size());
    std::vector<std::vector<int>> jointsOf(masses.size());
    for (int i = 0; i < static_cast<int>(joints.size()); ++i) {
        if (!joints[i].inTree) continue;
        for (const int body : {joints[i].a, joints[i].b}) {
            if (masses[body].linear == 0.0) continue;
            for (const int other : jointsOf[body]) graph.connect(i, other);
            jointsOf[body].push_back(i);
        }
    }
    for (int i = 0; i < static_cast<int>(joints.size()); ++i)
        if (joints[i].inTree) graph.rank(i);

    order_.clear();
    std::vector<std::vector<int>> later;
    while (!graph.byDegree.empty()) {
        const int i = graph.byDegree.begin()->second;
        graph.byDegree.erase(graph.byDegree.begin());
        order_.push_back(i);
        const std::set<int> around = graph.neighbours[i];
        later.emplace_back(around.begin(), around.end());
        for (const int k : around) graph.unrank(k);
        for (const int k : around) {
            graph.neighbours[k].erase(i);
            for (const int l : around)
                if (l != k) graph.connect(k, l);
        }
        for (const int k : around) graph.rank(k);
    }

    std::vector<int> placeOf(joints.size(), -1);
    for (int place = 0; place < static_cast<int>(order_.size()); ++place)
        placeOf[order_[place]] = place;
    nodes_.assign(order_.size(), {});
    for (int place = 0; place < static_cast<int>(order_.size()); ++place)
        for (const int k : later[place])
            nodes_[place].later.push_back(
                {placeOf[k], commonBody(joints[order_[place]], joints[k], masses)});
    work_.assign(order_.size() * kRows, 0.0);
}

void JointTrees::factor(std::span<const JointConstraint<double>> joints) {
    for (int place = 0; place < static_cast<int>(order_.size()); ++place) {
        Node& node = nodes_[place];
        const JointConstraint<double>& joint = joints[order_[place]];
        node.rows = joint.count;
        for (int i = 0; i < joint.count; ++i)
            for (int k = 0; k < joint.count; ++k)
                node.diagonal(i, k) = coupling(joint.rows[i], joint.rows[k]);
        for (Neighbour& n : node.later) {
            const JointConstraint<double>& other = joints[order_[n.place]];
            for (int i = 0; i < other.count; ++i)
                for (int k = 0; k < joint.count; ++k)
                    n.block(i, k) =
                        n.body < 0 ? 0.0
                                   : couplingThrough(other.rows[i], other.b == n.body,
                                                     joint.rows[k], joint.b == n.body);
        }
        for (int i = 0; i < joint.count; ++i) work_[place * kRows + i] = node.diagonal(i, i);
    }
    for (int place = 0; place < static_cast<int>(order_.size()); ++place) eliminate(place);
}

void JointTrees::eliminate(int place) {
    Node& node = nodes_[place];
    invertKept(node.diagonal, node.rows, &work_[place * kRows]);
    for (Neighbour& n : node.later) {
        const int rows = nodes_[n.place].rows;
        const Block a = n.block;  // A_ik
        n.block.setZero();
        subtractProduct(n.block, a, node.diagonal, rows, node.rows, node.rows);
        n.block = -n.block;  // W_ik = A_ik D_k^-1
        subtractProduct(nodes_[n.place].diagonal, n.block, a, rows, rows, node.rows);
        // A_li -= W_lk A_ik^T for the pairs already passed, whose W is known.
        for (Neighbour& l : node.later) {
            if (l.place == n.place) break;
            const bool lFirst = l.place < n.place;
            Node& earlier = nodes_[lFirst ? l.place : n.place];
            const int laterPlace = lFirst ? n.place : l.place;
            for (Neighbour& target : earlier.later) {
                if (target.place != laterPlace) continue;
                if (lFirst)  // A_nl -= A_nk D^-1 A_lk^T = A_nk W_lk^T
                    subtractProduct(target.block, a, l.block, rows, nodes_[l.place].rows,
                                    node.rows);
                else  // A_ln -= W_lk A_nk^T
                    subtractProduct(target.block, l.block, a, nodes_[l.place].rows, rows,
                                    node.rows);
            }
        }
    }
}

void JointTrees::solve(std::vector<double>& x) const {
    const int count = static_cast<int>(nodes_.size());
    for (int k = 0; k < count; ++k)
        for (const Neighbour& n : nodes_[k].later)
            for (int i = 0; i < nodes_[n.place].rows; ++i)
                for (int j = 0; j < nodes_[k].rows; ++j)
                    x[n.place * kRows + i] -= n.block(i, j) * x[k * kRows + j];
    for (int k = count - 1; k >= 0; --k) {
        double z[kRows] = {};
        for (int i = 0; i < nodes_[k].rows; ++i)
            for (int j = 0; j < nodes_[k].rows; ++j)
                z[i] += nodes_[k].diagonal(i, j) * x[k * kRows + j];
        for (const Neighbour& n : nodes_[k].later)
            for (int j = 0; j < nodes_[k].rows; ++j)
                for (int i = 0; i < nodes_[n.place].rows; ++i)
                    z[j] -= n.block(i, j) * x[n.place * kRows + i];
        for (int i = 0; i < nodes_[k].rows; ++i) x[k * kRows + i] = z[i];
    }
}

void JointTrees::solveVelocities(std::span<JointConstraint<double>> joints,
                                 std::span<Velocity<double>> v, Correction<double>& correction) {
    for (int place = 0; place < static_cast<int>(order_.size()); ++place) {
        const JointConstraint<double>& joint = joints[order_[place]];
        for (int i = 0; i < joint.count; ++i)
            work_[place * kRows + i] =
                -(velocityAlong(joint.rows[i].j, v[joint.a], v[joint.b]) + joint.bias[i]);
    }
    for (const double rhs : work_) correction.add(rhs, 0.0);
    solve(work_);
    for (int place = 0; place < static_cast<int>(order_.size()); ++place) {
        JointConstraint<double>& joint = joints[order_[place]];
        for (int i = 0; i < joint.count; ++i) {
            const double lambda = work_[place * kRows + i];
            joint.lambda[i] += lambda;
            push(joint, i, lambda, v[joint.a], v[joint.b]);
            correction.add(0.0, lambda);
        }
    }
}

}  // namespace engine
