#include "engine/dynamics/rotation.h"

#include <Eigen/LU>
#include <array>

#include "engine/base/trigonometry.h"
#include "engine/base/two.h"

namespace engine {
namespace {

constexpr double kSmallest = 1e-12;  // the first omitted term of a series
constexpr int kMostTerms = 14;
constexpr int kMostCuts = 40;        // halvings of the time
constexpr int kMostParts = 4096;     // of a step, for extremely fast bodies

/// w = R I^-1 R^T L
template <class Real>
Vec3Of<Real> spinOf(const Vec3Of<Real>& momentum, const Mat3Of<Real>& inverseInertia,
                    const QuatOf<Real>& rotation) {
    return rotation * Vec3Of<Real>(inverseInertia * Vec3Of<Real>(rotation.conjugate() * momentum));
}

/// L = R I R^T w
template <class Real>
Vec3Of<Real> momentumOf(const Vec3Of<Real>& spin, const Mat3Of<Real>& inertia,
                        const QuatOf<Real>& rotation) {
    return rotation * Vec3Of<Real>(inertia * Vec3Of<Real>(rotation.conjugate() * spin));
}

/// The terms of the power series in the elapsed share of h.
template <class Real>
class FreeTerms {
public:
    FreeTerms(const Mat3Of<Real>& inverseInertia, const Real& h, const Vec3Of<Real>& momentum,
              const QuatOf<Real>& rotation)
        : inverseInertia_(inverseInertia), h_(h) {
        m_[0] = rotation.conjugate() * momentum;
        w_[0] = h_ * (inverseInertia_ * m_[0]);
        s_[0] = rotation.w(), v_[0] = rotation.vec();
    }

    int count() const { return terms_; }
    /// The squared length of a term's quaternion.
    Real squaredSizeOf(int k) const { return s_[k] * s_[k] + v_[k].squaredNorm(); }

    void add() {
        const int k = terms_++;
        Vec3Of<Real> m = Vec3Of<Real>::Zero(), v = Vec3Of<Real>::Zero();
        Real s = 0.0;
        for (int j = 0; j <= k; ++j) {
            const Vec3Of<Real>& w = w_[k - j];
            m += m_[j].cross(w);
            s -= v_[j].dot(w);
            v += s_[j] * w + v_[j].cross(w);
        }
        s_[terms_] = Real(0.5 / terms_) * s, v_[terms_] = Real(0.5 / terms_) * v;
        m_[terms_] = Real(1.0 / terms_) * m;
        w_[terms_] = h_ * (inverseInertia_ * m_[terms_]);
    }

