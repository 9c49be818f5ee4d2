#include "render/occlusion_pass.h"

#include <algorithm>

namespace render {
namespace {

void bind(GLenum unit, GLuint texture) {
    glActiveTexture(unit);
    glBindTexture(GL_TEXTURE_2D, texture);
}

}  // namespace

OcclusionPass::Stage::Stage(GLenum format, int width, int height, const std::string& shader)
    : result(newTexture(format, width, height)),
      framebuffer(newFramebuffer(result, 0)),
      program(newProgram("full_screen", shader)) {}

void OcclusionPass::Stage::use(int width, int height) const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, width, height);
    glUseProgram(program);
}

OcclusionPass::OcclusionPass(int width, int height)
    : width_(width),
      height_(height),
      halfWidth_(std::max(width / 2, 1)),
      halfHeight_(std::max(height / 2, 1)),
      depth_(GL_R32F, halfWidth_, halfHeight_, "half_depth"),
      open_(GL_R8, halfWidth_, halfHeight_, "occlusion"),
      blurred_(GL_R8, halfWidth_, halfHeight_, "blur"),
      result_(newTexture(GL_RGBA8, width, height)),
      composed_(newFramebuffer(result_, 0)),
      compose_(newProgram("full_screen", "compose")),
      empty_(newArray()) {}

void OcclusionPass::draw(const Frame& frame, const View& view, GLuint color, GLuint depth) {
    glDisable(GL_DEPTH_TEST);
    bind(GL_TEXTURE1, color);
    bind(GL_TEXTURE2, depth_.result);
    bind(GL_TEXTURE3, open_.result);
    bind(GL_TEXTURE4, blurred_.result);
    bind(GL_TEXTURE0, depth);

    depth_.use(halfWidth_, halfHeight_);
    setUniform(depth_.program, "depthMap", 0);
    setUniform(depth_.program, "clipPlanes", view.nearest, view.farthest);
    drawFullScreen(empty_);

    open_.use(halfWidth_, halfHeight_);
    setUniform(open_.program, "depthMap", 2);
    setUniform(open_.program, "lens", 1.0f / view.projection(0, 0), 1.0f / view.projection(1, 1));
    setUniform(open_.program, "farthest", view.farthest);
    const float distance = (frame.camera.from - frame.camera.lookAt).norm();
    setUniform(open_.program, "reach", 0.035f * distance + 0.15f);
    drawFullScreen(empty_);

    blurred_.use(halfWidth_, halfHeight_);
    setUniform(blurred_.program, "depthMap", 2);
    setUniform(blurred_.program, "openMap", 3);
    drawFullScreen(empty_);

    glBindFramebuffer(GL_FRAMEBUFFER, composed_);
    glViewport(0, 0, width_, height_);
    glUseProgram(compose_);
    setUniform(compose_, "depthMap", 0);
    setUniform(compose_, "colorMap", 1);
    setUniform(compose_, "halfDepthMap", 2);
    setUniform(compose_, "openMap", 4);
    setUniform(compose_, "clipPlanes", view.nearest, view.farthest);
    drawFullScreen(empty_);
    glEnable(GL_DEPTH_TEST);
}

}  // namespace render
