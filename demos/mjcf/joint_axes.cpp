#include "demos/mjcf/joint_axes.h"

#include "demos/mjcf/freedom.h"
#include "demos/scene/ranges.h"

namespace demos::mjcf {
namespace {

constexpr Range kDirection{-1e6, 1e6};
constexpr Range kCoordinate{-1e5, 1e5};

class JointReader {
public:
    JointReader(const JointElement& joint, const Context& context, const ForcesByName& forces)
        : attributes_(context.defaults.of(*joint.element, joint.childclass)),
          context_(context),
          forces_(forces) {}

    JointAxis read(const Pose& pose) {
        joint_.spot = attributes_.spot();
        joint_.name = attributes_.text("name");
        readWord();
        joint_.anchor =
            pose.toWorld(yUp(attributes_.vector("pos", kMeters).value_or(Vec3(0, 0, 0))));
        const Vec3 axis = attributes_.vector("axis", kDirection).value_or(Vec3(0, 0, 1));
        if (axis.norm() > 1e-9)
            joint_.axis = pose.rotation * yUp(Vec3(axis.normalized()));
        else
            attributes_.wrong("axis", "axis is 0 0 0; it should be a direction, like 0 0 1");
        if (joint_.word == JointWord::ball)
            tellOfBall();
        else
            readFreedom();
        return joint_;
    }

private:
    void readWord() {
        const std::string word =
            attributes_.word("type", {"hinge", "slide", "ball", "free"}).value_or("hinge");
        joint_.word = word == "slide"  ? JointWord::slide
                      : word == "ball" ? JointWord::ball
                                       : JointWord::hinge;
    }

    /// rad of angles, which <compiler> may have in degrees; m of translations.
    double inUnits(double value) const {
        return joint_.word == JointWord::slide ? value : context_.rules.angles.radians(value);
    }

    double coordinate(const char* name) {
        return inUnits(attributes_.number(name, kCoordinate).value_or(0.0));
    }

    bool isLimited() {
        return mjcf::isLimited(attributes_, "limited", "range", context_.rules.autoLimits);
    }

    AffineForce force() const {
        const auto found = forces_.find(joint_.name);
        return found == forces_.end() ? AffineForce{} : found->second;
    }

    /// At the poses of the file, MuJoCo's coordinate is `ref`; ours is 0.
    void readFreedom() {
        engine::Freedom& freedom = joint_.freedom;
        const double ref = coordinate("ref");
        const auto range = attributes_.numbers("range", 2, 2, kCoordinate);
        if (isLimited()) {
            freedom.limits.low = inUnits(range ? (*range)[0] : 0.0) - ref;
            freedom.limits.high = inUnits(range ? (*range)[1] : 0.0) - ref;
            if (!(freedom.limits.low < freedom.limits.high)) {
                attributes_.wrong("range",
                                  "a limited joint has no valid range; it should be two numbers, "
                                  "the lower one first");
                freedom.limits = {};
            }
        }
        actAlong(attributes_, force(), coordinate("springref"), ref, freedom);
    }

    void tellOfBall() {
        for (const char* name : {"stiffness", "damping", "frictionloss", "armature"})
            if (attributes_.number(name, kStrength).value_or(0.0) > 0.0)
                attributes_.note(name,
                                 std::string(name) + " of a ball joint is not supported; left out");
        if (forces_.contains(joint_.name))
            attributes_.note("", "an actuator of a ball joint is not supported; left out");
        attributes_.numbers("range", 2, 2, kCoordinate);
        if (isLimited())
            attributes_.note("range", "range of a ball joint is not supported; left out");
    }

    Attributes attributes_;
    const Context& context_;
    const ForcesByName& forces_;
    JointAxis joint_;
};

}  // namespace

JointAxis readJoint(const JointElement& joint, const Pose& pose, const Context& context,
                    const ForcesByName& forces) {
    return JointReader(joint, context, forces).read(pose);
}

}  // namespace demos::mjcf
