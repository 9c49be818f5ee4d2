#include "demos/mjcf/joints.h"

#include <cmath>
#include <utility>

#include "demos/mjcf/joint_axes.h"

namespace demos::mjcf {
namespace {

using engine::Freedom;
using engine::JointDef;
using engine::JointType;

constexpr double kAcross = 1e-3;     // sine of the allowed deviation from a right angle
constexpr double kSamePoint = 1e-6;  // m

bool areAcross(const Vec3& a, const Vec3& b) { return std::abs(a.dot(b)) < kAcross; }

/// The same freedom along the opposite axis.
Freedom reversed(Freedom freedom) {
    std::swap(freedom.limits.low, freedom.limits.high);
    freedom.limits.low *= -1.0, freedom.limits.high *= -1.0;
    freedom.rest *= -1.0;
    freedom.motor.speed *= -1.0;
    return freedom;
}

/// Three axes at right angles, added by one joint after the other.
class Frame {
public:
    /// The number of the axis parallel to `axis`, which is added if it is at right angles to all
    /// others; else -1.
    int place(const Vec3& axis) {
        for (int i = 0; i < count_; ++i)
            if (std::abs(axes_[i].dot(axis)) > 1.0 - 0.5 * kAcross * kAcross) return i;
        for (int i = 0; i < count_; ++i)
            if (!areAcross(axes_[i], axis)) return -1;
        if (count_ == 2) {  // the two determine the third
            axes_[2] = axes_[0].cross(axes_[1]).normalized();
        } else {
            Vec3 straight = axis;
            if (count_ == 1) straight -= axes_[0].dot(axis) * axes_[0];
            axes_[count_] = straight.normalized();
        }
        return count_++;
    }

    /// `freedom` along `axis`, converted to the frame's parallel axis.
    Freedom along(int i, const Vec3& axis, const Freedom& freedom) const {
        return axes_[i].dot(axis) < 0.0 ? reversed(freedom) : freedom;
    }

    void fill() {
        while (count_ < 3) {
            Vec3 across, other;
            engine::tangents(axes_[0], across, other);
            place(count_ == 1 ? across : Vec3(axes_[0].cross(axes_[1])));
        }
    }

    const Vec3& axis(int i) const { return axes_[i]; }
    int count() const { return count_; }

private:
    Vec3 axes_[3]{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
    int count_ = 0;
};

class JointMaker {
public:
    JointMaker(const Link& link, const Context& context, const ForcesByName& forces)
        : context_(context) {
        for (const JointElement& joint : link.joints)
            joints_.push_back(readJoint(joint, link.pose, context, forces));
    }

    /// Sets all but the anchors, for which it gives `anchor` in world axes. False: it cannot be one
    /// joint.
    bool make(JointDef& def, Vec3& anchor) {
        anchor = joints_.back().anchor;
        if (joints_.size() == 1) return makeSingle(def);
        if (joints_.size() == 2 && isUniversal()) return makeUniversal(def, anchor);
        return makeSixDof(def, anchor);
    }

    std::string name() const {
        std::string name;
        for (const JointAxis& joint : joints_)
            if (!joint.name.empty()) name += (name.empty() ? "" : "+") + joint.name;
        return name;
    }

    const Spot& spot() const { return joints_.front().spot; }

private:
    bool makeSingle(JointDef& def) const {
        const JointAxis& joint = joints_.front();
        def.type = joint.word == JointWord::hinge   ? JointType::hinge
                   : joint.word == JointWord::slide ? JointType::slider
                                                    : JointType::ball;
        def.axis = joint.axis;
        def.free[0] = joint.freedom;
        return true;
    }

    bool isUniversal() const {
        return joints_[0].word == JointWord::hinge && joints_[1].word == JointWord::hinge &&
               areAcross(joints_[0].axis, joints_[1].axis);
    }

    /// The axis of the first hinge is fixed in the parent, that of the second in the link.
    bool makeUniversal(JointDef& def, Vec3& anchor) {
        def.type = JointType::universal;
        def.axis = joints_[0].axis;
        def.axis2 = joints_[1].axis - def.axis.dot(joints_[1].axis) * def.axis;
        def.free[0] = joints_[0].freedom;
        def.free[1] = joints_[1].freedom;
        anchor = commonPoint();
        return true;
    }

