/// The volume of a body below a level, and its centroid.
///   ball     a cap of depth d:  V = pi d^2 (3 r - d) / 3,
///            its centroid 3 (2 r - d)^2 / (4 (3 r - d)) below the centre
///   box      tetrahedra from a point of the surface to the submerged part of each face: the cut
///            itself contains that point, so it adds nothing
///   capsule  nine balls in a row that share its volume: exact when all of it is below
#pragma once
#include "engine/base/math.h"
#include "engine/shape.h"

namespace engine {

struct SubmergedPart {
    double volume = 0.0;          // m^3
    Vec3 centre = Vec3::Zero();   // m, world axes
};

/// Below means x . up < level. `up`: unit. `level`: m; infinity: the whole body is below.
SubmergedPart submergedPart(const Shape& shape, const Pose& pose, const Vec3& up, double level);

}  // namespace engine
