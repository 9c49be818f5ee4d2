/// How much a shape weighs and how it resists being turned.
#pragma once
#include "engine/base/math.h"
#include "engine/shape.h"

namespace engine {

/// m^3; 0 for a plane.
double volume(const Shape& shape);

/// kg m^2 about the centre of mass, in body axes, of a homogeneous body.
///   sphere   2/5 m r^2
///   box      m/12 (b^2 + c^2) about the edge a
///   capsule  a cylinder and two half spheres, whose centroids lie 3/8 r beyond its ends
Mat3 inertiaOf(const Shape& shape, double mass);

/// I_world = R I_body R^T. Computed so that it stays symmetric to the bit.
Mat3 inWorldAxes(const Mat3& inertiaBody, const Quat& rotation);

}  // namespace engine
