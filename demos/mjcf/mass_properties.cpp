#include "demos/mjcf/mass_properties.h"

#include "engine/shapes/mass.h"

namespace demos::mjcf {

MassProperties placed(const MassProperties& piece, const Pose& pose) {
    return {piece.mass, pose.toWorld(piece.centre),
            engine::inWorldAxes(piece.inertia, pose.rotation)};
}

MassProperties together(std::span<const MassProperties> pieces) {
    MassProperties whole;
    for (const MassProperties& piece : pieces) {
        whole.mass += piece.mass;
        whole.centre += piece.mass * piece.centre;
    }
    if (whole.mass > 0.0) whole.centre /= whole.mass;
    for (const MassProperties& piece : pieces) {
        const Vec3 d = piece.centre - whole.centre;
        whole.inertia +=
            piece.inertia + piece.mass * (d.squaredNorm() * Mat3::Identity() - d * d.transpose());
    }
    return whole;
}

bool isMovable(const MassProperties& whole) {
    constexpr double kLeastMass = 1e-9, kLeastInertia = 1e-15, kFlattest = 1e-9;
    const Mat3& i = whole.inertia;
    const double trace = i.trace(), volume = i.determinant();
    const double second = i(0, 0) * i(1, 1) - i(0, 1) * i(1, 0);
    return whole.mass >= kLeastMass && trace >= kLeastInertia && i(0, 0) > 0.0 && second > 0.0 &&
           volume >= kFlattest * trace * trace * trace;
}

}  // namespace demos::mjcf
