#include "render/scene_pass.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "render/mirrored_view.h"
#include "render/scene_light.h"
#include "render/trails.h"

namespace render {
namespace {

float distanceOf(const Frame& frame) { return (frame.camera.from - frame.camera.lookAt).norm(); }

/// Darker than the ground; on a dark ground, lighter.
Color lineColor(const Color& ground) {
    if (ground.r < 0.4f) return {0.42f, 0.44f, 0.47f, 1.0f};
    return {0.68f * ground.r, 0.69f * ground.g, 0.71f * ground.b, 1.0f};
}

std::string featuresOf(const Lights& lights, const Look& look) {
    std::string features;
    if (look.dither && !lights.corners) features += " DITHERED";
    if (lights.sun) features += " SHADOWS";
    if (lights.openMap) features += " OCCLUSION";
    if (lights.corners) features += " LIT_CORNERS";
    return features;
}

bool reflects(const Frame& frame, const Lights& lights) {
    return frame.look.reflection > 0.0f && !frame.look.transparent && !lights.corners;
}

void bindTexture(int unit, GLuint texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture);
}

void setShadow(GLuint program, const ShadowPass& pass) {
    bindTexture(0, pass.map());
    setUniform(program, "shadowMap", 0);
    setUniform(program, "worldToShadow", pass.fit().worldToTexels());
    setUniform(program, "shadowTexel", pass.fit().texel);
    setUniform(program, "shadowSize", static_cast<float>(pass.size()));
}

/// Of a program for the image in the floor.
void setFloor(GLuint program, const Frame& frame, std::size_t floor) {
    constexpr float kPerFade = 5.0f;  // of the distance to the subject
    const Ground& ground = frame.grounds[floor];
    setUniform(program, "floorNormal", Vec3(ground.normal.normalized()));
    setUniform(program, "floorOffset", ground.offset);
    setUniform(program, "plainFloor", mirroredFloor(frame, ground));
    setUniform(program, "perFade", kPerFade / distanceOf(frame));
}

/// 1: the picture; 2: also the numbers of its surfaces.
void drawInto(int buffers) {
    constexpr GLenum kBuffers[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(buffers, kBuffers);
}

/// By alpha; a picture that is not transparent stays exactly opaque.
void blendOver(const Look& look) {
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, look.transparent ? GL_ONE : GL_ZERO,
                        look.transparent ? GL_ONE_MINUS_SRC_ALPHA : GL_ONE);
}

/// The macros of a material's program. With light at the corners only, materials have no patterns.
std::string patternOf(Material material, bool corners) {
    if (corners) return material == Material::glass ? " SEEN_THROUGH" : "";
    if (material == Material::plastic) return "";
    std::string name(valuesOf(material).name);
    for (char& letter : name) letter = static_cast<char>(letter - 'a' + 'A');
    return " PATTERN " + name;
}

/// Of bodies' edges.
void setLines(GLuint program, const Look& look, int height) {
    const float byHeight = 1.3f * static_cast<float>(height) / 720.0f * std::sqrt(look.lineStrength);
    setUniform(program, "lineWidth",
               std::max(1.0f, look.edgePixels > 0.0f ? look.edgePixels : byHeight));
    setUniform(program, "lineStrength", std::min(0.42f * look.lineStrength, 1.0f));
}

/// Colours and numbers need clearing only if ground and sky do not cover the picture.
void clear(const Look& look, bool numbered) {
    constexpr float kNothing[] = {0, 0, 0, 0};
    constexpr GLint kNone[] = {kNoSurface, 0, 0, 0};
    glClear(GL_DEPTH_BUFFER_BIT);
    if (!look.transparent) return;
    glClearBufferfv(GL_COLOR, 0, kNothing);
    if (numbered) glClearBufferiv(GL_COLOR, 1, kNone);
}

}  // namespace

ScenePass::ScenePass(int width, int height)
    : width_(width),
      height_(height),
      color_(newRenderbuffer(GL_RGBA8, width, height)),
      number_(newRenderbuffer(GL_R32I, width, height)),
      depth_(newRenderbuffer(GL_DEPTH_COMPONENT32F, width, height)),
      framebuffer_(newFramebuffer(0, 0, color_, depth_, number_)),
      trail_(newProgram("trail", "trail")),
      empty_(newArray()),
      trailArray_(newArray()),
      trailBuffer_(newBuffer()) {
    glBindVertexArray(trailArray_);
    glBindBuffer(GL_ARRAY_BUFFER, trailBuffer_);
    const auto attribute = [](GLuint index, int size, std::size_t offset) {
        glEnableVertexAttribArray(index);
        glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, sizeof(TrailVertex),
                              reinterpret_cast<const void*>(offset));
    };
    attribute(0, 4, offsetof(TrailVertex, clip));
    attribute(1, 4, offsetof(TrailVertex, color));
    attribute(2, 2, offsetof(TrailVertex, across));
}

