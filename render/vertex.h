/// The data sent to the driver: corners of triangles, and the instances drawn with them.
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

/// A corner of a solid whose faces have any outline. Its triangle touches up to three edges; across
/// one that is not drawn, the normal beyond equals its own.
struct FacetVertex {
    Vec3 position, normal;
    float face;
    Vec3 toEdges;           // lengths of `along`
    Vec3 beyond[3];         // the normals on the other side of the edges
    Eigen::Vector2f along;  // direction to the edges, across and along the y axis; before scaling
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
    Material material;         // chooses the program; no attribute
};

}  // namespace render
