/// A convex polyhedron.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "engine/base/math.h"
#include "engine/shapes/corner_lanes.h"
#include "engine/shapes/face_lanes.h"

namespace engine {

struct Hull {
    struct Face {
        Vec3 normal;               // unit, outwards
        double offset = 0.0;       // m: normal . x <= offset inside
        std::vector<int> corners;  // counter-clockwise from outside
    };
    std::vector<Vec3> corners;  // m
    std::vector<Face> faces;
    CornerLanes cornerLanes;  // both only in a Shape
    FaceLanes faceLanes;
};

/// Whether points are flat to a ten-thousandth of their extent. At least one point, all finite.
bool isFlat(std::span<const Vec3> points);

/// Uses Qhull; faces in one plane are merged. Null if the points are flat (shape.h).
std::optional<Hull> convexHull(std::span<const Vec3> points);

}  // namespace engine
