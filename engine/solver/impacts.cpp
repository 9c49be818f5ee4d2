#include "engine/solver/impacts.h"

namespace engine {
namespace {

/// A blow goes back and forth through n balls in n passes; what is left then is for the sweeps.
constexpr int kPasses = 64;

/// True when this contact bounced.
template <class Real>
bool bounce(ContactConstraint<Real>& c, Velocity<Real>& a, Velocity<Real>& b, Real threshold,
            Real h) {
    Vec4T<Real> q = Vec4T<Real>::Zero();
    bool any = false;
    for (int i = 0; i < c.count; ++i) {
        const ContactRow<Real>& row = c.rows[i];
        const Real approach = c.n.dot(velocityBetween(row, a, b));
        const bool hits = approach < -threshold && row.separation + h * approach <= Real(0);
        any = any || hits;
        // w = K lambda + q >= 0 is J v2 >= -e J v1 where it hits, and 'no faster' elsewhere.
        q[i] = hits ? (Real(1) + c.restitution) * approach : larger(approach, Real(0));
    }
    if (!any) return false;
    const Vec4T<Real> lambda = solveNormalBlock(c.block, q);
    for (int i = 0; i < c.count; ++i) {
        c.rows[i].bounce += lambda[i];
        applyAt<Real>(c, c.rows[i], lambda[i] * c.n, a, b);
    }
    return true;
}

}  // namespace

template <class Real>
void solveImpacts(Constraints<Real>& c, std::span<Velocity<Real>> v, const Settings& settings,
                  Real h) {
    const Real threshold = static_cast<Real>(settings.bounceSpeed);
    for (int pass = 0; pass < kPasses; ++pass) {
        bool any = false;
        for (ContactConstraint<Real>& contact : c.contacts)
            if (contact.restitution > Real(0))
                any = bounce(contact, v[contact.a], v[contact.b], threshold, h) || any;
        if (!any) return;
    }
}

template void solveImpacts(Constraints<float>&, std::span<Velocity<float>>, const Settings&,
                           float);
template void solveImpacts(Constraints<double>&, std::span<Velocity<double>>, const Settings&,
                           double);

}  // namespace engine
