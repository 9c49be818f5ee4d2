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

constexpr int kSnap = 32;           // pixels: by how much the darkened part grows and shrinks
constexpr double kMostKept = 0.6;  // of the picture: with more, the bookkeeping is not worth it

/// To multiples of kSnap, so that it rarely changes.
PixelRect snapped(const PixelRect& r, int width, int height) {
    if (r.empty()) return {};
    return {r.x0 / kSnap * kSnap, r.y0 / kSnap * kSnap,
            std::min((r.x1 + kSnap - 1) / kSnap * kSnap, width),
            std::min((r.y1 + kSnap - 1) / kSnap * kSnap, height)};
}

/// Adds all that is in one of two rectangles only, and maybe more.
void addDifference(const PixelRect& a, const PixelRect& b, TileSet& tiles) {
    const PixelRect both = render::boundsOf({a, b});
    const PixelRect inner = common(a, b);
    if (inner.empty()) return tiles.add(both);
    tiles.add(PixelRect{both.x0, both.y0, both.x1, inner.y0});
    tiles.add(PixelRect{both.x0, inner.y1, both.x1, both.y1});
    tiles.add(PixelRect{both.x0, inner.y0, inner.x0, inner.y1});
    tiles.add(PixelRect{inner.x1, inner.y0, both.x1, inner.y1});
}

/// Copies a part of a map to another one of the same size, and finds the tiles that differ.
TileSet replaced(const DepthMap& from, const PixelRect& part, DepthMap& to) {
    constexpr int kSide = KeptOpenness::kSide;
    TileSet different(to.width, to.height, kSide);
    for (int y = part.y0; y < part.y1; ++y)
        for (int x = part.x0; x < part.x1;) {
            const int end = std::min((x / kSide + 1) * kSide, part.x1);
            const std::size_t at = static_cast<std::size_t>(y) * to.width + x;
            const std::size_t size = static_cast<std::size_t>(end - x) * sizeof(float);
            if (std::memcmp(&from.meters[at], &to.meters[at], size) != 0) {
                std::memcpy(&to.meters[at], &from.meters[at], size);
                different.add(PixelRect{x, y, end, y + 1});
            }
            x = end;
        }
    return different;
}

/// The tiles, of this size, of a map that show the same part of the picture; at odd sizes more.
TileSet scaled(const TileSet& tiles, int side, int fromWidth, int fromHeight, int width,
               int height) {
    TileSet result(width, height, side);
    const auto low = [](int x, int from, int to) { return x * to / from; };
    const auto high = [](int x, int from, int to) { return (x * to + from - 1) / from; };
    for (const PixelRect& r : tiles.rects())
        result.add(PixelRect{low(r.x0, fromWidth, width), low(r.y0, fromHeight, height),
                             high(r.x1, fromWidth, width), high(r.y1, fromHeight, height)});
    return result;
}

void checkGl() {
    glFinish();
    const GLenum error = glGetError();
    if (error != GL_NO_ERROR) throw Error("OpenGL reports error " + std::to_string(error));
}

/// Whether anything was drawn: the sky, if nothing else is in view.
bool isDrawn(const Image& image) {
    const auto isBlack = [](std::uint8_t value) { return value == 0; };
    for (std::size_t i = 0; i < image.pixels.size(); i += 4)
        if (!std::all_of(&image.pixels[i], &image.pixels[i] + 3, isBlack)) return true;
    return false;
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
    return frameView(frame, static_cast<float>(settings_.width) / static_cast<float>(settings_.height));
}

void Passes::enter(Stage stage) const {
    if (!observer) return;
    glFinish();
    observer(stage);
}

void Passes::setMeshes(const Frame& frame, const View& view, const Vec3& toSun,
                       const std::vector<char>* chosen) {
    meshes_.set(instancesOf(frame, pixelsAMeter(view, settings_.height), toSun, chosen));
}

void Passes::setMeshesIn(const TileSet& tiles, const Frame& frame, const View& view) {
    const std::vector<char> chosen =
        bodiesIn(tiles, frame, view, settings_.width, settings_.height);
    setMeshes(frame, view, &chosen);
}

DepthMap Passes::drawDepth(const Frame& frame) {
    kept_.valid = false;
    const View view = viewOf(frame);
    setMeshes(frame, view);
    DepthMap map;
    depth_.draw(frame, upsideDown(view), meshes_, ground_, map);
    return map;
}

SurfaceMap Passes::drawSurfaces(const Frame& frame, const std::vector<char>* chosen) {
    if (!surfaces_) surfaces_ = std::make_unique<SurfacePass>(settings_.width, settings_.height);
    const View view = viewOf(frame);
    setMeshes(frame, view, chosen);
    SurfaceMap map = surfaces_->draw(frame, upsideDown(view), meshes_, ground_);
    checkGl();
    return map;
}

