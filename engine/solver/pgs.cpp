#include "engine/solver/pgs.h"

namespace engine {

template <class Real>
Pgs<Real>::Pgs(GlobalRows<Real>& rows, int bodies) : g_(rows), accelerations_(bodies) {
    addAlongRows<Real>(g_, g_.force, accelerations_);
}

template <class Real>
SweepReport Pgs<Real>::sweep() {
    const auto residual = [this](int i) {
        const GlobalRow<Real>& row = g_.rows[i];
        return g_.wanted[i] -
               velocityAlong(row.row.j, accelerations_[row.a], accelerations_[row.b]);
    };
    const auto moved = [this](int i, Real change) {
        const GlobalRow<Real>& row = g_.rows[i];
        apply(row.row, change, accelerations_[row.a], accelerations_[row.b]);
    };
    return sweepRows(g_, residual, moved);
}

template class Pgs<float>;
template class Pgs<double>;

}  // namespace engine
