/// What a body occupies. Every shape is centred on the body's centre of mass.
#pragma once
#include "engine/base/math.h"

namespace engine {

/// The plane bounds a half space, the others are bodies: sphere, box, capsule.
enum class ShapeType { sphere, box, capsule, plane };

/// Made by one of the functions below, which stop the program where a size is not positive.
struct Shape {
    ShapeType type = ShapeType::sphere;
    double radius = 0.5;                  // m; sphere, capsule
    double halfLength = 0.0;              // m; capsule: half its core segment, along the local y
    Vec3 halfSize{0.5, 0.5, 0.5};         // m; box: half edges
    Vec3 normal{0, 1, 0};                 // plane: unit, out of the solid half space, which ends
                                          // at the body's position; static bodies only

    /// `radius`: m.
    static Shape sphere(double radius);
    /// `size`: the full edges, m.
    static Shape box(const Vec3& size);
    /// `height`: from tip to tip, m; at least twice the radius.
    static Shape capsule(double radius, double height);
    /// `normal`: any length but zero.
    static Shape plane(const Vec3& normal);
};

}  // namespace engine
