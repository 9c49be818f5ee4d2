#include "render/seen_surfaces.h"

#include "render/instances.h"
#include "render/surface_map.h"

namespace render {

SeenSurfaces::SeenSurfaces(const Frame& frame, const View& view, int width, int height)
    : surfaces_(surfacesOf(frame)), sight_(sightOf(view, width, height)), seen_(surfaces_.size()) {
    for (std::size_t i = 0; i < frame.rods.size(); ++i) {
        Vec3d& half = surfaces_[static_cast<std::size_t>(surfaceOfRod(frame, i))].half;
        const float radius = drawnRadius(frame.rods[i], view.eye, pixelsAMeter(view, height));
        half.x() = half.z() = static_cast<double>(radius);
    }
}

const SeenSurface& SeenSurfaces::operator[](int surface) {
    std::optional<SeenSurface>& one = seen_[static_cast<std::size_t>(surface)];
    if (!one) one.emplace(surfaces_[static_cast<std::size_t>(surface)], sight_);
    return *one;
}

}  // namespace render
