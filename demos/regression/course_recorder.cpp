#include "demos/regression/course_recorder.h"

#include <algorithm>

#include "demos/report/measures.h"
#include "engine/collision/bounds.h"

namespace demos {
namespace {

constexpr std::size_t kMostPoses = 200'000;  // of all bodies while the course is dense: 11 MB

/// Half the sides of a box about the body, in its own axes; nothing for what has no end.
Vec3 extentOf(const engine::Shape& shape) {
    if (shape.type == engine::ShapeType::plane) return Vec3::Zero();
    const engine::Bounds bounds = engine::boundsOf(shape, {});
    return bounds.low.cwiseAbs().cwiseMax(bounds.high.cwiseAbs());
}

}  // namespace

CourseRecorder::CourseRecorder(const Stage& stage, int steps) : steps_(steps) {
    course_.hz = stage.scene.hz;
    course_.dense = std::max(static_cast<int>(kMostPoses / (stage.bodies.size() + 1)), 1);
    if (course_.dense >= steps) course_.dense = Course::kAll;
    for (std::size_t i = 0; i < stage.bodies.size(); ++i) {
        course_.bodies.push_back(stage.scene.bodies[i].name);
        course_.extents.push_back(extentOf(stage.world.def(stage.bodies[i]).shape));
    }
}

void CourseRecorder::look(const Stage& stage) {
    const std::uint64_t hash = stage.world.hash();
    course_.hashes.push_back(static_cast<std::uint32_t>(hash ^ hash >> 32));
    if (hasMoment(step_, course_.dense) || step_ == steps_) course_.moments.push_back(momentOf(stage));
    ++step_;
}

CourseMoment CourseRecorder::momentOf(const Stage& stage) {
    CourseMoment moment;
    moment.step = step_;
    for (const engine::BodyId body : stage.bodies) moment.poses.push_back(stage.world.pose(body));
    const Measures measures = measuresOf(stage);
    moment.energy = measures.energy.total();
    moment.penetration = measures.penetration;
    moment.separation = measures.separation;
    if (step_ == 0) return moment;  // nothing was solved yet
    addContacts(stage, moment.impulses);
    addJoints(stage, moment.impulses);
    std::sort(moment.impulses.begin(), moment.impulses.end(),
              [](const CourseImpulse& a, const CourseImpulse& b) {
                  return a.constraint < b.constraint;
              });
    return moment;
}

/// The points of a pair together: which of its corners carries is not the pair's affair.
void CourseRecorder::addContacts(const Stage& stage, std::vector<CourseImpulse>& impulses) {
    std::map<int, double> sums;
    for (const engine::ContactState& contact : stage.world.contacts())
        if (contact.impulse != 0.0)
            sums[constraintCalled("contact " + stage.nameOf(contact.a) + "-" +
                                  stage.nameOf(contact.b))] += contact.impulse;
    for (const auto& [constraint, value] : sums) impulses.push_back({constraint, value});
}

void CourseRecorder::addJoints(const Stage& stage, std::vector<CourseImpulse>& impulses) {
    for (std::size_t i = 0; i < stage.joints.size(); ++i) {
        const double value = stage.world.joint(stage.joints[i]).force.norm() * stage.dt();
        if (value != 0.0)
            impulses.push_back({constraintCalled("joint " + stage.scene.joints[i].name), value});
    }
}

int CourseRecorder::constraintCalled(const std::string& name) {
    const auto [found, added] =
        constraints_.emplace(name, static_cast<int>(course_.constraints.size()));
    if (added) course_.constraints.push_back(name);
    return found->second;
}

}  // namespace demos
