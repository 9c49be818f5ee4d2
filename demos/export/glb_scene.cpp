// In glTF a camera and a light look along -z of their node; the poses here come from their axes in
// the world.
#include "demos/export/glb_scene.h"

#include <algorithm>
#include <numbers>

#include "demos/export/bars.h"
#include "demos/export/glb_meshes.h"
#include "demos/export/glb_motion.h"
#include "demos/text/version.h"
#include "render/camera.h"
#include "render/palette.h"
#include "render/shortest_turn.h"

namespace demos {
namespace {

constexpr double kGroundHalf = 20.0;  // m
constexpr float kAspect = 16.0f / 9;  // of every quality's picture
constexpr float kSunLux = 3.0f;       // white in viewers without an exposure

GlbJson numbersOf(const auto& v) {
    GlbJson list = GlbJson::array();
    for (int i = 0; i < v.size(); ++i) list.push_back(v[i]);
    return list;
}

/// Leaves out glTF's default values.
GlbJson nodeOf(const std::string& name, const GlbPose& pose,
               const render::Vec3& scale = render::Vec3::Ones()) {
    GlbJson node;
    node["name"] = name;
    if (pose.translation != GlbPose{}.translation)
        node["translation"] = numbersOf(pose.translation);
    if (pose.rotation != GlbPose{}.rotation) node["rotation"] = numbersOf(pose.rotation);
    if (scale != render::Vec3::Ones()) node["scale"] = numbersOf(scale);
    return node;
}

bool isPlain(const engine::Pose& pose) {
    return pose.position.isZero(0.0) && pose.rotation.vec().isZero(0.0);
}

engine::Pose cameraPose(const render::Camera& camera) {
    const Vec3 from = camera.from.cast<double>();
    const Vec3 back = (from - camera.lookAt.cast<double>()).normalized();
    const Vec3 right = camera.up.cast<double>().cross(back).normalized();
    engine::Mat3 axes;
    axes << right, back.cross(right), back;
    return {from, Quat(axes)};
}

/// A mesh in a body's axes.
struct GlbPart {
    int mesh = 0;
    engine::Pose place;
    render::Vec3 scale;  // m
};

class GlbScene {
public:
    explicit GlbScene(const Recording& run)
        : run_(run), meshes_(buffer_), motion_(timesOf(run), buffer_) {}

    std::vector<std::uint8_t> file() {
        for (std::size_t i = 0; i < run_.bodies.size(); ++i) addBody(i);
        for (const BarMotion& bar : barsOf(run_)) addBar(bar);
        addCamera();
        addSun();
        GlbJson json;
        json["asset"] = {{"version", "2.0"}, {"generator", std::string("impulse ") + kVersion}};
        json["extensionsUsed"] = {"KHR_lights_punctual"};
        json["extensions"]["KHR_lights_punctual"]["lights"] = lights_;
        json["scene"] = 0;
        json["scenes"] = {{{"name", run_.name}, {"nodes", roots_}}};
        json["nodes"] = nodes_;
        json["cameras"] = cameras_;
        const GlbJson animations = motion_.animations();
        for (const auto& [key, list] :
             {std::pair("materials", &meshes_.materials()), std::pair("meshes", &meshes_.meshes()),
              std::pair("animations", &animations)})
            if (!list->empty()) json[key] = *list;  // the format allows no empty lists
        return buffer_.file(std::move(json));
    }

private:
    static std::vector<float> timesOf(const Recording& run) {
        std::vector<float> times;
        for (const RecordedFrame& frame : run.frames)
            times.push_back(static_cast<float>(frame.time));
        return times;
    }

    int add(GlbJson node) {
        nodes_.push_back(std::move(node));
        return static_cast<int>(nodes_.size()) - 1;
    }
    int addRoot(GlbJson node) {
        const int number = add(std::move(node));
        roots_.push_back(number);
        return number;
    }

    std::vector<GlbPart> partsOf(const RecordedBody& body) {
        if (!body.plane.isZero(0.0)) return {groundOf(body.plane)};
        const int material = meshes_.materialOf(body.color, body.look);
        std::vector<GlbPart> parts;
        for (const DrawnPart& part : body.parts)
            parts.push_back({meshes_.meshOf(trianglesOf(part.solid), material), part.place,
                             scaleOf(part.solid)});
        return parts;
    }

