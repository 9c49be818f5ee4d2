#include "engine/forces/force.h"

#include "engine/dynamics/bodies.h"

namespace engine {

bool acts(const ForceDef& force, double time, double h) {
    const double middle = time + 0.5 * h;
    return force.from <= middle && middle < force.until;
}

void addLoads(const ForceDef& force, const Bodies& bodies, const ForceMoment& now,
              std::span<Load> loads) {
    std::visit([&](const auto& kind) { addLoads(kind, force.on, bodies, now, loads); },
               force.kind);
}

void addPotential(const ForceDef& force, const Bodies& bodies, Energy& energy) {
    if (const auto* point = std::get_if<PointGravity>(&force.kind))
        energy.potential += potentialOf(*point, force.on, bodies);
    if (const auto* nBody = std::get_if<NBodyGravity>(&force.kind))
        energy.potential += potentialOf(*nBody, force.on, bodies);
    if (const auto* spring = std::get_if<SpringForce>(&force.kind))
        energy.elastic += potentialOf(*spring, force.on, bodies);
}

}  // namespace engine
