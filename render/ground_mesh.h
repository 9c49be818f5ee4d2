/// Triangles that are uploaded for every frame.
#pragma once
#include <vector>

#include "render/gl.h"
#include "render/ground_corners.h"

namespace render {

class GroundMesh {
public:
    GroundMesh();
    void draw(const std::vector<Vec3>& corners) const;

private:
    GlArray array_;
    GlBuffer buffer_;
};

}  // namespace render
