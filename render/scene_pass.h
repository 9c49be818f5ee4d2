/// The picture itself: solids, rods, grounds, sky and trails, several samples a pixel.
#pragma once
#include <map>
#include <string>

#include "render/depth_pass.h"
#include "render/shadow_pass.h"

namespace render {

/// What lights a picture.
struct Lights {
    const ShadowPass* sun = nullptr;  // null: nothing casts shadows
    bool soft = true;                 // the shadows' edges
    GLuint openMap = 0;               // how much of the sky a point sees; 0: all of it
};

class ScenePass {
public:
    ScenePass(int width, int height, int samples);
    /// `bodies`: where solids, rods and trails are; everywhere else one sample a pixel will do.
    void draw(const Frame& frame, const View& view, const Lights& lights, const PixelRect& bodies,
              const Meshes& meshes, const GroundMesh& ground);
    /// One sample a pixel in framebuffer(), when draw() is done.
    void resolve(const PixelRect& bodies) const;

    GLuint framebuffer() const { return resolved_; }

private:
    /// One drawing, as all its parts need it.
    struct Scene {
        const Frame& frame;
        const View& view;
        const Lights& lights;
    };
    GLuint lit(const std::string& vertex, const std::string& fragment, const std::string& features,
               const Scene& scene);
    void drawBodies(const Scene& scene, const Meshes& meshes);
    void drawBackground(const Scene& scene, const GroundMesh& mesh);
    void drawGrounds(const Scene& scene, const GroundMesh& mesh);
    void drawGround(const Scene& scene, const Ground& ground, const GroundCorners& corners,
                    const std::vector<Vec3>& part, const std::string& features,
                    const GroundMesh& mesh);
    void drawSky(const Scene& scene);
    void drawTrails(const Scene& scene);

    int width_, height_, samples_;
    GlRenderbuffer samplesColor_, samplesDepth_;
    GlFramebuffer samplesBuffer_;
    GlTexture color_, depth_;
    GlFramebuffer resolved_;
    std::map<std::string, GlProgram> programs_;  // by fragment shader and features, made when used
    GlProgram sky_, trail_;
    GlArray empty_, trailArray_;
    GlBuffer trailBuffer_;
};

}  // namespace render
