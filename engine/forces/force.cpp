#include "engine/forces/force.h"

#include <algorithm>

#include "engine/dynamics/bodies.h"

namespace engine {

bool acts(const ForceDef& force, double time, double h) {
    const double middle = time + 0.5 * h;
    return force.from <= middle && middle < force.until;
}

bool linksBodies(const ForceDef& force) {
    return std::holds_alternative<NBodyGravity>(force.kind) || std::holds_alternative<SpringForce>(force.kind);
}

void addLoads(const ForceDef& force, const Bodies& bodies, ForceMoment now, std::span<Load> loads) {
    const auto add = [&](std::span<const BodyId> on, int body) {
        now.h = bodies.spans[body];
        if (!bodies.isActing(body) || !acts(force, now.time, now.h)) return;
        std::visit([&](const auto& kind) { addLoads(kind, on, bodies, now, loads); }, force.kind);
    };
    if (!linksBodies(force)) {
        for (const BodyId& id : force.on) add(std::span(&id, 1), id.index);
        return;
    }
    const auto moves = [&](const BodyId& id) { return bodies.isAwake(id.index); };
    const auto first = std::ranges::find_if(force.on, moves);
    if (first != force.on.end()) add(force.on, first->index);
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
