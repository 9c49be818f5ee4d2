/// A box for tests along separating axes.
#pragma once
#include "engine/base/math.h"
#include "engine/shape.h"

namespace engine {

struct OrientedBox {
    Mat3 axes;  // columns
    Vec3 centre, half;

    OrientedBox(const Shape& shape, const Pose& pose)
        : axes(pose.rotation.toRotationMatrix()), centre(pose.position), half(shape.halfSize) {}
    /// Half its extent along the unit vector n.
    double extent(const Vec3& n) const { return (axes.transpose() * n).cwiseAbs().dot(half); }
};

/// The nine axes a_i x b_j across the edges of two boxes. In a's axes, with R = A^T B and the centres t apart, and
/// (i, i', i'') and (j, j', j'') cyclic,
///   (a_i x b_j) . t = t_i'' R_i'j - t_i' R_i''j
///   extents of a and b: h_i' |R_i''j| + h_i'' |R_i'j|,   g_j' |R_ij''| + g_j'' |R_ij'|
/// These show for most axes that they do not matter, without their length (Gottschalk 1996).
class EdgeAxes {
public:
    EdgeAxes(const OrientedBox& a, const OrientedBox& b)
        : turn_(a.axes.transpose() * b.axes), size_(turn_.cwiseAbs()),
          between_(a.axes.transpose() * (b.centre - a.centre)), halfA_(a.half), halfB_(b.half) {}

    /// Whether the boxes may be more than `least` (m) apart along a_i x b_j. Its length is at most 1, so where they
    /// overlap along it, they overlap by more than this shows.
    bool mayExceed(double least, int i, int j) const {
        constexpr double kRounding = 1e-9;  // m
        return apart(i, j) > smaller(least, 0.0) - kRounding;
    }

private:
    /// m, times the length of the axis.
    double apart(int i, int j) const {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        return std::abs(between_[i2] * turn_(i1, j) - between_[i1] * turn_(i2, j)) -
               (halfA_[i1] * size_(i2, j) + halfA_[i2] * size_(i1, j)) -
               (halfB_[j1] * size_(i, j2) + halfB_[j2] * size_(i, j1));
    }

    Mat3 turn_, size_;
    Vec3 between_, halfA_, halfB_;
};

}  // namespace engine
