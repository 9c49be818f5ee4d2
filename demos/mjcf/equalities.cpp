#include "demos/mjcf/equalities.h"

#include "demos/scene/ranges.h"
#include "demos/text/nearest.h"

namespace demos::mjcf {
namespace {


class EqualityReader {
public:
    EqualityReader(const Element& element, const BodyTree& tree, const std::vector<int>& places,
                   const Context& context, SceneDescription& scene)
        : attributes_(context.defaults.of(element, "", "equality")),
          tree_(tree),
          places_(places),
          scene_(scene),
          diagnostics_(context.diagnostics) {}

    void add(Names& names) {
        const int before = diagnostics_.errors();
        const bool active = attributes_.truth("active").value_or(true);
        const Whereabouts one = find("body1");
        const Whereabouts other = attributes_.has("body2") ? find("body2") : Whereabouts{};
        const Vec3 anchor = readAnchor(one);
        if (diagnostics_.errors() > before || !active) return;
        if (one.link == other.link)
            return attributes_.note("", "<" + attributes_.element() +
                                            "> within one rigid body has no effect; left out");
        attributes_.note("", "bodies held by a <" + attributes_.element() +
                                 "> are held rigidly and do not collide with each other");
        JointDescription joint;
        joint.def.type = isWeld() ? engine::JointType::weld : engine::JointType::ball;
        joint.def.a = {placeOf(one)};
        joint.def.b = {placeOf(other)};
        joint.def.anchorA = poseOf(joint.def.a).toLocal(anchor);
        joint.def.anchorB = poseOf(joint.def.b).toLocal(anchor);
        const std::string name = attributes_.text("name");
        joint.name = names.next(name.empty() ? attributes_.element() : name);
        joint.place = attributes_.spot().place;
        scene_.joints.push_back(std::move(joint));
    }

private:
    bool isWeld() const { return attributes_.element() == "weld"; }

    Whereabouts find(const char* key) {
        const std::string name = attributes_.text(key);
        const auto found = tree_.bodies.find(name);
        if (found != tree_.bodies.end()) return found->second;
        std::vector<std::string> names;
        for (const auto& [known, at] : tree_.bodies) names.push_back(known);
        attributes_.wrong(key, "no body is called '" + name + "'" + suggestion(name, names));
        return {};
    }

    /// In world axes; a <connect> gives it in those of body1.
    Vec3 readAnchor(const Whereabouts& one) {
        if (isWeld()) return one.pose.position;
        if (!attributes_.has("anchor"))
            attributes_.wrong(
                "",
                "a <connect> has no anchor; write anchor=\"0 0 0\" (m, in the axes of "
                "body1)");
        return one.pose.toWorld(yUp(attributes_.vector("anchor", kMeters).value_or(Vec3(0, 0, 0))));
    }

    int placeOf(const Whereabouts& at) const {
        return at.link == kWorld ? -1 : places_[static_cast<std::size_t>(at.link)];
    }

    Pose poseOf(engine::BodyId body) const {
        return body.index < 0 ? Pose{}
                              : scene_.bodies[static_cast<std::size_t>(body.index)].def.pose;
    }

    Attributes attributes_;
    const BodyTree& tree_;
    const std::vector<int>& places_;
    SceneDescription& scene_;
    Diagnostics& diagnostics_;
};

}  // namespace

void addEqualities(const Element& root, const BodyTree& tree, const std::vector<int>& places,
                   const Context& context, SceneDescription& scene, Names& names) {
    for (const Element& section : root.children) {
        if (section.name != "equality") continue;
        for (const Element& element : section.children)
            if (element.name == "connect" || element.name == "weld")
                EqualityReader(element, tree, places, context, scene).add(names);
    }
}

}  // namespace demos::mjcf