const SurfaceMap& Passes::opaqueSurfaces(const Frame& frame) {
    std::vector<char> opaque;
    for (const Solid& solid : frame.solids) opaque.push_back(solid.material != Material::glass);
    opaque.resize(opaque.size() + frame.rods.size(), true);
    const bool glass = std::count(opaque.begin(), opaque.end(), false) > 0;
    if (kept_.valid && isSmooth() && !glass) return kept_.surfaces;
    return opaque_ = drawSurfaces(frame, &opaque);
}

OcclusionSettings Passes::occlusionOf(const Frame& frame, const View& view,
                                      const DepthMap& map) const {
    OcclusionSettings set;
    set.lensX = 1.0f / view.projection(0, 0);
    set.lensY = 1.0f / view.projection(1, 1);
    set.farthest = view.farthest;
    set.reach = 0.035f * (frame.camera.from - frame.camera.lookAt).norm() + 0.15f;
    const float nearest = *std::min_element(map.meters.begin(), map.meters.end());
    set.radius = occlusionRadius(set, nearest, map.height);
    for (const PixelRect& body : bodyRects(frame, view, settings_.width, settings_.height))
        set.where.push_back(halved(body).grown(set.radius, map.width, map.height));
    return set;
}

void Passes::uploadOpenness(const ByteMap& halfSize, const PixelRect& where) {
    if (where.empty()) return;
    const ByteMap open = doubled(halfSize, where);
    glBindTexture(GL_TEXTURE_2D, openMap_);
    glTexSubImage2D(GL_TEXTURE_2D, 0, where.x0, where.y0, open.width, open.height, GL_RED,
                    GL_UNSIGNED_BYTE, open.bytes.data());
}

Passes::Part Passes::partOf(const Frame& frame, const View& view, const ShadowFit* sun) {
    Part part;
    if (settings_.wholeFrames || !kept_.valid) return part;
    const bool still = !sun || *sun == kept_.sun;
    auto changed = changedRegion(kept_.frame, frame, view, settings_.width, settings_.height,
                                 still ? sun : nullptr);
    if (!changed) return part;
    part.comparable = true;
    part.whole = !still;
    part.bodies = std::move(changed->bodies);
    part.tiles = part.bodies;
    part.tiles.add(changed->shadows);
    part.texels = changed->texels;
    return part;
}

/// Returns the tiles of the map that differ, if it can be compared.
TileSet Passes::renewDepths(const Frame& frame, const View& view, const Part& part) {
    const bool compared = part.comparable && kept_.deep;
    kept_.deep = true;
    if (!compared) {
        setMeshes(frame, view);
        depth_.draw(frame, upsideDown(view), meshes_, ground_, kept_.depth);
        return {};
    }
    const int w = settings_.width, h = settings_.height;
    const TileSet tiles = scaled(part.bodies, KeptOpenness::kSide, w, h, depth_.width(),
                                 depth_.height());
    setMeshesIn(scaled(tiles, kTile, depth_.width(), depth_.height(), w, h), frame, view);
    spare_.width = kept_.depth.width, spare_.height = kept_.depth.height;
    spare_.meters.resize(kept_.depth.meters.size());
    depth_.drawPart(tiles, frame, upsideDown(view), meshes_, ground_, spare_);
    return replaced(spare_, render::boundsOf(tiles.rects()), kept_.depth);
}

void Passes::renewOpenness(const Frame& frame, const View& view, const TileSet& changed,
                           Part& part, Lights& lights) {
    const int width = settings_.width, height = settings_.height;
    const OcclusionSettings set = occlusionOf(frame, view, kept_.depth);
    const TileSet different =
        kept_.openness.renew(kept_.depth, set, part.comparable ? &changed : nullptr);
    lights.openMap = openMap_;
    lights.darkened = snapped(doubled(render::boundsOf(set.where), width, height), width, height);
    PixelRect upload = doubled(render::boundsOf(different.rects()), width, height);
    if (!part.comparable) upload = all();
    uploadOpenness(kept_.openness.map(), upload);
    if (part.comparable) {
        const int border = static_cast<int>(ShapeTiles::kMargin);
        for (const PixelRect& rect : different.rects())
            part.tiles.add(doubled(rect, width, height).grown(border, width, height));
        addDifference(kept_.darkened, lights.darkened, part.tiles);
    }
    kept_.darkened = lights.darkened;
}

/// With the meshes of all bodies set.
void Passes::drawShadows(const Frame& frame, const View& view, const ShadowFit& fit) {
    TileSet covered = texelTiles(fit);
    for (const PixelRect& texels : texelsUnder(frame, view, settings_.height, fit))
        covered.add(texels);
    sun_.draw(fit, meshes_, covered);
}

void Passes::renewShadows(const Frame& frame, const View& view, const ShadowFit& fit,
                          const Part& part) {
    if (!part.comparable || !(fit == kept_.sun)) {
        setMeshes(frame, view);
        drawShadows(frame, view, fit);
    } else if (!part.texels.empty()) {
        std::vector<char> chosen;
        for (const PixelRect& texels : texelsUnder(frame, view, settings_.height, fit))
            chosen.push_back(part.texels.touches(texels));
        setMeshes(frame, view, &chosen);
        sun_.drawPart(meshes_, part.texels);
    }
    kept_.sun = fit;
}