    GlbPart groundOf(const Vec3& normal) {
        const int material = meshes_.materialOf(run_.look.ground);
        engine::Pose place;
        place.rotation = render::shortestTurn<double>(Vec3::UnitY(), normal);
        return {meshes_.meshOf(squareTriangles(), material), place,
                render::Vec3(kGroundHalf, 1.0f, kGroundHalf)};
    }

    /// A single part in the body's own axes is in the body's node; otherwise each part is a child.
    void addBody(std::size_t body) {
        const std::string& name = run_.bodies[body].name;
        std::vector<GlbPose> poses;
        for (const RecordedFrame& frame : run_.frames)
            poses.push_back(glbPoseOf(frame.bodies[body].pose));
        const std::vector<GlbPart> parts = partsOf(run_.bodies[body]);
        const bool whole = parts.size() == 1 && isPlain(parts[0].place);
        GlbJson node = nodeOf(name, poses[0], whole ? parts[0].scale : render::Vec3::Ones());
        if (whole) node["mesh"] = parts[0].mesh;
        for (std::size_t i = 0; i < parts.size() && !whole; ++i) {
            GlbJson part = nodeOf(name + " part " + std::to_string(i + 1),
                                  glbPoseOf(parts[i].place), parts[i].scale);
            part["mesh"] = parts[i].mesh;
            node["children"].push_back(add(std::move(part)));
        }
        motion_.add(addRoot(std::move(node)), std::move(poses));
    }

    void addBar(const BarMotion& bar) {
        render::Solid cylinder;
        cylinder.shape = render::SolidShape::cylinder;
        std::vector<GlbPose> poses;
        for (const engine::Pose& pose : bar.poses) poses.push_back(glbPoseOf(pose));
        GlbJson node = nodeOf(bar.name, poses[0], bar.sizes[0]);
        node["mesh"] = meshes_.meshOf(trianglesOf(cylinder), meshes_.materialOf(render::jointColor()));
        const int number = addRoot(std::move(node));
        motion_.add(number, std::move(poses));
        motion_.addScales(number, bar.sizes);
    }

    /// The angle of view cannot be animated: it is that of time 0.
    void addCamera() {
        std::vector<GlbPose> poses;
        float nearest = 1e9f, farthest = 0.0f;  // m
        for (const RecordedFrame& frame : run_.frames) {
            const render::View view = render::makeView(frame.camera, kAspect);
            nearest = std::min(nearest, view.nearest);
            farthest = std::max(farthest, view.farthest);
            poses.push_back(glbPoseOf(cameraPose(frame.camera)));
        }
        const float degrees = run_.frames[0].camera.fovDegrees;
        cameras_.push_back({{"type", "perspective"},
                            {"perspective",
                             {{"aspectRatio", kAspect},
                              {"yfov", degrees * std::numbers::pi_v<float> / 180.0f},
                              {"znear", nearest},
                              {"zfar", farthest}}}});
        GlbJson node = nodeOf("camera", poses[0]);
        node["camera"] = 0;
        motion_.add(addRoot(std::move(node)), std::move(poses));
    }

    void addSun() {
        lights_.push_back({{"type", "directional"}, {"intensity", kSunLux}});
        engine::Pose pose;
        pose.rotation =
            render::shortestTurn<double>(Vec3::UnitZ(), run_.look.sunDirection.cast<double>());
        GlbJson node = nodeOf("sun", glbPoseOf(pose));
        node["extensions"]["KHR_lights_punctual"]["light"] = 0;
        addRoot(std::move(node));
    }

    const Recording& run_;
    GlbBuffer buffer_;
    GlbMeshes meshes_;
    GlbMotion motion_;
    GlbJson nodes_ = GlbJson::array(), roots_ = GlbJson::array();
    GlbJson cameras_ = GlbJson::array(), lights_ = GlbJson::array();
};

}  // namespace

std::vector<std::uint8_t> glbOf(const Recording& recording) {
    return GlbScene(recording).file();
}

}  // namespace demos
