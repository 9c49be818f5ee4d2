// The marks of every body: axes, centre of mass, bounding box, name.
#include "demos/snapshot/colors.h"
#include "demos/snapshot/frame_parts.h"
#include "engine/shapes/bounds.h"
#include "render/palette.h"

namespace demos {
namespace {

/// Their length is half the body plus a third of its reach.
void addAxes(const engine::Shape& shape, const engine::Pose& pose, render::Frame& frame) {
    const double reach = reachOf(shape);
    const Vec3 half = engine::boundsOf(shape, {}).high;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 tip = (half[axis] + 0.33 * reach) * Vec3::Unit(axis);
        frame.arrows.push_back({drawn(pose.position), drawn(pose.toWorld(tip)), axisColor(axis),
                                static_cast<float>(reach)});
    }
}

void addCentre(const engine::Shape& shape, const engine::Pose& pose, render::Frame& frame) {
    render::Marker marker{drawn(pose.position), 8.0f, render::fromHex(0x16181b)};
    marker.largest = static_cast<float>(0.6 * thicknessOf(shape));
    marker.reach = static_cast<float>(reachOf(shape));
    marker.shape = render::MarkerShape::quartered;
    frame.markers.push_back(marker);
}

/// The twelve edges.
void addBounds(const engine::Shape& shape, const engine::Pose& pose, render::Frame& frame) {
    const engine::Bounds bounds = engine::boundsOf(shape, pose);
    const auto corner = [&](int i) {
        return Vec3((i & 1 ? bounds.high : bounds.low).x(), (i & 2 ? bounds.high : bounds.low).y(),
                    (i & 4 ? bounds.high : bounds.low).z());
    };
    for (int i = 0; i < 8; ++i)
        for (const int axis : {1, 2, 4})
            if (!(i & axis))
                frame.lines.push_back(
                    {drawn(corner(i)), drawn(corner(i | axis)), 1.5f, render::boundsColor()});
}

}  // namespace

void addBodyMarks(const Moment& moment, render::Frame& frame) {
    const Stage& stage = moment.stage;
    const Overlays& show = moment.overlays;
    for (std::size_t i = 0; i < stage.bodies.size(); ++i) {
        if (!stage.world.has(stage.bodies[i])) continue;
        const engine::Shape& shape = stage.world.def(stage.bodies[i]).shape;
        const engine::Pose& pose = stage.world.pose(stage.bodies[i]);
        if (shape.type == engine::ShapeType::plane) continue;
        const bool moves = stage.scene.bodies[i].def.kind != engine::BodyKind::fixed;
        if (show.axes) addAxes(shape, pose, frame);
        if (show.com && moves) addCentre(shape, pose, frame);
        if (show.bounds) addBounds(shape, pose, frame);
        if (!show.ids) continue;
        frame.labels.push_back(
            {stage.scene.bodies[i].name, drawn(pose.position), static_cast<float>(reachOf(shape))});
        if (show.com) frame.labels.back().below = 1.1f;
    }
}

}  // namespace demos
