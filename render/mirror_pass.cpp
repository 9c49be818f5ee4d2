#include "render/mirror_pass.h"

#include <algorithm>
#include <cmath>

namespace render {
namespace {

constexpr float kWidestBlur = 0.03f;  // of the picture's height: of the blur
constexpr float kMeanHeights = 0.02f;  // of it: over which heights are averaged

GlTexture newSmoothTexture(int width, int height, GLint smaller) {
    GlTexture texture = newTexture(GL_RGBA8, width, height);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, smaller);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return texture;
}

}  // namespace

MirrorPass::MirrorPass(int width, int height)
    : width_(std::max(width / 2, 1)),
      height_(std::max(height / 2, 1)),
      sharp_(newSmoothTexture(width_, height_, GL_LINEAR_MIPMAP_LINEAR)),
      blurred_(newSmoothTexture(width_, height_, GL_LINEAR)),
      depth_(newRenderbuffer(GL_DEPTH_COMPONENT32F, width_, height_)),
      drawn_(newFramebuffer(sharp_, 0, 0, depth_)),
      result_(newFramebuffer(blurred_, 0)),
      program_(newProgram("full_screen", "mirror")),
      empty_(newArray()) {}

void MirrorPass::begin(const Vec3& floor) {
    glBindFramebuffer(GL_FRAMEBUFFER, drawn_);
    glViewport(0, 0, width_, height_);
    const Vec3 root = floor.cwiseMin(1.0f).cwiseSqrt();
    const float nothing[] = {root.x(), root.y(), root.z(), 0.0f};
    glClearBufferfv(GL_COLOR, 0, nothing);
    glClear(GL_DEPTH_BUFFER_BIT);
}

int MirrorPass::reach(int height) {
    return 8 + static_cast<int>((2.0f * kWidestBlur + 2.0f * kMeanHeights) * static_cast<float>(height));
}

void MirrorPass::blur(const PixelRect& part) {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, sharp_);
    glGenerateMipmap(GL_TEXTURE_2D);
    glBindFramebuffer(GL_FRAMEBUFFER, result_);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(program_);
    const auto rows = static_cast<float>(height_);
    setUniform(program_, "sharp", 0);
    setUniform(program_, "perPixel", 1.0f / static_cast<float>(width_), 1.0f / rows);
    setUniform(program_, "widest", kWidestBlur * rows);
    setUniform(program_, "level", std::max(std::log2(kMeanHeights * rows), 0.0f));
    glEnable(GL_SCISSOR_TEST);
    const PixelRect texels{part.x0 / 2 - 1, part.y0 / 2 - 1, part.x1 / 2 + 2, part.y1 / 2 + 2};
    glScissor(texels.x0, texels.y0, texels.x1 - texels.x0, texels.y1 - texels.y0);
    drawFullScreen(empty_);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_DEPTH_TEST);
}

}  // namespace render
