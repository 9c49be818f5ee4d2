#include "demos/slides/run_moment.h"

namespace demos {

RunMoment momentOf(const Stage& stage) {
    RunMoment moment;
    moment.measures = measuresOf(stage);
    moment.report = stage.world.report();
    moment.hash = stage.world.hash();
    moment.dt = stage.dt();
    for (std::size_t i = 0; i < stage.bodies.size(); ++i)
        moment.bodies.push_back(motionOf(stage, i));
    for (const engine::JointId id : stage.joints) moment.joints.push_back(stage.world.joint(id));
    const auto contacts = stage.world.contacts();
    moment.contacts.assign(contacts.begin(), contacts.end());
    return moment;
}

}  // namespace demos
