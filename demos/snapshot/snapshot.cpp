#include "demos/snapshot/snapshot.h"

#include <fmt/format.h>

#include "demos/look/theme.h"
#include "demos/look/type.h"
#include "demos/snapshot/camera.h"
#include "demos/snapshot/frame_parts.h"
#include "demos/snapshot/scale.h"
#include "render/camera.h"

namespace demos {
namespace {

constexpr float kGrain = 0.032f;  // of the view's height: 23 pixels of 720
constexpr float kGridReach = 0.9f;

void addGridScale(render::Frame& frame) {
    constexpr float kSize = 13.0f;
    const float cell = render::gridCell(frame.camera);
    frame.texts.push_back({fmt::format("grid {:g} m, {:g} m", cell, 5.0f * cell),
                           render::Corner::bottomRight, kSize});
}

}  // namespace

render::Frame snapshot(const Stage& stage, const Overlays& overlays, double frameTime,
                       const History& history) {
    const Moment moment{stage, overlays, history, frameTime};
    render::Frame frame;
    frame.camera = cameraOf(moment);
    addBodies(moment, frame);
    addJoints(moment, frame);
    if (overlays.ghost) addGhosts(moment, frame);
    if (overlays.trails) addTrails(moment, frame);
    addContacts(moment, frame);
    if (overlays.nudges) addNudges(moment, frame);
    if (overlays.annotate) addAnnotations(moment, frame);
    addBodyMarks(moment, frame);
    if (overlays.text && overlays.headings) addTexts(moment, frame);
    if (overlays.stats) addStats(moment, frame);
    if (overlays.text) addLegend(moment, frame);
    if (overlays.text && overlays.theme == "lab") addGridScale(frame);
    applyTheme(overlays.theme, frame);
    colorHeadings(frame);
    frame.look.reflection = static_cast<float>(stage.scene.look.reflection);
    frame.look.dither = stage.scene.look.dither;
    const CameraDescription& camera = stage.scene.camera;
    frame.look.sunDirection = lightOf(stage.scene);
    const auto height = static_cast<float>(viewHeight(camera));
    frame.look.grain = kGrain * height;
    if (overlays.theme != "lab") frame.look.gridReach = kGridReach * height;
    if (overlays.pixelsPerPoint > 0.0) setType(overlays.pixelsPerPoint, frame);
    return frame;
}

}  // namespace demos
