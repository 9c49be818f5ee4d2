/// How much of a body lies below a level, and where the middle of that is.
///   ball     a cap of depth d:  V = pi d^2 (3 r - d) / 3,
///            its middle 3 (2 r - d)^2 / (4 (3 r - d)) below the ball's
///   box      tetrahedra from a point of the surface to what lies below of each face: the cut
///            itself holds that point, so that it adds nothing
///   capsule  nine balls in a row that share its volume: exact when all of it is below
#pragma once
#include "engine/base/math.h"
#include "engine/shape.h"

namespace engine {

struct SubmergedPart {
    double volume = 0.0;          // m^3
    Vec3 centre = Vec3::Zero();   // m, world axes
};

/// Below: x . up < level. `up`: unit. `level`: m; infinity: all of it is below.
SubmergedPart submergedPart(const Shape& shape, const Pose& pose, const Vec3& up, double level);

}  // namespace engine