/// A program with all uniforms of the light set.
GLuint ScenePass::lit(const std::string& vertex, const std::string& fragment,
                      const std::string& features, const Scene& scene) {
    GlProgram& program = programs_[fragment + features];
    if (!program) program = newProgram(vertex, fragment, features);
    const Look& look = scene.frame.look;
    const Lights& lights = scene.lights;
    glUseProgram(program);
    setUniform(program, "worldToClip", scene.view.worldToClip());
    setUniform(program, "toSun",
               lights.sun ? lights.sun->fit().toLight : look.sunDirection.normalized());
    setUniform(program, "eye", scene.view.eye);
    setUniform(program, "skyLight", kSkyLight);
    setUniform(program, "groundLight", groundLight(scene.frame));
    setUniform(program, "sunLight", kSunLight);
    setColorUniform(program, "fogColor", look.fog);
    const float distance = distanceOf(scene.frame);
    setUniform(program, "fogStart", look.transparent ? 1e9f : distance);  // behind the subject
    setUniform(program, "fogDistance", std::max(3.0f * distance, 20.0f));
    if (lights.sun) setShadow(program, *lights.sun);
    if (scene.floor) setFloor(program, scene.frame, *scene.floor);
    if (lights.openMap) {
        bindTexture(1, lights.openMap);
        setUniform(program, "openMap", 1);
    }
    return program;
}

void ScenePass::draw(const Frame& frame, const View& view, const Lights& lights, bool numbered,
                     const Meshes& meshes, const GroundMesh& ground, const TileSet* only) {
    const Scene scene{frame, view, lights};
    mirrored_.reset();
    if (reflects(frame, lights)) drawMirrored(scene, meshes);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, width_, height_);
    drawInto(numbered ? 2 : 1);
    const PixelRect all{0, 0, width_, height_};
    drawn_ = only ? only->rects() : std::vector<PixelRect>{all};
    if (only)
        keepAllButDrawn();
    else
        clear(frame.look, numbered);
    open_ = drawn_;
    glEnable(GL_SCISSOR_TEST);
    scissor(all);
    for (std::size_t i = 0; i < kMaterials; ++i)
        if (meshes.materials()[i] && Material(i) != Material::glass)
            drawBodies(scene, meshes, Material(i));
    drawBackground(scene, ground);
    drawGlass(scene, meshes);
    drawInto(1);  // a trail has no number, and its shader writes none
    drawTrails(scene);
    glDisable(GL_SCISSOR_TEST);
}

/// All other pixels get the smallest depth, so that nothing is drawn there. The others have the same
/// bits as always: neither triangles nor interpolation depend on which pixels are hidden, and tiles
/// have whole groups of 2x2 pixels, whose differences are the shaders' derivatives.
/// They have it still from the last time, except for those that were drawn then.
void ScenePass::keepAllButDrawn() {
    if (open_.size() == 1) {  // mostly the whole picture
        glClearDepth(0.0);
        glClear(GL_DEPTH_BUFFER_BIT);
        glClearDepth(1.0);
    } else {
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        tiles_.draw(open_, width_, height_, 0.0f);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    }
    tiles_.draw(drawn_, width_, height_);
}

/// To what is drawn within; false if that is nothing.
bool ScenePass::scissor(const PixelRect& rect) const {
    std::vector<PixelRect> parts;
    for (const PixelRect& r : drawn_)
        if (const PixelRect part = common(rect, r); !part.empty()) parts.push_back(part);
    const PixelRect bounds = parts.empty() ? PixelRect{} : render::boundsOf(parts);
    glScissor(bounds.x0, bounds.y0, bounds.x1 - bounds.x0, bounds.y1 - bounds.y0);
    return !parts.empty();
}

void ScenePass::read(const PixelRect& part, Image& image) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    readPart(part, width_, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
}

void ScenePass::read(const PixelRect& part, SurfaceMap& map) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glReadBuffer(GL_COLOR_ATTACHMENT1);
    readPart(part, width_, GL_RED_INTEGER, GL_INT, map.packed.data());
}

