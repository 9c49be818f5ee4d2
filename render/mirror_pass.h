/// The image of the bodies in a floor that is a little glossy.
#pragma once
#include "render/gl.h"
#include "render/pixel_rect.h"

namespace render {

/// At half the picture's size. The higher above the floor, the fainter (mirrored.glsl) and the more
/// blurred.
class MirrorPass {
public:
    /// `width`, `height`: of the picture.
    MirrorPass(int width, int height);
    /// To be drawn into from now on; `floor`: what leaves the floor where it shows no body, linear.
    void begin(const Vec3& floor);
    /// Makes this part of the picture from what was drawn: square roots of linear values.
    void blur(const PixelRect& part);
    /// Pixels of a picture of this height, by which blurred bodies are larger.
    static int reach(int height);
    GLuint picture() const { return blurred_; }

private:
    int width_, height_;
    GlTexture sharp_, blurred_;
    GlRenderbuffer depth_;
    GlFramebuffer drawn_, result_;
    GlProgram program_;
    GlArray empty_;
};

}  // namespace render
