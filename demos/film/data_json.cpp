#include "demos/film/data_json.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "demos/film/json_list.h"
#include "demos/text/version.h"
#include "render/data_images.h"

namespace demos {
namespace {

using Json = nlohmann::ordered_json;

Json rowsOf(const Eigen::Matrix4f& m) {
    Json rows = Json::array();
    for (int row = 0; row < 4; ++row) {
        Json values = Json::array();
        for (int column = 0; column < 4; ++column)
            values.push_back(static_cast<double>(m(row, column)));
        rows.push_back(std::move(values));
    }
    return rows;
}

Json begun(const FilmPlan& plan, int frame) {
    Json json;
    json["frame"] = frame;
    json["time"] = plan.timeOf(frame);
    return json;
}

std::string dumped(const Json& json, int indent = -1) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

const char* nameOf(ContactEvent::Kind kind) {
    switch (kind) {
        case ContactEvent::Kind::begin: return "begin";
        case ContactEvent::Kind::persist: return "persist";
        case ContactEvent::Kind::end: return "end";
    }
    return "";
}

Json jsonOf(const ContactEvent& event, const Stage& stage) {
    const engine::ContactState& c = event.contact;
    Json json;
    json["event"] = nameOf(event.kind);
    json["step"] = event.step;
    json["time"] = static_cast<double>(event.step) / stage.scene.hz;
    json["a"] = stage.nameOf(c.a);
    json["b"] = stage.nameOf(c.b);
    json["ids"] = {c.a.index + 1, c.b.index + 1};
    if (event.kind == ContactEvent::Kind::end) return json;
    json["position"] = listOf(c.position);
    json["normal"] = listOf(c.normal);
    json["penetration"] = c.penetration;
    json["impulse"] = c.impulse;
    json["friction"] = listOf(c.friction);
    return json;
}

/// `frame_####.png` -> `depth/frame_####.pfm`
std::string filesOf(const PassText& text, const std::string& pattern) {
    const std::filesystem::path name = std::filesystem::path(pattern).filename();
    return std::string(text.name) + "/" + name.stem().string() + text.ending;
}

/// The numbers of the pass 'id': the bodies in the scene file's order, then the joints.
Json idsOf(const SceneDescription& scene) {
    Json ids = Json::array();
    const auto add = [&ids](const std::string& name, const char* kind) {
        ids.push_back({{"id", ids.size() + 1}, {"kind", kind}, {"name", name}});
    };
    for (const BodyDescription& body : scene.bodies) add(body.name, "body");
    for (const JointDescription& joint : scene.joints) add(joint.name, "joint");
    return ids;
}

/// m: to the point the camera looks at, or to the far side of the farthest body at time 0.
double reachFrom(const Vec3& from, const Vec3& lookAt, const SceneDescription& scene) {
    double reach = (lookAt - from).norm();
    for (const BodyDescription& body : scene.bodies) {
        const engine::Shape& shape = body.def.shape;
        if (shape.type == engine::ShapeType::plane) continue;
        reach = std::max(reach, (body.def.pose.position - from).norm() + engine::reachOf(shape));
    }
    return reach;
}

}  // namespace

std::string cameraJson(const FilmPlan& plan, int frame, const render::Camera& camera) {
    const int width = plan.picture.width, height = plan.picture.height;
    const render::View view =
        render::makeView(camera, static_cast<float>(width) / static_cast<float>(height));
    const render::Lens lens = render::lensOf(view, width, height);
    Json json = begun(plan, frame);
    json["size"] = {width, height};
    json["position"] = listOf(camera.from);
    json["look_at"] = listOf(camera.lookAt);
    json["fov_deg"] = static_cast<double>(camera.fovDegrees);
    json["near"] = static_cast<double>(view.nearest);
    json["far"] = static_cast<double>(view.farthest);
    json["K"] = Json::array({Json::array({lens.focalX, 0.0, lens.centreX}),
                             Json::array({0.0, lens.focalY, lens.centreY}),
                             Json::array({0.0, 0.0, 1.0})});
    json["view"] = rowsOf(view.view);
    json["projection"] = rowsOf(view.projection);
    return dumped(json);
}

std::string posesJson(const FilmPlan& plan, int frame, const Stage& stage) {
    Json json = begun(plan, frame);
    Json& bodies = json["bodies"] = Json::array();
    for (std::size_t i = 0; i < stage.bodies.size(); ++i) {
        const engine::BodyId id = stage.bodies[i];
        const engine::Pose& pose = stage.world.pose(id);
        const Quat& q = pose.rotation;
        Json body;
        body["id"] = i + 1;
        body["name"] = stage.scene.bodies[i].name;
        body["position"] = listOf(pose.position);
        body["rotation"] = {q.w(), q.x(), q.y(), q.z()};
        body["velocity"] = listOf(stage.world.velocity(id));
        body["spin"] = listOf(stage.world.spin(id));
        bodies.push_back(std::move(body));
    }
    return dumped(json);
}

std::string contactsJson(const FilmPlan& plan, int frame, const Stage& stage,
                         const std::vector<ContactEvent>& events) {
    Json json = begun(plan, frame);
    Json& contacts = json["contacts"] = Json::array();
    for (const ContactEvent& event : events) contacts.push_back(jsonOf(event, stage));
    return dumped(json);
}

std::string eventsJson(const FilmPlan& plan, int frame, const Stage& stage,
                       const StageEvents& events) {
    Json json = begun(plan, frame);
    json["events"] = Json::parse(eventsJson(events, stage));
    return dumped(json);
}

std::string passesJson(const FilmPlan& plan, const std::string& pattern) {
    Json json;
    json["impulse"] = kVersion;
    json["scene"] = plan.name;
    json["size"] = {plan.picture.width, plan.picture.height};
    json["frames"] = plan.frames;
    json["fps"] = plan.fps;
    json["steps_per_frame"] = plan.slowSteps.empty() ? Json(plan.stepsPerFrame) : Json();  // null: they vary
    json["axes"] = "metres, y up, right-handed; pixels from the top left corner";
    json["depth_unit_m"] = depthUnitOf(plan.scene());
    Json& passes = json["passes"] = Json::object();
    for (const Pass pass : plan.passes) {
        const PassText& text = textOf(pass);
        passes[text.name] = {{"files", filesOf(text, pattern)},
                             {"format", text.format},
                             {"unit", text.unit},
                             {"about", text.about}};
    }
    json["ids"] = idsOf(plan.scene());
    return dumped(json, 1);
}

double depthUnitOf(const SceneDescription& scene) {
    const CameraDescription& camera = scene.camera;
    double reach = reachFrom(camera.from, camera.lookAt, scene);
    for (const CameraKey& key : camera.keys)
        reach = std::max(reach, reachFrom(key.from, key.lookAt, scene));
    for (const double decade : {1e-4, 1e-3, 1e-2, 1e-1, 1.0})
        for (const double unit : {decade, 2.0 * decade, 5.0 * decade})
            if (65534.0 * unit >= 2.0 * reach) return unit;
    return 10.0;
}

}  // namespace demos
