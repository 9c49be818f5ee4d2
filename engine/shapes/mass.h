/// Mass and inertia of shapes.
#pragma once
#include "engine/base/math.h"
#include "engine/shape.h"

namespace engine {

/// m^3; 0 for a plane and a mesh.
double volume(const Shape& shape);

/// kg; `density` (kg/m^3) is that of a homogeneous body, or of a compound's parts with density 1.
double massOf(const Shape& shape, double density);

/// kg m^2 about the centre of mass, in body axes, for a homogeneous body, or a compound's parts
/// with their densities.
///   sphere    2/5 m r^2
///   box       m/12 (b^2 + c^2) about the edge a
///   capsule   a cylinder and two half spheres with centroids 3/8 r beyond its ends
///   cylinder  m/2 r^2 about its axis, m/12 (3 r^2 + h^2) across
///   cone      3/10 m r^2 about its axis, m/80 (12 r^2 + 3 h^2) across
///   others    I = tr(S) 1 - S with the second moments S = rho int x x^T dV
Mat3 inertiaOf(const Shape& shape, double mass);

/// Whether a rigid body can have this inertia (kg m^2): it is symmetric, and its second moments
///   S = tr(I)/2 1 - I
/// belong to nonnegative masses, S >= 0 except for rounding. (So no principal moment is larger than
/// the sum of the others.)
bool isInertia(const Mat3& inertia);

/// int dV (m^3), int x dV (m^4), int x x^T dV (m^5). A hull as the sum of tetrahedra (0, a, b, c):
///   V = a.(b x c) / 6,   V (a + b + c) / 4,   V/20 (a a^T + b b^T + c c^T + s s^T), s = a + b + c
/// Parts are weighted by their density.
struct VolumeIntegrals {
    double volume = 0.0;
    Vec3 first = Vec3::Zero();
    Mat3 second = Mat3::Zero();
};
VolumeIntegrals integralsOf(const Hull& hull);
VolumeIntegrals integralsOf(std::span<const ShapePart> parts);

/// I_world = R I_body R^T. The result is symmetric to the bit.
Mat3 inWorldAxes(const Mat3& inertiaBody, const Quat& rotation);

}  // namespace engine
