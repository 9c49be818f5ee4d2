/// A = L D L^T with blocks of N x N, for a symmetric A whose pattern is known.
///   W_ik = A_ik D_k^-1,   A_ij -= W_ik A_jk^T       for all i, j after k
/// Blocks have a fixed size: factoring a chain takes a hundred multiplications per joint. A row that depends
/// on the others has a vanishing pivot; it is left out, and its x is 0.
#pragma once
#include <span>
#include <vector>

#include "engine/base/math.h"

namespace engine {

/// A pivot reduced to this share of itself by elimination is nearly a difference of equals: its row depends
/// on the others except for a little play, and dividing by it would give huge impulses.
constexpr double kVanished = 1e-6;
/// The same in a tree that more than a few joints close: one loop after the other loses digits. With it, a
/// chain between two posts would come apart by a tenth of a millimetre.
constexpr double kVanishedInSheet = 1e-4;
constexpr int kFewClosings = 4;
/// In a tree that is held once, no row depends on the others: pivots that a long chain reduces to a millionth
/// are valid. Only round-off is left out.
constexpr double kVanishedInOpenTree = 1e-13;

/// Inverts by sweeping the pivots one by one; rows with a vanishing pivot are left out.
template <int N>
void sweepPivots(Eigen::Matrix<double, N, N>& m, const Eigen::Matrix<double, N, 1>& scale,
                 double vanished = kVanished) {
    bool kept[N];
    for (int p = 0; p < N; ++p) {
        kept[p] = m(p, p) > vanished * scale[p];
        if (!kept[p]) continue;
        const double inverse = 1.0 / m(p, p);
        double row[N];
        for (int j = 0; j < N; ++j) row[j] = m(p, j) * inverse;
        for (int j = 0; j < N; ++j)
            for (int i = 0; i < N; ++i)
                if (i != p && j != p) m(i, j) -= m(i, p) * row[j];
        for (int j = 0; j < N; ++j) m(j, p) = m(p, j) = row[j];
        m(p, p) = -inverse;
    }
    for (int i = 0; i < N; ++i)
        for (int j = 0; j < N; ++j) m(i, j) = kept[i] && kept[j] ? -m(i, j) : 0.0;
}

/// Inverts by cofactors with one division; the pivots are quotients of minors.
inline void invertKept(Mat3& m, const Vec3& scale, double vanished) {
    const double a = m(0, 0), b = m(1, 0), c = m(2, 0), d = m(1, 1), e = m(2, 1), f = m(2, 2);
    const double minor = a * d - b * b;
    const double c0 = d * f - e * e, c1 = c * e - b * f, c2 = b * e - c * d;
    const double det = a * c0 + b * c1 + c * c2;
    if (!(a > vanished * scale[0] && minor > vanished * scale[1] * a &&
          det > vanished * scale[2] * minor)) {
        sweepPivots<3>(m, scale, vanished);
        return;
    }
    const double inverse = 1.0 / det;
    m(0, 0) = c0 * inverse;
    m(1, 1) = (a * f - c * c) * inverse;
    m(2, 2) = minor * inverse;
    m(0, 1) = m(1, 0) = c1 * inverse;
    m(0, 2) = m(2, 0) = c2 * inverse;
    m(1, 2) = m(2, 1) = (b * c - a * e) * inverse;
}

/// Inverts a larger matrix in two parts, with F = B A^-1 and S = C - F B^T:
///   [A B^T; B C]^-1 = [A^-1 + F^T S^-1 F, -F^T S^-1; -S^-1 F, S^-1]
template <int N>
void invertKept(Eigen::Matrix<double, N, N>& m, const Eigen::Matrix<double, N, 1>& scale,
                double vanished) {
    constexpr int K = N - 3;
    Mat3 a = m.template topLeftCorner<3, 3>();
    const Eigen::Matrix<double, K, 3> b = m.template bottomLeftCorner<K, 3>();
    invertKept(a, Vec3(scale.template head<3>()), vanished);
    const Eigen::Matrix<double, K, 3> f = b.lazyProduct(a);
    Eigen::Matrix<double, K, K> s = m.template bottomRightCorner<K, K>();
    s -= f.lazyProduct(b.transpose());
    sweepPivots<K>(s, scale.template tail<K>(), vanished);
    const Eigen::Matrix<double, K, 3> g = s.lazyProduct(f);
    m.template topLeftCorner<3, 3>() = a + f.transpose().lazyProduct(g);
    m.template bottomLeftCorner<K, 3>() = -g;
    m.template topRightCorner<3, K>() = -g.transpose();
    m.template bottomRightCorner<K, K>() = s;
}

template <int N>
class BlockFactors {
public:
    using Block = Eigen::Matrix<double, N, N>;
    using Rows = Eigen::Matrix<double, N, 1>;
    /// The coupling of a place with a place eliminated later, direct or by fill-in.
    struct Link {
        int place;
        int body;     // the common movable body; -1: fill-in
        Block block;  // A_ik, then W_ik
    };

    /// Adds the next place, with its later places in ascending order. `vanished`: see kVanished.
    void addPlace(std::span<const Link> later, double vanished);
    /// Call after all places were added: finds the target block of every product.
    void connect();
    int count() const { return static_cast<int>(nodes_.size()); }

    /// Sets A_kk; the links' blocks are set through links(k).
    void setDiagonal(int k, const Block& a) {
        nodes_[k].inverse = a;
        nodes_[k].scale = a.diagonal();
    }
    std::span<Link> links(int k) {
        return std::span<Link>(links_).subspan(nodes_[k].firstLink, nodes_[k].linkCount);
    }

