#include "demos/mjcf/freedom.h"
#include "demos/mjcf/tendons.h"
#include "demos/scene/ranges.h"
#include "demos/text/nearest.h"

namespace demos::mjcf {
namespace {

constexpr Range kLength{-1.0, 1e5, "m"};

class SpatialTendon {
public:
    SpatialTendon(const Element& element, const BodyTree& tree, const std::vector<int>& places,
                  const Context& context)
        : element_(element),
          attributes_(context.defaults.of(element, "", "tendon")),
          tree_(tree),
          places_(places),
          context_(context) {}

    void add(const Actuation& actuation, SceneDescription& scene, Names& names) {
        if (!isStraight())
            return attributes_.note("", "a <spatial> tendon that is not straight between two "
                                        "<site>s is not supported; left out");
        const int before = context_.diagnostics.errors();
        const Whereabouts a = siteOf(element_.children.front());
        const Whereabouts b = siteOf(element_.children.back());
        if (context_.diagnostics.errors() > before || a.link == b.link) return;
        const auto driven = actuation.tendons.find(attributes_.text("name"));
        const AffineForce force =
            driven == actuation.tendons.end() ? AffineForce{} : driven->second;
        const engine::Freedom freedom =
            readFreedom(force, (a.pose.position - b.pose.position).norm());
        if (!freedom.acts()) return;
        const bool mere = !freedom.limits.any() && !freedom.motor.isOn() && freedom.inertia == 0.0;
        if (mere)
            addSpring(a, b, freedom, scene);
        else
            addJoint(a, b, freedom, scene, names);
    }

private:
    bool isStraight() const {
        return element_.children.size() == 2 && element_.children[0].name == "site" &&
               element_.children[1].name == "site";
    }

    Whereabouts siteOf(const Element& child) {
        Attributes attributes = context_.defaults.of(child, "", "");
        const std::string name = attributes.text("site");
        const auto found = tree_.sites.find(name);
        if (found != tree_.sites.end()) return found->second;
        std::vector<std::string> names;
        for (const auto& [known, at] : tree_.sites) names.push_back(known);
        attributes.wrong("site", "no site is called '" + name.substr(0, 64) + "'" +
                                     suggestion(name, names));
        return {};
    }

    engine::Freedom readFreedom(const AffineForce& force, double now) {
        engine::Freedom freedom;
        const auto given = attributes_.numbers("springlength", 1, 2, kLength);
        const bool atStart = !given || given->front() < 0.0;
        if (given && given->size() > 1 && (*given)[1] != given->front())
            attributes_.note("springlength", "a springlength of two different numbers is not "
                                             "supported; the first is used");
        actAlong(attributes_, force, atStart ? now : given->front(), 0.0, freedom);
        const auto range = attributes_.numbers("range", 2, 2, kLength);
        if (!isLimited(attributes_, "limited", "range", context_.rules.autoLimits)) return freedom;
        if (range && (*range)[0] < (*range)[1])
            freedom.limits = {(*range)[0], (*range)[1]};
        else
            attributes_.wrong("range", "a limited tendon has no valid range; it should be two "
                                       "numbers, the lower one first");
        return freedom;
    }

    int placeOf(const Whereabouts& at) const {
        return at.link == kWorld ? -1 : places_[static_cast<std::size_t>(at.link)];
    }

    static Vec3 anchorOf(const Whereabouts& at, int place, const SceneDescription& scene) {
        const Vec3& point = at.pose.position;
        return place < 0 ? point
                         : scene.bodies[static_cast<std::size_t>(place)].def.pose.toLocal(point);
    }

    void addSpring(const Whereabouts& a, const Whereabouts& b, const engine::Freedom& freedom,
                   SceneDescription& scene) const {
        engine::SpringForce spring;
        const int placeA = placeOf(a), placeB = placeOf(b);
        spring.anchorA = anchorOf(a, placeA, scene);
        spring.anchorB = anchorOf(b, placeB, scene);
        spring.length = freedom.rest;
        spring.stiffness = freedom.spring.stiffness;
        spring.damping = freedom.spring.resistance;
        scene.forces.push_back({{spring, {{placeA}, {placeB}}}, attributes_.spot().place});
    }

    void addJoint(const Whereabouts& a, const Whereabouts& b, const engine::Freedom& freedom,
                  SceneDescription& scene, Names& names) {
        attributes_.note("", "bodies held by a <spatial> tendon with a range, friction or an "
                             "actuator do not collide with each other");
        JointDescription joint;
        joint.def.type = engine::JointType::distance;
        joint.def.a = {placeOf(a)};
        joint.def.b = {placeOf(b)};
        joint.def.anchorA = anchorOf(a, joint.def.a.index, scene);
        joint.def.anchorB = anchorOf(b, joint.def.b.index, scene);
        joint.def.free[0] = freedom;
        const std::string name = attributes_.text("name");
        joint.name = names.next(name.empty() ? "tendon" : name);
        joint.place = attributes_.spot().place;
        scene.joints.push_back(std::move(joint));
    }

    const Element& element_;
    Attributes attributes_;
    const BodyTree& tree_;
    const std::vector<int>& places_;
    const Context& context_;
};

}  // namespace

void addSpatialTendons(const Element& root, const BodyTree& tree, const std::vector<int>& places,
                       const Context& context, const Actuation& actuation,
                       SceneDescription& scene, Names& names) {
    for (const Element& section : root.children) {
        if (section.name != "tendon") continue;
        for (const Element& element : section.children)
            if (element.name == "spatial")
                SpatialTendon(element, tree, places, context).add(actuation, scene, names);
    }
}

}  // namespace demos::mjcf
