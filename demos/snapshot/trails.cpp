// The trails of the bodies named by the scene.
#include "demos/snapshot/colors.h"
#include "demos/snapshot/frame_parts.h"

namespace demos {

void addTrails(const Moment& moment, render::Frame& frame) {
    const Stage& stage = moment.stage;
    for (std::size_t i = 0; i < stage.trails.size(); ++i) {
        if (stage.trails[i].size() < 2) continue;
        render::Trail trail;
        for (const Vec3& point : stage.trails[i]) trail.points.push_back(drawn(point));
        const std::string& name = stage.scene.look.trails[i];
        for (std::size_t body = 0; body < stage.scene.bodies.size(); ++body)
            if (stage.scene.bodies[body].name == name)
                trail.color = ownColor(stage, static_cast<int>(body));
        frame.trails.push_back(std::move(trail));
    }
}

}  // namespace demos