void Passes::renewPicture(const Frame& frame, const View& view, const Lights& lights,
                          const Part& part) {
    const std::size_t pixels = static_cast<std::size_t>(settings_.width) * settings_.height;
    kept_.image.width = kept_.smooth.width = kept_.surfaces.width = settings_.width;
    kept_.image.height = kept_.smooth.height = kept_.surfaces.height = settings_.height;
    kept_.image.pixels.resize(4 * pixels);
    drawnShare_ = part.whole ? 1.0 : part.tiles.share();
    if (drawnShare_ == 0.0) return;
    const std::vector<PixelRect> where =
        part.whole ? std::vector<PixelRect>{all()} : part.tiles.rects();
    const PixelRect read = render::boundsOf(where);
    if (part.whole)
        setMeshes(frame, view);
    else
        setMeshesIn(part.tiles, frame, view);
    scene_.draw(frame, upsideDown(view), lights, isSmooth(), meshes_, ground_,
                part.whole ? nullptr : &part.tiles);
    enter(Stage::readBack);
    scene_.read(read, kept_.image);
    if (isSmooth()) {
        kept_.surfaces.packed.resize(pixels);
        kept_.smooth.pixels.resize(4 * pixels);
        scene_.read(read, kept_.surfaces);
    }
    checkGl();
    enter(Stage::resolve);
    if (isSmooth())
        smoothEdges(kept_.image, kept_.surfaces, read, where, frame, view, settings_.samples,
                    kept_.smooth);
}

Image Passes::drawScene(const Frame& frame) {
    enter(Stage::depth);
    const View view = viewOf(frame);
    const bool darkened = isFull() && frame.look.ambientOcclusion;
    const bool shadows = isFull() && frame.look.shadows;
    Lights lights;
    lights.corners = !isFull();
    ShadowFit fit;
    if (shadows) fit = fitShadow(frame, view, frame.look.sunDirection, sun_.size());
    Part part = partOf(frame, view, shadows ? &fit : nullptr);
    kept_.valid = false;
    TileSet deeper;
    if (darkened || needsDepth(frame))
        deeper = renewDepths(frame, view, part);
    else
        kept_.deep = false;
    enter(Stage::occlusion);
    if (darkened) renewOpenness(frame, view, deeper, part, lights);
    part.whole = part.whole || part.tiles.share() > kMostKept;
    enter(Stage::shadow);
    if (shadows) {
        renewShadows(frame, view, fit, part);
        lights.sun = &sun_;
        lights.shaded = groundShadows(frame, view, settings_.width, settings_.height, fit);
    }
    enter(Stage::scene);
    renewPicture(frame, view, lights, part);
    kept_.frame = frame;
    kept_.valid = true;
    return finished(isSmooth() ? kept_.smooth : kept_.image, frame.look);
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
    kept_.valid = false;
    drawnShare_ = 1.0;
    enter(Stage::depth);
    Frame moment = frame;
    moment.camera = moved(frame.camera, sample.lens);
    const View view = sampleView(moment, sample);
    Lights lights;
    const bool full = settings_.finish == Finish::standard;
    lights.corners = !full;
    setMeshes(moment, view, sample.toSun);
    if (full && frame.look.ambientOcclusion) {
        depth_.draw(moment, upsideDown(view), meshes_, ground_, spare_);
        enter(Stage::occlusion);
        const OcclusionSettings occlusion = occlusionOf(moment, view, spare_);
        lights.openMap = openMap_;
        lights.darkened =
            doubled(render::boundsOf(occlusion.where), settings_.width, settings_.height);
        uploadOpenness(roughOpenness(spare_, occlusion, sample.turn), lights.darkened);
    }
    enter(Stage::shadow);
    if (full && frame.look.shadows) {
        const ShadowFit fit = fitShadow(moment, view, sample.toSun, sun_.size());
        drawShadows(moment, view, fit);
        lights.sun = &sun_;
        lights.shaded = groundShadows(moment, view, settings_.width, settings_.height, fit);
    }
    enter(Stage::scene);
    scene_.draw(moment, upsideDown(view), lights, false, meshes_, ground_);
    enter(Stage::readBack);
    Image image{settings_.width, settings_.height, {}};
    image.pixels.resize(4 * static_cast<std::size_t>(image.width) * image.height);
    scene_.read(all(), image);
    checkGl();
    return finished(std::move(image), frame.look);
}

/// A first picture all black means that the driver draws nothing: stop before a film is made.
Image Passes::finished(Image image, const Look& look) {
    if (look.transparent) {
        divideByAlpha(image);
        return image;
    }
    drawsSomething_ = drawsSomething_ || isDrawn(image);
    if (!drawsSomething_)
        throw Error("the picture is all black: the OpenGL driver draws nothing, or nothing is in view");
    return image;
}

}  // namespace render
