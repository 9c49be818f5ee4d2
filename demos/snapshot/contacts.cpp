// Contact points with their normals, impulses and friction; also nudges.
#include <algorithm>
#include <cmath>

#include "demos/look/theme.h"
#include "demos/snapshot/frame_parts.h"
#include "demos/snapshot/scale.h"
#include "render/palette.h"

namespace demos {
namespace {

constexpr double kDotShare = 0.16;     // of the thinner body's thickness, at most
constexpr double kNormalShare = 0.03;  // of the view's height
constexpr double kNormalLength = 0.7;  // of the thinner body's thickness, at most

/// m: the thickness of the thinner body; if one is a plane, of the other.
double thinner(const Stage& stage, const engine::ContactState& contact) {
    const double a = thicknessOf(stage.world.def(contact.a).shape);
    const double b = thicknessOf(stage.world.def(contact.b).shape);
    return a > 0.0 && b > 0.0 ? std::min(a, b) : std::max(a, b);
}

render::Arrow arrow(const Vec3& from, const Vec3& way, const render::Color& color) {
    return {drawn(from), drawn(from + way), color};
}

}  // namespace

void addContacts(const Moment& moment, render::Frame& frame) {
    const Overlays& show = moment.overlays;
    const double view = viewHeight(moment.stage.scene.camera);
    const ArrowScale scale(moment.history.impulsePeak, view);
    for (const engine::ContactState& contact : moment.stage.world.contacts()) {
        const Vec3& at = contact.position;
        const double size = thinner(moment.stage, contact);
        if (show.contacts && contact.impulse > 0.0) {
            render::Marker dot{drawn(at), 3.5f, render::contactColor()};
            dot.largest = static_cast<float>(kDotShare * size);
            frame.markers.push_back(dot);
        }
        const double length = std::min(kNormalShare * view, kNormalLength * size);
        if (show.normals)
            frame.arrows.push_back(arrow(at, length * contact.normal, render::normalColor()));
        const double push = contact.impulse * scale.metersPerUnit;
        if (show.impulses && scale.shows(push))
            frame.arrows.push_back(arrow(at, push * contact.normal, render::impulseColor()));
        const Vec3 drag = contact.friction * scale.metersPerUnit;
        if (show.friction && scale.shows(drag.norm()))
            frame.arrows.push_back(arrow(at, drag, render::frictionColor()));
    }
}

void addNudges(const Moment& moment, render::Frame& frame) {
    const Stage& stage = moment.stage;
    const ArrowScale scale(moment.history.nudgePeak, viewHeight(stage.scene.camera));
    const std::vector<Vec3>& nudges = moment.history.nudges;
    for (std::size_t i = 0; i < nudges.size() && i < stage.bodies.size(); ++i) {
        const Vec3 way = nudges[i] * scale.metersPerUnit;
        if (!scale.shows(way.norm())) continue;
        frame.arrows.push_back(
            arrow(stage.world.pose(stage.bodies[i]).position, way, nudgeColor()));
        frame.arrows.back().reach =
            static_cast<float>(reachOf(stage.world.def(stage.bodies[i]).shape));
    }
}

}  // namespace demos
