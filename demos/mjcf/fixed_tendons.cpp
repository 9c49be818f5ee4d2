#include <map>
#include <string>
#include <vector>

#include "demos/mjcf/freedom.h"
#include "demos/mjcf/tendons.h"
#include "demos/text/nearest.h"

namespace demos::mjcf {
namespace {

constexpr Range kCoefficient{-1e6, 1e6};

struct Pulled {
    std::string joint;
    double coefficient = 0.0;
    double rest = 0.0;  // m or rad, where the joint's own spring is at rest
};

/// The joints of a model by name; of equal names, the first.
using JointsByName = std::map<std::string, const JointElement*>;

JointsByName jointsOf(const BodyTree& tree, const Context& context) {
    JointsByName joints;
    for (const Link& link : tree.links)
        for (const JointElement& joint : link.joints)
            joints.emplace(context.defaults.of(*joint.element, joint.childclass).text("name"), &joint);
    return joints;
}

class FixedTendon {
public:
    FixedTendon(const Element& element, const JointsByName& joints, const Context& context)
        : attributes_(context.defaults.of(element, "", "tendon")), context_(context) {
        for (const Element& child : element.children)
            if (child.name == "joint") addJoint(child, joints);
    }

    /// Length L = sum c_i q_i; a force F along L acts as c_i F along q_i.
    void add(Actuation& actuation) {
        AffineForce force;
        const auto driven = actuation.tendons.find(attributes_.text("name"));
        if (driven != actuation.tendons.end()) force = driven->second;
        force += ownForce();
        tellOfRest();
        if (!force.isConstant() && joints_.size() > 1)
            return attributes_.note("", "a <fixed> tendon of several joints with a spring, a "
                                        "damper or an actuator whose force depends on it is not "
                                        "supported; left out");
        for (const Pulled& pulled : joints_)
            if (force.constant != 0.0 || !force.isConstant())
                actuation.joints[pulled.joint] += force.geared(pulled.coefficient);
    }

private:
    void addJoint(const Element& child, const JointsByName& joints) {
        Attributes attributes = context_.defaults.of(child, "");
        Pulled pulled{attributes.text("joint"), 0.0, 0.0};
        pulled.coefficient = attributes.number("coef", kCoefficient).value_or(1.0);
        if (const auto found = joints.find(pulled.joint); found != joints.end()) {
            Attributes of = context_.defaults.of(*found->second->element, found->second->childclass);
            pulled.rest = restOf(of);
            return joints_.push_back(pulled);
        }
        std::vector<std::string> names;
        for (const auto& [name, joint] : joints) names.push_back(name);
        attributes.wrong("joint", "no joint is called '" + pulled.joint.substr(0, 64) + "'" +
                                      suggestion(pulled.joint, names));
    }

    double restOf(Attributes& joint) const {
        const double rest = joint.number("springref", kCoefficient).value_or(0.0);
        return joint.text("type") == "slide" ? rest : context_.rules.angles.radians(rest);
    }

    /// At rest at `springlength`, or where the springs of its joints are.
    AffineForce ownForce() {
        const double stiffness = attributes_.number("stiffness", kStrength).value_or(0.0);
        const double damping = attributes_.number("damping", kStrength).value_or(0.0);
        double rest = 0.0;
        for (const Pulled& pulled : joints_) rest += pulled.coefficient * pulled.rest;
        const auto given = attributes_.numbers("springlength", 1, 2, kCoefficient);
        if (given && given->front() >= 0.0) rest = given->front();
        if (stiffness > 0.0 && given && given->size() > 1 && (*given)[1] != given->front())
            attributes_.note("springlength", "a springlength of two different numbers is not "
                                             "supported; the first is used");
        return {stiffness * rest, stiffness, damping};
    }

    void tellOfRest() {
        for (const char* name : {"frictionloss", "armature"})
            if (attributes_.number(name, kStrength).value_or(0.0) > 0.0)
                attributes_.note(name, std::string(name) + " of a <fixed> tendon is not supported; "
                                                           "left out");
        if (isLimited(attributes_, "limited", "range", context_.rules.autoLimits))
            attributes_.note("range", "range of a <fixed> tendon is not supported; left out");
    }

    Attributes attributes_;
    const Context& context_;
    std::vector<Pulled> joints_;
};

}  // namespace

void addFixedTendons(const Element& root, const BodyTree& tree, const Context& context,
                     Actuation& actuation) {
    const JointsByName joints = jointsOf(tree, context);
    for (const Element& section : root.children) {
        if (section.name != "tendon") continue;
        for (const Element& element : section.children)
            if (element.name == "fixed") FixedTendon(element, joints, context).add(actuation);
    }
}

}  // namespace demos::mjcf