    /// The common point of the hinges; if they have none, the middle, with a note.
    Vec3 commonPoint() {
        Vec3 low = Vec3::Zero(), high = low;
        bool first = true;
        for (const JointAxis& joint : joints_) {
            if (joint.word == JointWord::slide) continue;
            low = first ? joint.anchor : low.cwiseMin(joint.anchor);
            high = first ? joint.anchor : high.cwiseMax(joint.anchor);
            first = false;
        }
        const double apart = (high - low).norm();
        if (apart > kSamePoint)
            context_.diagnostics.note(spot(), "the hinges of a <body> are at different points, " +
                                                  numberText(std::round(1e6 * apart) / 1e6) +
                                                  " m apart; they are put in the middle");
        return 0.5 * (low + high);
    }

    bool makeSixDof(JointDef& def, Vec3& anchor) {
        def.type = JointType::sixDof;
        for (Freedom& freedom : def.free) freedom.locked = true;
        Frame frame;
        int turns = 0;
        for (const JointAxis& joint : joints_) {
            if (joint.word == JointWord::slide && turns > 0) return refuse("a slide after a hinge");
            if (joint.word != JointWord::slide) ++turns;
            if (!addTo(joint, frame, def)) return false;
        }
        if (turns > 0) anchor = commonPoint();
        frame.fill();
        def.axis = frame.axis(0);
        def.axis2 = frame.axis(1);
        if (turns > 1) tellOfTurns(def);
        return true;
    }

    bool addTo(const JointAxis& joint, Frame& frame, JointDef& def) {
        if (joint.word == JointWord::ball) {
            for (int i = 3; i < 6; ++i) {
                if (!def.free[i].locked) return refuse("a ball with another ball or a hinge");
                def.free[i] = {};
            }
            return true;
        }
        const int axis = frame.place(joint.axis);
        if (axis < 0) return refuse("axes that are not at right angles");
        Freedom& freedom = def.free[joint.word == JointWord::slide ? axis : axis + 3];
        if (!freedom.locked) return refuse("two along the same axis");
        freedom = frame.along(axis, joint.axis, joint.freedom);
        return true;
    }

    bool refuse(const std::string& why) {
        context_.diagnostics.wrong(spot(),
                                   "the " + std::to_string(joints_.size()) +
                                       " joints of this <body> cannot be one joint here (" + why +
                                       "); put them in separate <body>s, each with some mass");
        return false;
    }

    void tellOfTurns(const JointDef& def) {
        bool acts = false;
        int free = 0;
        for (int i = 3; i < 6; ++i) {
            acts = acts || def.free[i].acts();
            free += def.free[i].locked ? 0 : 1;
        }
        if (acts || free == 2)
            context_.diagnostics.note(
                spot(),
                "several hinges of a <body> become rotations about three axes of "
                "one joint; ranges, springs and locked axes are exact only while "
                "just one of them is large");
    }

    const Context& context_;
    std::vector<JointAxis> joints_;
};

void addJoint(const Link& link, int around, int body, const Context& context,
              const ForcesByName& forces, SceneDescription& scene, Names& names) {
    JointMaker maker(link, context, forces);
    JointDescription joint;
    Vec3 anchor;
    if (!maker.make(joint.def, anchor)) return;
    const auto poseOf = [&](int place) {
        return place < 0 ? Pose{} : scene.bodies[static_cast<std::size_t>(place)].def.pose;
    };
    joint.def.a = {around};
    joint.def.b = {body};
    joint.def.anchorA = poseOf(around).toLocal(anchor);
    joint.def.anchorB = poseOf(body).toLocal(anchor);
    const std::string& child = scene.bodies[static_cast<std::size_t>(body)].name;
    joint.name = names.next(maker.name().empty() ? "joint-" + child : maker.name());
    joint.place = maker.spot().place;
    scene.joints.push_back(std::move(joint));
}

}  // namespace

void addJoints(const BodyTree& tree, const std::vector<int>& places, const Context& context,
               const ForcesByName& forces, SceneDescription& scene, Names& names) {
    for (std::size_t i = 0; i < tree.links.size(); ++i) {
        const Link& link = tree.links[i];
        const int around =
            link.parent == kWorld ? kWorld : places[static_cast<std::size_t>(link.parent)];
        if (!link.joints.empty()) addJoint(link, around, places[i], context, forces, scene, names);
    }
}

}  // namespace demos::mjcf
