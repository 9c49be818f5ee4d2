/// The picture itself: solids, rods, grounds, sky and trails, several samples a pixel.
#pragma once
#include "render/camera.h"
#include "render/shadow_pass.h"

namespace render {

class ScenePass {
public:
    ScenePass(int width, int height, int samples);
    void draw(const Frame& frame, const View& view, const ShadowPass& shadow,
              const InstancedMesh& boxes, const InstancedMesh& balls, const InstancedMesh& bars);

    GLuint framebuffer() const { return resolved_; }
    GLuint color() const { return color_; }  // sRGB, one sample a pixel
    GLuint depth() const { return depth_; }

private:
    void useLit(const GlProgram& program, const Frame& frame, const View& view,
                const ShadowPass& shadow) const;
    void drawGrounds(const Frame& frame, const View& view, const ShadowPass& shadow);
    void drawSky(const Frame& frame, const View& view);
    void drawTrails(const Frame& frame, const View& view);
    void resolve();

    int width_, height_;
    GlRenderbuffer samplesColor_, samplesDepth_;
    GlFramebuffer samples_;
    GlTexture color_, depth_;
    GlFramebuffer resolved_;
    GlProgram box_, round_, ground_, sky_, trail_;
    GlArray empty_, trailArray_;
    GlBuffer trailBuffer_;
};

}  // namespace render
