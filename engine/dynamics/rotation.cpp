#include "engine/dynamics/rotation.h"

#include <Eigen/LU>
#include <array>

#include "engine/base/trigonometry.h"

namespace engine {
namespace {

constexpr double kSmallest = 1e-12;  // the first omitted term of a series
constexpr int kMostTerms = 14;
constexpr int kMostCuts = 40;        // halvings of the time
constexpr int kMostParts = 4096;     // of a step, for extremely fast bodies

/// w = R I^-1 R^T L
Vec3 spinOf(const Vec3& momentum, const BodyMass& mass, const Quat& rotation) {
    return rotation * Vec3(mass.inverseInertia * Vec3(rotation.conjugate() * momentum));
}

/// The rotation as a power series in the elapsed share of h.
class FreeTurn {
public:
    /// Computes as many terms as are needed up to `share`.
    FreeTurn(const BodyMass& mass, double h, const Vec3& momentum, const Quat& rotation,
             double share)
        : share_(share) {
        m_[0] = rotation.conjugate() * momentum;
        w_[0] = h * (mass.inverseInertia * m_[0]);
        s_[0] = rotation.w(), v_[0] = rotation.vec();
        double before = 1.0, power = 1.0;
        while (terms_ < kMostTerms) {
            addTerm();
            m_[terms_] *= 1.0 / terms_;
            w_[terms_] = h * (mass.inverseInertia * m_[terms_]);
            power *= share;
            const double size = power * sizeOf(terms_);
            if (size * size <= kSmallest * before) return;  // so is the next term
            before = size;
        }
        cut();
    }

    /// How far the series is accurate: `share`, or less.
    double share() const { return share_; }

    Quat atEnd() const {
        double s = s_[terms_];
        Vec3 v = v_[terms_];
        for (int k = terms_ - 1; k >= 0; --k) s = s * share_ + s_[k], v = v * share_ + v_[k];
        Quat q(s, v.x(), v.y(), v.z());
        q.normalize();
        return q;
    }

private:
    double sizeOf(int k) const { return std::sqrt(s_[k] * s_[k] + v_[k].squaredNorm()); }

    void addTerm() {
        const int k = terms_++;
        Vec3 m = Vec3::Zero(), v = Vec3::Zero();
        double s = 0.0;
        for (int j = 0; j <= k; ++j) {
            const Vec3& w = w_[k - j];
            m += m_[j].cross(w);
            s -= v_[j].dot(w);
            v += s_[j] * w + v_[j].cross(w);
        }
        m_[terms_] = m;
        s_[terms_] = 0.5 / terms_ * s, v_[terms_] = 0.5 / terms_ * v;
    }

    /// Halves the time until the last two terms are negligible.
    void cut() {
        const double last = sizeOf(terms_), before = sizeOf(terms_ - 1);
        for (int i = 0; i < kMostCuts; ++i) {
            share_ *= 0.5;
            double power = 1.0;
            for (int k = 1; k < terms_; ++k) power *= share_;
            if (power * (before + share_ * last) <= kSmallest) return;
        }
    }

    std::array<Vec3, kMostTerms + 1> m_, w_, v_;  // of M, h W and q = (s, v)
    std::array<double, kMostTerms + 1> s_;
    int terms_ = 0;
    double share_;
};

void turnTop(const BodyMass& mass, double h, Quat& rotation, Vec3& spin) {
    const Vec3 axis = Vec3::Unit(mass.topAxis);
    const double about = mass.inertia(mass.topAxis, mass.topAxis);
    const int other = (mass.topAxis + 1) % 3;
    const Vec3 before = rotation * axis;
    const double own = (1.0 - about / mass.inertia(other, other)) * before.dot(spin);
    const Vec3 precession = spin - own * before;
    rotation = turnedBy(h * precession, turnedBy(h * own * before, rotation));
    spin = precession + own * (rotation * axis);
}

}  // namespace

Quat turnedBy(const Vec3& turn, const Quat& q) {
    const Vec3 half = 0.5 * turn;
    const double x2 = half.squaredNorm();
    double cosineOfHalf, sineOverHalf;
    if (!(x2 >= 1e-2 && x2 < 1e200)) {  // omitted terms are below 1e-16; or NaN
        // 1 - x^2 / 6 (1 - x^2 / 20 (1 - ...)) and 1 - x^2 / 2 (1 - x^2 / 12 (1 - ...)) side by side
        constexpr double kDivisors[4][2] = {{72.0, 56.0}, {42.0, 30.0}, {20.0, 12.0}, {6.0, 2.0}};
        double sums[2] = {1.0, 1.0};
        for (const double (&divisors)[2] : kDivisors)
            for (int i = 0; i < 2; ++i) sums[i] = 1.0 - x2 / divisors[i] * sums[i];
        sineOverHalf = sums[0], cosineOfHalf = sums[1];
    } else {
        const double x = std::sqrt(x2);
        sineOverHalf = sine(x) / x;
        cosineOfHalf = cosine(x);
    }
    const Vec3 v = sineOverHalf * half;
    Quat turned = Quat(cosineOfHalf, v.x(), v.y(), v.z()) * q;
    turned.normalize();
    return turned;
}

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
    if (mass.isRound) {  // L and w are parallel: w is constant
        rotation = turnedBy(h * spin, rotation);
        return;
    }
    if (mass.topAxis >= 0) return turnTop(mass, h, rotation, spin);
    const Vec3 momentum = rotation * Vec3(mass.inertia * Vec3(rotation.conjugate() * spin));
    if (!momentum.allFinite()) return;  // the step will be undone
    double left = 1.0;
    for (int part = 0; left > 0.0 && part < kMostParts; ++part) {
        const FreeTurn turn(mass, h, momentum, rotation, left);
        rotation = turn.atEnd();
        left -= turn.share();
    }
    spin = spinOf(momentum, mass, rotation);
}

}  // namespace engine
