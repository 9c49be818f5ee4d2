#include "render/passes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "render/edge_samples.h"
#include "render/overlay.h"

namespace render {
namespace {

/// To a map of half the size.
PixelRect halved(const PixelRect& rect) {
    return {rect.x0 / 2, rect.y0 / 2, (rect.x1 + 1) / 2, (rect.y1 + 1) / 2};
}

/// The reverse, in a picture of the given size.
PixelRect doubled(const PixelRect& rect, int width, int height) {
    return PixelRect{2 * rect.x0, 2 * rect.y0, 2 * rect.x1, 2 * rect.y1}.grown(1, width, height);
}

/// Pictures are drawn upside down, so that the first row read back is the top one.
View upsideDown(View view) {
    view.projection.row(1) *= -1.0f;
    return view;
}

void checkGl() {
    glFinish();
    const GLenum error = glGetError();
    if (error != GL_NO_ERROR) throw Error("OpenGL reports error " + std::to_string(error));
}

/// A picture all of one colour means that the driver draws nothing: stop before a film is made.
void checkNotEmpty(const Image& image) {
    const std::uint8_t* first = image.pixels.data();
    for (std::size_t i = 4; i < image.pixels.size(); i += 4)
        if (std::memcmp(first, first + i, 4) != 0) return;
    if (image.width * image.height > 16)
        throw Error("the picture is all one colour; the OpenGL driver draws nothing");
}

/// Premultiplied to straight alpha.
void divideByAlpha(Image& image) {
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        const int alpha = image.pixels[i + 3];
        if (alpha == 0 || alpha == 255) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            const int color = (255 * image.pixels[i + c] + alpha / 2) / alpha;
            image.pixels[i + c] = static_cast<std::uint8_t>(std::min(color, 255));
        }
    }
}

/// Moves the camera to another point of its lens; points in focus keep their place in the picture.
Camera moved(Camera camera, const Eigen::Vector2f& lens) {
    if (camera.aperture <= 0.0f) return camera;
    const Vec3 sight = (camera.lookAt - camera.from).normalized();
    const float focus =
        camera.focus > 0.0f ? camera.focus : (camera.lookAt - camera.from).norm();
    const Vec3 right = sight.cross(camera.up).normalized(), up = right.cross(sight);
    camera.lookAt = camera.from + focus * sight;
    camera.from += camera.aperture * (lens.x() * right + lens.y() * up);
    return camera;
}

}  // namespace

Passes::Passes(const RendererSettings& settings)
    : settings_(settings),
      context_(makeContext({settings.width, settings.height, settings.threads,
                            settings.reproducible, settings.context})),
      sun_(shadowTexels(settings)),
      depth_(settings.width, settings.height),
      openMap_(newTexture(GL_R8, settings.width, settings.height)),
      scene_(settings.width, settings.height) {
    glEnable(GL_DEPTH_TEST);
    glFrontFace(GL_CW);  // upside down
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    checkGl();
}

View Passes::viewOf(const Frame& frame) const {
    return makeView(frame.camera,
                    static_cast<float>(settings_.width) / static_cast<float>(settings_.height));
}

void Passes::enter(Stage stage) const {
    if (!observer) return;
    glFinish();
    observer(stage);
}

void Passes::setMeshes(const Frame& frame, const View& view) {
    meshes_.set(instancesOf(frame, pixelsAMeter(view, settings_.height)));
}

DepthMap Passes::drawDepth(const Frame& frame) {
    const View view = viewOf(frame);
    setMeshes(frame, view);
    return depth_.draw(frame, upsideDown(view), meshes_, ground_);
}

SurfaceMap Passes::drawSurfaces(const Frame& frame) {
    if (!surfaces_) surfaces_ = std::make_unique<SurfacePass>(settings_.width, settings_.height);
    const View view = viewOf(frame);
    setMeshes(frame, view);
    SurfaceMap map = surfaces_->draw(frame, upsideDown(view), meshes_, ground_);
    checkGl();
    return map;
}

