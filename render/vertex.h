/// What is sent to the driver: corners of triangles, and the bodies that are drawn with them.
#pragma once
#include "render/frame.h"

namespace render {

/// A corner: position on the unit shape, normal, which end of a stretched shape it belongs to, and
/// the face (surface_map.h).
struct Vertex {
    Vec3 position, normal;
    float end;  // -1, 0, 1: moved by the instance's `stretch` along its y
    float face;
};

/// A corner of a solid with faces of any outline. Its triangle lies along up to three edges; over
/// one that is not seen the normal beyond is the own one.
struct FacetVertex {
    Vec3 position, normal;
    float face;
    Vec3 toEdges;           // lengths of `along`
    Vec3 beyond[3];         // the normals on the other side of the edges
    Eigen::Vector2f along;  // the way to the edges: across the y axis, and along it; before scaling
    float apothem;          // lengths of `along`, from the face's middle to an edge
};

/// world = position + rotation * (vertex.position * scale + (0, end * stretch, 0))
struct Instance {
    Vec3 position;
    Eigen::Vector4f rotation;  // quaternion x, y, z, w
    Vec3 scale;                // m
    float stretch;             // m
    Vec3 color;                // linear
    float surface;             // its number (surface_map.h); whole, below 2^19
};

}  // namespace render
