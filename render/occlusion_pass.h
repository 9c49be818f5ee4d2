/// Ambient occlusion: corners and the ground beneath things are darker. Found at half the size from
/// the depths, averaged over its sampling pattern, and multiplied into the picture.
#pragma once
#include "render/camera.h"
#include "render/gl.h"

namespace render {

class OcclusionPass {
public:
    OcclusionPass(int width, int height);
    /// Draws the darkened picture; read it from framebuffer().
    void draw(const Frame& frame, const View& view, GLuint color, GLuint depth);
    GLuint framebuffer() const { return composed_; }

private:
    /// A texture of its own and the program that fills it.
    struct Stage {
        GlTexture result;
        GlFramebuffer framebuffer;
        GlProgram program;

        Stage(GLenum format, int width, int height, const std::string& shader);
        void use(int width, int height) const;
    };

    int width_, height_, halfWidth_, halfHeight_;
    Stage depth_, open_, blurred_;
    GlTexture result_;
    GlFramebuffer composed_;
    GlProgram compose_;
    GlArray empty_;
};

}  // namespace render
