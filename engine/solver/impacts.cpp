#include "engine/solver/impacts.h"

namespace engine {
namespace {

/// A blow goes back and forth through n balls in n passes; what is left then is for the sweeps.
constexpr int kPasses = 64;

/// True when this contact bounced.
bool bounce(ContactConstraint& c, Velocity& a, Velocity& b, double threshold, double h) {
    Vec4 q = Vec4::Zero();
    bool any = false;
    for (int i = 0; i < c.count; ++i) {
        const ContactRow& row = c.rows[i];
        const double approach = c.n.dot(velocityBetween(row, a, b));
        const bool hits = approach < -threshold && row.separation + h * approach <= 0.0;
        any = any || hits;
        // w = K lambda + q >= 0 is J v2 >= -e J v1 where it hits, and 'no faster' elsewhere.
        q[i] = hits ? (1.0 + c.restitution) * approach : larger(approach, 0.0);
    }
    if (!any) return false;
    const Vec4 lambda = solveNormalBlock(c.block, q);
    for (int i = 0; i < c.count; ++i) {
        c.rows[i].bounce += lambda[i];
        applyAt(c, c.rows[i], lambda[i] * c.n, a, b);
    }
    return true;
}

}  // namespace

void solveImpacts(Constraints& c, std::span<Velocity> v, const Settings& settings, double h) {
    const double threshold = settings.bounceSpeed;
    for (int pass = 0; pass < kPasses; ++pass) {
        bool any = false;
        for (ContactConstraint& contact : c.contacts)
            if (contact.restitution > 0.0)
                any = bounce(contact, v[contact.a], v[contact.b], threshold, h) || any;
        if (!any) return;
    }
}

}  // namespace engine