void ScenePass::drawBodies(const Scene& scene, const Meshes& meshes, Material material) {
    std::string features = featuresOf(scene.lights, scene.frame.look);
    features += scene.floor ? " MIRRORED" : scene.frame.look.edges ? " EDGES" : "";
    features += patternOf(material, scene.lights.corners);
    const float perGrain = 1.0f / scene.frame.look.grain;
    const auto program = [&](const char* vertex, const char* fragment, const std::string& more) {
        const GLuint name = lit(vertex, fragment, more, scene);
        setUniform(name, "perGrain", perGrain);
        setLines(name, scene.frame.look, height_);
        return name;
    };
    glEnable(GL_CULL_FACE);
    if (meshes.anyBoxes(material)) {  // a program that is not needed is not compiled
        program("solid", "box", features + " FLAT_FACES");
        meshes.drawBoxes(material);
    }
    if (meshes.anyFacets(material))
        meshes.drawFacets(program("facet", "facet", features), Detail::fine, material);
    if (meshes.anyRound(material)) {
        const GLuint round = program("solid", "round", features);
        meshes.drawRound(round, Detail::fine, Half::seen, material);  // scenery last: much of it is hidden
    }
    glDisable(GL_CULL_FACE);
}

/// Glass has no image, and the images' lines would be too thin.
void ScenePass::drawMirrored(const Scene& scene, const Meshes& meshes) {
    const std::optional<std::size_t> floor = floorOf(scene.frame);
    if (!floor || !isAbove(scene.view.eye, scene.frame.grounds[*floor])) return;
    mirrored_ = floor;
    const View below = mirroredView(scene.view, scene.frame.grounds[*floor]);
    imageRect_ = boundsOf(bodyRects(scene.frame, upsideDown(below), width_, height_))
                     .grown(MirrorPass::reach(height_), width_, height_);
    Scene image{scene.frame, below, scene.lights, floor};
    image.lights.openMap = 0;
    if (!mirror_) mirror_ = std::make_unique<MirrorPass>(width_, height_);
    mirror_->begin(mirroredFloor(scene.frame, scene.frame.grounds[*floor]));
    glFrontFace(GL_CCW);
    for (std::size_t i = 0; i < kMaterials; ++i)
        if (meshes.materials()[i] && Material(i) != Material::glass)
            drawBodies(image, meshes, Material(i));
    glFrontFace(GL_CW);
    mirror_->blur(imageRect_);
}