    // For the places from `first` up to `end`, which are not linked to others:

    /// Computes D_k^-1 and W_ik from A.
    void factor(int first, int end);
    /// x = A^-1 x; calls `give(k, x_k)` for each of them, from last to first.
    template <class Give>
    void solve(std::vector<Rows>& x, int first, int end, Give give) const;

private:
    struct Node {
        Block inverse = Block::Zero();  // A_kk, D_k, D_k^-1
        Rows scale = Rows::Zero();      // A_kk's diagonal
        int firstLink = 0, linkCount = 0;
        int firstTarget = 0;
        double vanished = kVanished;
    };

    std::vector<Node> nodes_;
    std::vector<Link> links_;
    std::vector<int> targets_;  // for every node, and i after j among its links: the link A_ij
};

/// a b
template <int N>
inline Eigen::Matrix<double, N, N> product(const Eigen::Matrix<double, N, N>& a,
                                        const Eigen::Matrix<double, N, N>& b) {
    Eigen::Matrix<double, N, N> result;
    for (int j = 0; j < N; ++j) {
        double column[N];
        for (int i = 0; i < N; ++i) column[i] = a(i, 0) * b(0, j);
        for (int l = 1; l < N; ++l)
            for (int i = 0; i < N; ++i) column[i] += a(i, l) * b(l, j);
        for (int i = 0; i < N; ++i) result(i, j) = column[i];
    }
    return result;
}

/// c - a b^T
template <int N>
inline Eigen::Matrix<double, N, N> lessProduct(const Eigen::Matrix<double, N, N>& c,
                                        const Eigen::Matrix<double, N, N>& a,
                                        const Eigen::Matrix<double, N, N>& b) {
    Eigen::Matrix<double, N, N> result;
    for (int j = 0; j < N; ++j) {
        double column[N];
        for (int i = 0; i < N; ++i) column[i] = c(i, j);
        for (int l = 0; l < N; ++l)
            for (int i = 0; i < N; ++i) column[i] -= a(i, l) * b(j, l);
        for (int i = 0; i < N; ++i) result(i, j) = column[i];
    }
    return result;
}

/// x - m y
template <int N>
inline Eigen::Matrix<double, N, 1> lessProduct(const Eigen::Matrix<double, N, 1>& x,
                                        const Eigen::Matrix<double, N, N>& m,
                                        const Eigen::Matrix<double, N, 1>& y) {
    double sum[N];
    for (int i = 0; i < N; ++i) sum[i] = x[i];
    for (int j = 0; j < N; ++j)
        for (int i = 0; i < N; ++i) sum[i] -= m(i, j) * y[j];
    Eigen::Matrix<double, N, 1> result;
    for (int i = 0; i < N; ++i) result[i] = sum[i];
    return result;
}

template <int N>
void BlockFactors<N>::addPlace(std::span<const Link> later, double vanished) {
    Node node;
    node.vanished = vanished;
    node.firstLink = static_cast<int>(links_.size());
    node.linkCount = static_cast<int>(later.size());
    nodes_.push_back(node);
    links_.insert(links_.end(), later.begin(), later.end());
}

template <int N>
void BlockFactors<N>::connect() {
    targets_.clear();
    for (Node& node : nodes_) {
        node.firstTarget = static_cast<int>(targets_.size());
        for (int i = 0; i < node.linkCount; ++i)
            for (int j = 0; j < i; ++j) {
                const Node& earlier = nodes_[links_[node.firstLink + j].place];
                int target = earlier.firstLink;
                while (links_[target].place != links_[node.firstLink + i].place) ++target;
                targets_.push_back(target);
            }
    }
}

template <int N>
void BlockFactors<N>::factor(int first, int end) {
    for (Node& node : std::span(nodes_).subspan(first, end - first)) {
        invertKept(node.inverse, node.scale, node.vanished);
        int target = node.firstTarget;
        for (int i = 0; i < node.linkCount; ++i) {
            Link& link = links_[node.firstLink + i];
            const Block a = link.block;  // A_ik
            link.block = product<N>(a, node.inverse);  // W_ik
            Block& diagonal = nodes_[link.place].inverse;
            diagonal = lessProduct<N>(diagonal, link.block, a);
            for (int j = 0; j < i; ++j) {  // A_ij -= A_ik W_jk^T
                Block& later = links_[targets_[target++]].block;
                later = lessProduct<N>(later, a, links_[node.firstLink + j].block);
            }
        }
    }
}

template <int N>
template <class Give>
void BlockFactors<N>::solve(std::vector<Rows>& x, int first, int end, Give give) const {
    for (int k = first; k < end; ++k) {
        const Node& node = nodes_[k];
        const Rows xk = x[k];
        for (int i = 0; i < node.linkCount; ++i) {
            const Link& link = links_[node.firstLink + i];
            x[link.place] = lessProduct<N>(x[link.place], link.block, xk);
        }
    }
    for (int k = end - 1; k >= first; --k) {
        const Node& node = nodes_[k];
        Rows z = -lessProduct<N>(Rows::Zero(), node.inverse, x[k]);
        for (int i = 0; i < node.linkCount; ++i) {
            const Link& link = links_[node.firstLink + i];
            const Rows xi = x[link.place];
            for (int j = 0; j < N; ++j)
                for (int l = 0; l < N; ++l) z[j] -= link.block(l, j) * xi[l];
        }
        x[k] = z;
        give(k, x[k]);
    }
}

}  // namespace engine