OcclusionSettings Passes::occlusionOf(const Frame& frame, const View& view,
                                      const DepthMap& map) const {
    OcclusionSettings set;
    set.lensX = 1.0f / view.projection(0, 0);
    set.lensY = 1.0f / view.projection(1, 1);
    set.farthest = view.farthest;
    set.reach = 0.035f * (frame.camera.from - frame.camera.lookAt).norm() + 0.15f;
    const float nearest = *std::min_element(map.meters.begin(), map.meters.end());
    const int border = occlusionRadius(set, nearest, map.height);
    for (const PixelRect& body : bodyRects(frame, view, settings_.width, settings_.height))
        set.where.push_back(halved(body).grown(border, map.width, map.height));
    return set;
}

void Passes::darken(const ByteMap& halfSize, const std::vector<PixelRect>& where,
                    Lights& lights) {
    lights.openMap = openMap_;
    lights.darkened = doubled(boundsOf(where), settings_.width, settings_.height);
    if (lights.darkened.empty()) return;
    const ByteMap open = doubled(halfSize, lights.darkened);
    glBindTexture(GL_TEXTURE_2D, openMap_);
    glTexSubImage2D(GL_TEXTURE_2D, 0, lights.darkened.x0, lights.darkened.y0, open.width,
                    open.height, GL_RED, GL_UNSIGNED_BYTE, open.bytes.data());
}

Image Passes::drawScene(const Frame& frame, DepthMap& depth) {
    enter(Stage::depth);
    const View view = viewOf(frame);
    const bool full = settings_.finish == Finish::standard;
    const bool darkened = full && frame.look.ambientOcclusion;
    Lights lights;
    lights.corners = !full;
    setMeshes(frame, view);
    if (darkened || needsDepth(frame))
        depth = depth_.draw(frame, upsideDown(view), meshes_, ground_);
    enter(Stage::occlusion);
    if (darkened) {
        const OcclusionSettings occlusion = occlusionOf(frame, view, depth);
        darken(openness(depth, occlusion), occlusion.where, lights);
    }
    enter(Stage::shadow);
    if (full && frame.look.shadows) {
        sun_.draw(frame, frame.look.sunDirection, meshes_);
        lights.sun = &sun_;
    }
    enter(Stage::scene);
    const bool smooth = full && settings_.samples > 1;
    scene_.draw(frame, upsideDown(view), lights, smooth, meshes_, ground_);
    Image image = readBack();
    if (smooth) {
        SurfaceMap surfaces = scene_.surfaces();
        enter(Stage::resolve);
        smoothEdges(image, std::move(surfaces), frame, view, settings_.samples);
    }
    return finished(std::move(image), frame.look);
}

View Passes::sampleView(const Frame& frame, const SubSample& sample) const {
    View view = viewOf(frame);
    Eigen::Matrix4f shift = Eigen::Matrix4f::Identity();
    shift(0, 3) = 2.0f * sample.pixel.x() / static_cast<float>(settings_.width);
    shift(1, 3) = 2.0f * sample.pixel.y() / static_cast<float>(settings_.height);
    view.projection = shift * view.projection;
    return view;
}

Image Passes::drawSample(const Frame& frame, const SubSample& sample) {
    enter(Stage::depth);
    Frame moment = frame;
    moment.camera = moved(frame.camera, sample.lens);
    const View view = sampleView(moment, sample);
    Lights lights;
    const bool full = settings_.finish == Finish::standard;
    lights.corners = !full;
    setMeshes(moment, view);
    if (full && frame.look.ambientOcclusion) {
        const DepthMap depth = depth_.draw(moment, upsideDown(view), meshes_, ground_);
        enter(Stage::occlusion);
        const OcclusionSettings occlusion = occlusionOf(moment, view, depth);
        darken(roughOpenness(depth, occlusion, sample.turn), occlusion.where, lights);
    }
    enter(Stage::shadow);
    if (full && frame.look.shadows) {
        sun_.draw(moment, sample.toSun, meshes_);
        lights.sun = &sun_;
    }
    enter(Stage::scene);
    scene_.draw(moment, upsideDown(view), lights, false, meshes_, ground_);
    return finished(readBack(), frame.look);
}

Image Passes::readBack() const {
    enter(Stage::readBack);
    Image image = scene_.image();
    checkGl();
    return image;
}

Image Passes::finished(Image image, const Look& look) const {
    if (look.transparent)
        divideByAlpha(image);
    else
        checkNotEmpty(image);
    return image;
}

}  // namespace render