    /// The rotation of one body after this share, from the first `terms` terms.
    Quat sum(int terms, double share, int body) const {
        double s = partOf(s_[terms], body);
        Vec3 v = partOf(v_[terms], body);
        for (int k = terms - 1; k >= 0; --k)
            s = s * share + partOf(s_[k], body), v = v * share + partOf(v_[k], body);
        return renormalized(Quat(s, v.x(), v.y(), v.z()));
    }

private:
    std::array<Vec3Of<Real>, kMostTerms + 1> m_, w_, v_;  // of M, h W and q = (s, v)
    std::array<Real, kMostTerms + 1> s_;
    Mat3Of<Real> inverseInertia_;
    Real h_;
    int terms_ = 0;
};

/// Whether the terms after two of these squared lengths are: the next one is about size / before times the last.
bool areNegligible(double before, double size) {
    return size * size <= kSmallest * kSmallest * before;
}

/// Halves the share until the last two terms are negligible.
double shortened(const FreeTerms<double>& terms, double share) {
    const int last = terms.count();
    const double sizes[2] = {std::sqrt(terms.squaredSizeOf(last - 1)), std::sqrt(terms.squaredSizeOf(last))};
    for (int i = 0; i < kMostCuts; ++i) {
        share *= 0.5;
        double power = 1.0;
        for (int k = 1; k < last; ++k) power *= share;
        if (power * (sizes[0] + share * sizes[1]) <= kSmallest) break;
    }
    return share;
}

/// Turns by as much as the series is accurate for, up to `share`; returns how much.
double turnBy(double share, const BodyMass& mass, double h, const Vec3& momentum, Quat& rotation) {
    FreeTerms<double> terms(mass.inverseInertia, h, momentum, rotation);
    double before = 1.0, power = 1.0;
    bool enough = false;
    while (terms.count() < kMostTerms && !enough) {
        terms.add();
        power *= share * share;
        const double size = power * terms.squaredSizeOf(terms.count());
        enough = areNegligible(before, size);
        before = size;
    }
    if (!enough) share = shortened(terms, share);
    rotation = terms.sum(terms.count(), share, 0);
    return share;
}

void turnAnyBody(const Turn& t) {
    const Vec3 momentum = momentumOf<double>(*t.spin, t.mass->inertia, *t.rotation);
    if (!momentum.allFinite()) return;  // the step will be undone
    double left = 1.0;
    for (int part = 0; left > 0.0 && part < kMostParts; ++part)
        left -= turnBy(left, *t.mass, t.h, momentum, *t.rotation);
    *t.spin = spinOf<double>(momentum, t.mass->inverseInertia, *t.rotation);
}

/// The same for two; false if one of them needs more than one part.
bool turnAnyBodies(const Turn& a, const Turn& b) {
    const QuatOf<Two> rotation = sideBySide(*a.rotation, *b.rotation);
    const Vec3Of<Two> momentum = momentumOf<Two>(sideBySide(*a.spin, *b.spin),
                                                 sideBySide(a.mass->inertia, b.mass->inertia), rotation);
    if (!partOf(momentum, 0).allFinite() || !partOf(momentum, 1).allFinite()) return false;
    const Mat3Of<Two> inverse = sideBySide(a.mass->inverseInertia, b.mass->inverseInertia);
    FreeTerms<Two> terms(inverse, Two(a.h, b.h), momentum, rotation);
    double before[2] = {1.0, 1.0};
    int enough[2] = {0, 0};
    while (enough[0] == 0 || enough[1] == 0) {
        if (terms.count() == kMostTerms) return false;
        terms.add();
        const Two size = terms.squaredSizeOf(terms.count());
        for (int i = 0; i < 2; ++i) {
            if (enough[i] == 0 && areNegligible(before[i], size[i])) enough[i] = terms.count();
            before[i] = size[i];
        }
    }
    *a.rotation = terms.sum(enough[0], 1.0, 0);
    *b.rotation = terms.sum(enough[1], 1.0, 1);
    const Vec3Of<Two> spin = spinOf<Two>(momentum, inverse, sideBySide(*a.rotation, *b.rotation));
    *a.spin = partOf(spin, 0), *b.spin = partOf(spin, 1);
    return true;
}

constexpr double kSeries = 1e-2;  // x^2: below, the omitted terms are smaller than 1e-16

/// (cos(x), sin(x) / x half), x = |half|: the rotation by 2 half.
template <class Real>
[[gnu::always_inline]] inline QuatOf<Real> smallTurn(const Vec3Of<Real>& half, const Real& x2) {
    // 1 - x^2 / 3! + x^4 / 5! - ... and 1 - x^2 / 2! + x^4 / 4! - ...
    constexpr double kFactors[4][2] = {{-1.0 / 5040.0, -1.0 / 720.0},
                                       {1.0 / 120.0, 1.0 / 24.0},
                                       {-1.0 / 6.0, -1.0 / 2.0},
                                       {1.0, 1.0}};
    Real s = 1.0 / 362880.0, c = 1.0 / 40320.0;
    for (const double (&factors)[2] : kFactors) s = s * x2 + Real(factors[0]), c = c * x2 + Real(factors[1]);
    return QuatOf<Real>(c, s * half.x(), s * half.y(), s * half.z());
}

Quat turnOf(const Vec3& turn) {
    const Vec3 half = 0.5 * turn;
    const double x2 = half.squaredNorm();
    if (!(x2 >= kSeries && x2 < 1e200)) return smallTurn<double>(half, x2);  // or NaN
    const double x = std::sqrt(x2), s = sine(x) / x;
    return {cosine(x), s * half.x(), s * half.y(), s * half.z()};
}

[[gnu::always_inline]] inline QuatOf<Two> turnOf(const Vec3Of<Two>& turn) {
    const Vec3Of<Two> half = Two(0.5) * turn;
    const Two x2 = half.squaredNorm();
    if (x2[0] < kSeries && x2[1] < kSeries) return smallTurn<Two>(half, x2);
    return sideBySide(turnOf(partOf(turn, 0)), turnOf(partOf(turn, 1)));
}

Vec3 topAxisOf(const BodyMass& mass) { return Vec3::Unit(mass.topAxis); }
/// 1 - c / a
double topFactorOf(const BodyMass& mass) {
    const int other = (mass.topAxis + 1) % 3;
    return 1.0 - mass.inertia(mass.topAxis, mass.topAxis) / mass.inertia(other, other);
}

template <class Real>
void turnTop(const Vec3Of<Real>& axis, const Real& factor, const Real& h, QuatOf<Real>& rotation,
             Vec3Of<Real>& spin) {
    const Vec3Of<Real> before = rotation * axis;
    const Real own = factor * before.dot(spin);
    const Vec3Of<Real> precession = spin - own * before;
    rotation = renormalized<Real>(turnOf(Vec3Of<Real>(h * precession)) *
                                  (turnOf(Vec3Of<Real>(h * own * before)) * rotation));
    spin = precession + own * (rotation * axis);
}

void turnOne(const Turn& t) {
    if (t.mass->isRound)  // L and w are parallel: w is constant
        *t.rotation = turnedBy(Vec3(t.h * *t.spin), *t.rotation);
    else if (t.mass->topAxis >= 0)
        turnTop<double>(topAxisOf(*t.mass), topFactorOf(*t.mass), t.h, *t.rotation, *t.spin);
    else
        turnAnyBody(t);
}

}  // namespace

void turnTwo(const Turn& a, const Turn& b) {
    if (!a.mass->isRound && a.mass->topAxis < 0) {
        if (!turnAnyBodies(a, b)) turnOne(a), turnOne(b);
        return;
    }
    const Two h(a.h, b.h);
    QuatOf<Two> rotation = sideBySide(*a.rotation, *b.rotation);
    Vec3Of<Two> spin = sideBySide(*a.spin, *b.spin);
    if (a.mass->isRound)
        rotation = renormalized<Two>(turnOf(Vec3Of<Two>(h * spin)) * rotation);
    else
        turnTop<Two>(sideBySide(topAxisOf(*a.mass), topAxisOf(*b.mass)),
                     Two(topFactorOf(*a.mass), topFactorOf(*b.mass)), h, rotation, spin);
    *a.rotation = partOf(rotation, 0), *b.rotation = partOf(rotation, 1);
    *a.spin = partOf(spin, 0), *b.spin = partOf(spin, 1);
}

Quat turnedBy(const Vec3& turn, const Quat& q) { return renormalized<double>(turnOf(turn) * q); }

Vec3 spinAfterGyroscopicTorque(const BodyMass& mass, const Quat& rotation, const Vec3& spin,
                               double h) {
    // f(w) = I (w - w0) + h w x I w, from w = w0:  J = I + h ([w]x I - [I w]x),  w -= J^-1 f
    const Vec3 w = rotation.conjugate() * spin;
    const Vec3 momentum = mass.inertia * w;
    const Vec3 f = h * w.cross(momentum);
    const Mat3 jacobian =
        mass.inertia + h * (crossMatrix(w) * mass.inertia - crossMatrix(momentum));
    return rotation * Vec3(w - jacobian.inverse() * f);
}

void turnKeepingMomentum(const BodyMass& mass, double h, Quat& rotation, Vec3& spin) {
    turnOne({&mass, h, &rotation, &spin});
}

}  // namespace engine
