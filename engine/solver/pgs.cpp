#include "engine/solver/pgs.h"

namespace engine {

Pgs::Pgs(GlobalRows& rows, int bodies) : g_(rows), accelerations_(bodies) {
    addAlongRows(g_, g_.force, accelerations_);
}

SweepReport Pgs::sweep() {
    const auto residual = [this](int i) {
        const GlobalRow& row = g_.rows[i];
        return g_.wanted[i] -
               velocityAlong(row.row.j, accelerations_[row.a], accelerations_[row.b]);
    };
    const auto moved = [this](int i, double change) {
        const GlobalRow& row = g_.rows[i];
        apply(row.row, change, accelerations_[row.a], accelerations_[row.b]);
    };
    return sweepRows(g_, residual, moved);
}

}  // namespace engine
