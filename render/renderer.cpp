#include "render/renderer.h"

#include <algorithm>
#include <cstring>

#include "render/camera.h"
#include "render/context.h"
#include "render/occlusion_pass.h"
#include "render/overlay.h"
#include "render/scene_pass.h"
#include "render/shadow_pass.h"

namespace render {

/// In the order of drawing; the context first, so that everything else is freed before it.
struct Renderer::Passes {
    RendererSettings settings;
    std::unique_ptr<Context> context;
    InstancedMesh boxes, balls, bars;
    ShadowPass shadow;
    ScenePass scene;
    OcclusionPass occlusion;
    GlFramebuffer plain;

    explicit Passes(const RendererSettings& s)
        : settings(s),
          context(makeContext({s.width, s.height, s.threads, s.reproducible})),
          boxes(MeshKind::box),
          balls(MeshKind::ball),
          bars(MeshKind::bar),
          shadow(s.shadowSize),
          scene(s.width, s.height, s.samples),
          occlusion(s.width, s.height),
          plain(newFramebuffer(scene.color(), 0)) {
        glEnable(GL_DEPTH_TEST);
    }

    Image readBack(GLuint framebuffer) const;
    DepthImage readDepth() const;
};

namespace {

void checkGl() {
    glFinish();
    const GLenum error = glGetError();
    if (error != GL_NO_ERROR) throw Error("OpenGL reports error " + std::to_string(error));
}

/// A picture all of one colour is a driver that draws nothing: say so before a film of it is made.
void checkNotEmpty(const Image& image) {
    const std::uint8_t* first = image.pixels.data();
    for (std::size_t i = 4; i < image.pixels.size(); i += 4)
        if (std::memcmp(first, first + i, 3) != 0) return;
    if (image.width * image.height > 16)
        throw Error("the picture is all one colour; the OpenGL driver draws nothing");
}

}  // namespace

Image Renderer::Passes::readBack(GLuint framebuffer) const {
    Image image;
    image.width = settings.width, image.height = settings.height;
    image.pixels.resize(4u * static_cast<std::size_t>(image.width) * image.height);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    const std::size_t row = 4u * static_cast<std::size_t>(image.width);
    for (int y = 0; y < image.height / 2; ++y)  // OpenGL's rows go up, ours go down
        std::swap_ranges(image.pixels.begin() + static_cast<std::ptrdiff_t>(row * y),
                         image.pixels.begin() + static_cast<std::ptrdiff_t>(row * (y + 1)),
                         image.pixels.begin() +
                             static_cast<std::ptrdiff_t>(row * (image.height - 1 - y)));
    return image;
}

DepthImage Renderer::Passes::readDepth() const {
    DepthImage depth;
    depth.width = settings.width;
    const std::size_t row = static_cast<std::size_t>(settings.width);
    std::vector<float> upward(row * settings.height);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, scene.framebuffer());
    glReadPixels(0, 0, settings.width, settings.height, GL_DEPTH_COMPONENT, GL_FLOAT, upward.data());
    for (int y = settings.height - 1; y >= 0; --y)
        depth.stored.insert(depth.stored.end(),
                            upward.begin() + static_cast<std::ptrdiff_t>(row * y),
                            upward.begin() + static_cast<std::ptrdiff_t>(row * (y + 1)));
    return depth;
}

Renderer::Renderer(const RendererSettings& settings)
    : passes_(std::make_unique<Passes>(settings)) {
    checkGl();
}
Renderer::~Renderer() = default;

std::string Renderer::describe() const { return passes_->context->describe(); }

Image Renderer::draw(const Frame& frame) {
    Passes& p = *passes_;
    const View view = makeView(frame.camera, static_cast<float>(p.settings.width) /
                                                 static_cast<float>(p.settings.height));
    const Instances instances = instancesOf(frame);
    p.boxes.setInstances(instances.boxes);
    p.balls.setInstances(instances.balls);
    p.bars.setInstances(instances.bars);

    p.shadow.draw(frame, p.boxes, p.balls, p.bars);
    p.scene.draw(frame, view, p.shadow, p.boxes, p.balls, p.bars);
    if (frame.look.ambientOcclusion) p.occlusion.draw(frame, view, p.scene.color(), p.scene.depth());
    Image image = p.readBack(frame.look.ambientOcclusion ? p.occlusion.framebuffer() : p.plain);
    const DepthImage depth = frame.markers.empty() ? DepthImage{} : p.readDepth();
    checkGl();
    checkNotEmpty(image);

    drawMarkers(image, frame, view, depth);
    drawArrows(image, frame, view);
    drawTexts(image, frame);
    return image;
}

}  // namespace render
