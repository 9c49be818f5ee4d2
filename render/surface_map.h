/// The number and face of the surface seen at every pixel's centre.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/frame.h"

namespace render {

inline constexpr int kNoSurface = -1;  // the sky
inline constexpr int kFaceBits = 12;  // as in number.glsl; surfaces are below 2^19
inline constexpr int kFaces = 1 << kFaceBits;  // with distinct numbers

/// Faces of a box: 0..5 for -x +x -y +y -z +z; of a cylinder or cone: 2 and 3 as for a box, 0 the
/// side; of a mesh: its facet, modulo kFaces; of other surfaces: 0.
inline std::int32_t packedSurface(int surface, int face) {
    return (surface << kFaceBits) + (face & (kFaces - 1));
}
inline int surfaceIn(std::int32_t packed) { return packed >> kFaceBits; }  // kNoSurface: the sky
inline int faceIn(std::int32_t packed) { return packed & (kFaces - 1); }  // 0 to kFaces - 1

/// Made by Renderer::surfaces.
struct SurfaceMap {
    int width = 0, height = 0;  // pixels
    std::vector<std::int32_t> packed;  // row 0 on top; kNoSurface: the sky
    int surface(int x, int y) const { return surfaceIn(at(x, y)); }  // kNoSurface: the sky
    int face(int x, int y) const { return faceIn(at(x, y)); }        // as in packedSurface()
    /// Both in one number; x and y must be inside.
    std::int32_t at(int x, int y) const { return packed[static_cast<std::size_t>(y) * width + x]; }
};

/// The surfaces of a frame are numbered consecutively: solids, then rods, then grounds.
inline int surfaceOfRod(const Frame& frame, std::size_t rod) {
    return static_cast<int>(frame.solids.size() + rod);
}
/// The number of a frame's ground.
inline int surfaceOfGround(const Frame& frame, std::size_t ground) {
    return static_cast<int>(frame.solids.size() + frame.rods.size() + ground);
}

}  // namespace render
