/// The number of the surface seen at every pixel's centre, and of a box the face.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/frame.h"

namespace render {

inline constexpr int kNoSurface = -1;  // the sky

/// Made by Renderer::surfaces.
struct SurfaceMap {
    int width = 0, height = 0;  // pixels
    std::vector<std::int32_t> packed;  // row 0 on top; 8 * surface + face, negative: the sky
    int surface(int x, int y) const { return at(x, y) >> 3; }  // kNoSurface: the sky
    int face(int x, int y) const { return at(x, y) & 7; }      // of a box: -x +x -y +y -z +z
    /// Both in one number; x and y have to be inside.
    std::int32_t at(int x, int y) const { return packed[static_cast<std::size_t>(y) * width + x]; }
};

/// Surfaces of a frame are numbered through: solids, then rods, then grounds.
inline int surfaceOfRod(const Frame& frame, std::size_t rod) {
    return static_cast<int>(frame.solids.size() + rod);
}
/// The number of a frame's ground.
inline int surfaceOfGround(const Frame& frame, std::size_t ground) {
    return static_cast<int>(frame.solids.size() + frame.rods.size() + ground);
}

}  // namespace render
