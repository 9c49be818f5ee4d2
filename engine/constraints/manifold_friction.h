/// Friction of a whole manifold. Its points share a plane (manifold_frame.h), so their friction is a force
/// and a twist about the normal, and one solve of three rows stops all slip:
///   (F_1, F_2, T) = total - K^-1 (s_1, s_2, w_n),   K = J M^-1 J^T of the three at the middle c
/// It is distributed over the points like the load, with p_i = lambda_i / sum and the centre m of the load,
///   f_i = p_i (F + (T - m x F) / S  (r_i - m) turned),   S = sum p_i |r_i - m|^2
/// If every f_i is inside its cone |f_i| <= mu lambda_i, that is the solution. Otherwise the manifold slips,
/// and the points are solved one by one (cone.h).
#pragma once
#include <array>

#include "engine/constraints/cone.h"
#include "engine/constraints/contact.h"

namespace engine {

/// In the contact's axes t1, t2 about c; x and y are the points' coordinates.
struct ManifoldFriction {
    Vec3 armA = Vec3::Zero(), armB = Vec3::Zero();  // m, to c
    Vec4 x = Vec4::Zero(), y = Vec4::Zero();        // m
    double reach = 0.0;                             // m: the largest |x| or |y|
    Mat3 k = Mat3::Zero();                          // for (s_1, s_2, w_n)
    Mat3 mass = Mat3::Zero();                       // K^-1; without w_n for a single point
};

/// The inverse of K, or of its first two rows.
inline Mat3 twistMass(const Mat3& k, bool twists) {
    Mat3 mass = Mat3::Zero();
    const double d = k(0, 0) * k(1, 1) - k(0, 1) * k(1, 0);
    if (!(d > 0.0)) return mass;
    if (twists && k.determinant() > 1e-6 * k(2, 2) * d) return k.inverse();
    mass.topLeftCorner<2, 2>() << k(1, 1) / d, -k(0, 1) / d, -k(1, 0) / d, k(0, 0) / d;
    return mass;
}

/// `armA`, `armB`: m, to the points.
inline ManifoldFriction manifoldFriction(const Vec3& n, const Vec3& t1, const Vec3& t2, int count,
                                         const Vec3* armA, const Vec3* armB,
                                         const InverseMass& massA, const InverseMass& massB) {
    ManifoldFriction f;
    for (int i = 0; i < count; ++i) f.armA += armA[i] / count;
    f.armB = f.armA + (armB[0] - armA[0]);
    for (int i = 0; i < count && count > 1; ++i) {
        f.x[i] = t1.dot(armA[i] - f.armA), f.y[i] = t2.dot(armA[i] - f.armA);
        f.reach = larger(f.reach, larger(std::abs(f.x[i]), std::abs(f.y[i])));
    }
    const Row rows[3] = {makeRow(alongDirection(t1, f.armA, f.armB), massA, massB),
                         makeRow(alongDirection(t2, f.armA, f.armB), massA, massB),
                         makeRow({Vec3(Vec3::Zero()), Vec3(-n), n}, massA, massB)};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) f.k(i, j) = coupling(rows[i], rows[j]);
    f.mass = twistMass(f.k, f.reach > 0.0);
    return f;
}

/// The force and twist (F_1, F_2, T) of the friction of one point.
inline Vec3 aboutMiddle(const ManifoldFriction& f, int i, const Vec2& friction) {
    return {friction[0], friction[1], f.x[i] * friction[1] - f.y[i] * friction[0]};
}

/// The friction of each point so that they sum to `wanted`; false if one would leave its cone.
inline bool shareFriction(const ManifoldFriction& f, int count, const Vec3& wanted,
                          const Vec4& limit, std::array<Vec2, Contact::kMaxPoints>& shares) {
    const double load = limit.sum();
    const Vec4 p = limit / load;
    const Vec2 middle(p.dot(f.x), p.dot(f.y));
    double spread = 0.0;
    for (int i = 0; i < count; ++i)
        spread += p[i] * (Vec2(f.x[i], f.y[i]) - middle).squaredNorm();
    const double twist = wanted.z() - (middle.x() * wanted.y() - middle.y() * wanted.x());
    const bool wide = spread > 1e-6 * f.reach * f.reach;
    if (!wide && twist != 0.0) return false;
    const double turned = wide ? twist / spread : 0.0;
    for (int i = 0; i < count; ++i) {
        const Vec2 force(wanted.x() - turned * (f.y[i] - middle.y()),
                         wanted.y() + turned * (f.x[i] - middle.x()));
        if (p[i] > 0.0 && force.squaredNorm() > load * load) return false;
        shares[i] = p[i] * force;
    }
    return true;
}

}  // namespace engine