/// Over all that is behind it. Glass in front of glass does not hide it.
void ScenePass::drawGlass(const Scene& scene, const Meshes& meshes) {
    if (!meshes.materials()[indexOf(Material::glass)]) return;
    blendOver(scene.frame.look);
    glDepthMask(GL_FALSE);
    drawBodies(scene, meshes, Material::glass);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

/// Without a sky, empty pixels stay transparent, and the ground only receives shadows.
void ScenePass::drawBackground(const Scene& scene, const GroundMesh& mesh) {
    const PixelRect all{0, 0, width_, height_};
    Scene bright = scene;  // where openness is full, no lookup is needed
    bright.lights.openMap = 0;
    if (scene.lights.openMap) drawGrounds(scene, mesh, scene.lights.darkened);
    for (const PixelRect& part : around(scene.lights.darkened, all)) drawGrounds(bright, mesh, part);
    scissor(all);
    if (!scene.frame.look.transparent) drawSky(scene);
}

void ScenePass::drawGrounds(const Scene& scene, const GroundMesh& mesh, const PixelRect& part) {
    Scene glossy = scene;
    glossy.glossy = mirrored_.has_value();
    const PixelRect image = common(part, mirrored_ ? imageRect_ : PixelRect{});
    for (std::size_t i = 0; i < scene.frame.grounds.size(); ++i) {
        if (!scene.frame.grounds[i].visible) continue;
        if (!image.empty()) drawGround(glossy, mesh, i, image);
        for (const PixelRect& rest : around(image, part)) drawGround(scene, mesh, i, rest);
    }
}

/// Where nothing is in a shadow, no lookup is needed.
void ScenePass::drawGround(const Scene& scene, const GroundMesh& mesh, std::size_t number,
                           const PixelRect& part) {
    const ShadowPass* sun = scene.lights.sun;
    const Ground& ground = scene.frame.grounds[number];
    const GroundCorners corners =
        groundCorners(ground, scene.view, sun ? sun->footprint(ground) : std::vector<Vec3>{});
    Lights unshaded = scene.lights;
    unshaded.sun = nullptr;
    const PixelRect shaded = common(part, scene.lights.shaded);
    if (!corners.inside.empty() && scissor(shaded)) {
        setGround(scene, number, corners, featuresOf(scene.lights, scene.frame.look));
        mesh.draw(corners.inside);
    }
    setGround(scene, number, corners, featuresOf(unshaded, scene.frame.look));
    for (const PixelRect& lit : around(shaded, part))
        if (scissor(lit)) mesh.draw(corners.inside);
    if (scissor(part)) mesh.draw(corners.around);
}

void ScenePass::setGround(const Scene& scene, std::size_t number, const GroundCorners& corners,
                          const std::string& features) {
    const Look& look = scene.frame.look;
    const bool glossy = scene.glossy && mirrored_ == number;
    const std::string kind = look.transparent ? " SHADOW_CATCHER" : glossy ? " GLOSSY" : "";
    const GLuint program = lit("ground", "ground", features + kind, scene);
    setUniform(program, "surface", packedSurface(surfaceOfGround(scene.frame, number), 0));
    constexpr float kStrongPixels = 2.4f;  // of every fifth line (ground.frag): as wide as an edge
    setUniform(program, "lineStrength",
               look.edgePixels > 0.0f ? look.edgePixels / kStrongPixels : look.lineStrength);
    const Vec3 normal = scene.frame.grounds[number].normal.normalized();
    setUniform(program, "ambientLight", skyOn(scene.frame, scene.frame.grounds[number]));
    setUniform(program, "fullSun", sunOn(scene.frame, scene.frame.grounds[number]));
    setUniform(program, "normal", normal);
    setUniform(program, "across", corners.across);
    setUniform(program, "along", corners.along);
    setColorUniform(program, "groundColor", look.ground);
    setColorUniform(program, "lineColor", lineColor(look.ground));
    setUniform(program, "perCell", 1.0f / gridCell(scene.frame.camera));
    const Vec3& subject = scene.frame.camera.lookAt;
    setUniform(program, "subject", corners.across.dot(subject), corners.along.dot(subject));
    if (glossy) setMirror(program, scene, number, corners);
    setUniform(program, "perReach", look.gridReach > 0.0f ? 1.0f / look.gridReach : 0.0f);
}

void ScenePass::setMirror(GLuint program, const Scene& scene, std::size_t floor,
                          const GroundCorners& corners) {
    const Ground& ground = scene.frame.grounds[floor];
    const Vec3& eye = scene.view.eye;
    bindTexture(2, mirror_->picture());
    setUniform(program, "mirror", 2);
    setUniform(program, "perPixel", 1.0f / static_cast<float>(width_),
               1.0f / static_cast<float>(height_));
    setUniform(program, "plainFloor", mirroredFloor(scene.frame, ground));
    setUniform(program, "reflection", scene.frame.look.reflection);
    setUniform(program, "eye2", corners.across.dot(eye), corners.along.dot(eye));
    setUniform(program, "eyeHeight", ground.normal.normalized().dot(eye) - ground.offset);
}

void ScenePass::drawSky(const Scene& scene) {
    const Look& look = scene.frame.look;
    const std::string features = look.dither && !scene.lights.corners ? "DITHERED" : "";
    GlProgram& sky = programs_["sky " + features];
    if (!sky) sky = newProgram("sky", "sky", features);
    const auto color = [&sky](const char* name, const Color& c) {
        setUniform(sky, name, Vec3(c.r, c.g, c.b));
    };
    glDepthFunc(GL_LEQUAL);
    glUseProgram(sky);
    setUniform(sky, "clipToWorld", Eigen::Matrix4f(scene.view.worldToClip().inverse()));
    setUniform(sky, "eye", scene.view.eye);
    setUniform(sky, "forward", Vec3(-scene.view.view.block<1, 3>(2, 0).transpose()));
    color("fogColor", look.fog);
    color("horizonColor", look.skyHorizon);
    color("topColor", look.skyTop);
    scissor({0, 0, width_, rowsOfSky(scene.frame, upsideDown(scene.view), width_, height_)});
    drawFullScreen(empty_);
    scissor({0, 0, width_, height_});
    glDepthFunc(GL_LESS);
}

void ScenePass::drawTrails(const Scene& scene) {
    const std::vector<TrailVertex> band = trailBands(scene.frame, scene.view, width_, height_);
    if (band.empty()) return;
    glBindBuffer(GL_ARRAY_BUFFER, trailBuffer_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(band.size() * sizeof(TrailVertex)),
                 band.data(), GL_STREAM_DRAW);
    glUseProgram(trail_);
    blendOver(scene.frame.look);
    glDepthMask(GL_FALSE);
    glBindVertexArray(trailArray_);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(band.size()));
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

}  // namespace render
