#include "demos/snapshot.h"

#include <numbers>

#include "demos/snapshot/parts.h"
#include "demos/theme.h"

namespace demos {
namespace {

render::Camera cameraOf(const Stage& stage, double time) {
    const CameraDescription& camera = stage.scene.camera;
    Vec3 moved = Vec3::Zero();
    for (std::size_t i = 0; i < stage.bodies.size(); ++i)
        if (!camera.follow.empty() && stage.scene.bodies[i].name == camera.follow)
            moved = stage.world.pose(stage.bodies[i]).position -
                    stage.scene.bodies[i].def.pose.position;
    const double angle = camera.orbitDegreesPerSecond * time * std::numbers::pi / 180.0;
    const Eigen::AngleAxisd turn(angle, Vec3::UnitY());
    const Vec3 from = camera.lookAt + turn * (camera.from - camera.lookAt);
    render::Camera result;
    result.from = drawn(from + moved);
    result.lookAt = drawn(camera.lookAt + moved);
    result.fovDegrees = static_cast<float>(camera.fovDegrees);
    return result;
}

}  // namespace

render::Frame snapshot(const Stage& stage, const Overlays& overlays, double frameTime,
                       const History& history) {
    const Moment moment{stage, overlays, history, frameTime};
    render::Frame frame;
    frame.camera = cameraOf(stage, frameTime);
    addBodies(moment, frame);
    addJoints(moment, frame);
    if (overlays.ghost) addGhosts(moment, frame);
    if (overlays.trails) addTrails(moment, frame);
    addContacts(moment, frame);
    if (overlays.nudges) addNudges(moment, frame);
    addBodyMarks(moment, frame);
    if (overlays.text) addTexts(moment, frame);
    if (overlays.stats) addStats(moment, frame);
    if (overlays.text) addLegend(moment, frame);
    applyTheme(overlays.theme, frame);
    return frame;
}

}  // namespace demos
