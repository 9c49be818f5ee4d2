#include "render/scene_pass.h"

#include <algorithm>
#include <Eigen/LU>
#include <cmath>

#include "render/trails.h"

namespace render {

ScenePass::ScenePass(int width, int height, int samples)
    : width_(width),
      height_(height),
      samplesColor_(newRenderbuffer(GL_RGBA8, width, height, samples)),
      samplesDepth_(newRenderbuffer(GL_DEPTH_COMPONENT24, width, height, samples)),
      samples_(newFramebuffer(0, 0, samplesColor_, samplesDepth_)),
      color_(newTexture(GL_RGBA8, width, height)),
      depth_(newTexture(GL_DEPTH_COMPONENT24, width, height)),
      resolved_(newFramebuffer(color_, depth_)),
      box_(newProgram("solid", "box")),
      round_(newProgram("solid", "round")),
      ground_(newProgram("ground", "ground")),
      sky_(newProgram("sky", "sky")),
      trail_(newProgram("trail", "trail")),
      empty_(newArray()),
      trailArray_(newArray()),
      trailBuffer_(newBuffer()) {
    glBindVertexArray(trailArray_);
    glBindBuffer(GL_ARRAY_BUFFER, trailBuffer_);
    for (const GLuint i : {0u, 1u}) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, 4, GL_FLOAT, GL_FALSE, sizeof(TrailVertex),
                              reinterpret_cast<const void*>(static_cast<std::size_t>(i) * 16));
    }
}

void ScenePass::useLit(const GlProgram& program, const Frame& frame, const View& view,
                       const ShadowPass& shadow) const {
    const Look& look = frame.look;
    glUseProgram(program);
    setUniform(program, "worldToClip", view.worldToClip());
    setUniform(program, "worldToShadow", shadow.worldToShadow());
    setUniform(program, "shadowTexel", shadow.texel());
    setUniform(program, "shadows", look.shadows ? 1 : 0);
    setUniform(program, "shadowMap", 0);
    setUniform(program, "toSun", shadow.toSun());
    setUniform(program, "eye", view.eye);
    setUniform(program, "skyLight", Vec3(0.46f, 0.49f, 0.53f));
    setUniform(program, "groundLight", Vec3(0.24f, 0.23f, 0.22f));
    setUniform(program, "sunLight", Vec3(0.86f, 0.83f, 0.78f));
    setColorUniform(program, "fogColor", look.fog);
    const float distance = (frame.camera.from - frame.camera.lookAt).norm();
    setUniform(program, "fogDistance", std::max(4.0f * distance, 30.0f));
    setUniform(program, "edges", look.edges ? 1 : 0);
    setUniform(program, "lineWidth", std::max(1.0f, 1.3f * static_cast<float>(height_) / 720.0f));
}

void ScenePass::draw(const Frame& frame, const View& view, const ShadowPass& shadow,
                     const InstancedMesh& boxes, const InstancedMesh& balls,
                     const InstancedMesh& bars) {
    glBindFramebuffer(GL_FRAMEBUFFER, samples_);
    glViewport(0, 0, width_, height_);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, shadow.map());
    glEnable(GL_CULL_FACE);
    useLit(box_, frame, view, shadow);
    boxes.draw();
    useLit(round_, frame, view, shadow);
    balls.draw();
    bars.draw();
    glDisable(GL_CULL_FACE);
    drawGrounds(frame, view, shadow);
    drawSky(frame, view);
    drawTrails(frame, view);
    resolve();
}

void ScenePass::drawGrounds(const Frame& frame, const View& view, const ShadowPass& shadow) {
    useLit(ground_, frame, view, shadow);
    setColorUniform(ground_, "groundColor", frame.look.ground);
    Color line = frame.look.ground;
    line.r *= 0.50f, line.g *= 0.51f, line.b *= 0.54f;
    if (line.r < 0.2f) line = {0.42f, 0.44f, 0.47f, 1.0f};  // on a dark ground, lighter lines
    setColorUniform(ground_, "lineColor", line);
    const float distance = (frame.camera.from - frame.camera.lookAt).norm();
    const float cell = std::max(std::pow(10.0f, std::floor(std::log10(distance / 6.0f))), 0.1f);
    setUniform(ground_, "cell", cell);
    for (const Ground& ground : frame.grounds) {
        if (!ground.visible) continue;
        const Vec3 n = ground.normal.normalized();
        const Vec3 helper = std::abs(n.x()) < 0.9f ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitZ());
        const Vec3 along = helper.cross(n).normalized(), across = n.cross(along);
        const Vec3 below = view.eye - (n.dot(view.eye) - ground.offset) * n;
        setUniform(ground_, "normal", n);
        setUniform(ground_, "origin", below);
        setUniform(ground_, "across", Vec3(across * view.farthest));
        setUniform(ground_, "along", Vec3(along * view.farthest));
        glBindVertexArray(empty_);
        glDrawArrays(GL_TRIANGLES, 0, 6);
    }
}

void ScenePass::drawSky(const Frame& frame, const View& view) {
    glDepthFunc(GL_LEQUAL);
    glUseProgram(sky_);
    setUniform(sky_, "clipToWorld", Eigen::Matrix4f(view.worldToClip().inverse()));
    setUniform(sky_, "eye", view.eye);
    setColorUniform(sky_, "fogColor", frame.look.fog);
    setColorUniform(sky_, "horizonColor", frame.look.skyHorizon);
    setColorUniform(sky_, "topColor", frame.look.skyTop);
    drawFullScreen(empty_);
    glDepthFunc(GL_LESS);
}

void ScenePass::drawTrails(const Frame& frame, const View& view) {
    const std::vector<TrailVertex> band = trailBands(frame, view, width_, height_);
    if (band.empty()) return;
    glBindBuffer(GL_ARRAY_BUFFER, trailBuffer_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(band.size() * sizeof(TrailVertex)),
                 band.data(), GL_STREAM_DRAW);
    glUseProgram(trail_);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    glDepthMask(GL_FALSE);
    glBindVertexArray(trailArray_);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(band.size()));
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void ScenePass::resolve() {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, samples_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_,
                      GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

}  // namespace render
