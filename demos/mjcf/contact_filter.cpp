#include "demos/mjcf/contact_filter.h"

#include <algorithm>

#include "demos/scene/table_readers.h"
#include "demos/text/nearest.h"

namespace demos::mjcf {
namespace {

constexpr std::size_t kMostKinds = 1000;

struct MeetingBits {
    int contype = 1, conaffinity = 1;
    auto operator<=>(const MeetingBits&) const = default;
};

bool meet(const MeetingBits& a, const MeetingBits& b) {
    return (a.contype & b.conaffinity) != 0 || (b.contype & a.conaffinity) != 0;
}

std::string groupOf(const MeetingBits& bits) {
    return "type" + std::to_string(bits.contype) + "-affinity" + std::to_string(bits.conaffinity);
}

/// Those of the first geom that collides, as in rigid_bodies.cpp.
MeetingBits bitsOf(const Link& link) {
    for (const Geom& geom : link.geoms)
        if (geom.collides()) return {geom.contype, geom.conaffinity};
    return {0, 0};
}

/// In the order of scene.bodies: fixed bodies, then links.
std::vector<MeetingBits> bitsOf(const BodyTree& tree) {
    std::vector<MeetingBits> bits;
    for (const Geom& geom : tree.fixed) bits.push_back({geom.contype, geom.conaffinity});
    for (const Link& link : tree.links) bits.push_back(bitsOf(link));
    return bits;
}

void ignoreByBits(const BodyTree& tree, SceneDescription& scene, const Context& context) {
    const std::vector<MeetingBits> bits = bitsOf(tree);
    std::vector<MeetingBits> kinds = bits;
    std::sort(kinds.begin(), kinds.end());
    kinds.erase(std::unique(kinds.begin(), kinds.end()), kinds.end());
    std::erase(kinds, MeetingBits{0, 0});  // never collide: BodyDef::collide is false
    if (kinds.size() > kMostKinds)
        return context.diagnostics.wrong({},
                                         "more than 1000 pairs of contype and conaffinity; there "
                                         "should be fewer");
    for (std::size_t i = 0; i < bits.size(); ++i) {
        BodyDescription& body = scene.bodies[i];
        for (const MeetingBits& kind : kinds) {
            if (meet(bits[i], kind) || !body.def.collide) continue;
            body.ignores.push_back(groupOf(kind));
        }
    }
    std::vector<std::string> used;
    for (const BodyDescription& body : scene.bodies)
        used.insert(used.end(), body.ignores.begin(), body.ignores.end());
    std::sort(used.begin(), used.end());
    for (std::size_t i = 0; i < bits.size(); ++i)
        if (std::binary_search(used.begin(), used.end(), groupOf(bits[i])))
            scene.bodies[i].groups.push_back(groupOf(bits[i]));
}

class Excluder {
public:
    Excluder(const BodyTree& tree, const std::vector<int>& places, const Context& context,
             SceneDescription& scene)
        : tree_(tree), places_(places), context_(context), scene_(scene) {}

    void exclude(const Element& element) {
        Attributes attributes = context_.defaults.of(element, "");
        const int a = linkOf(attributes, "body1"), b = linkOf(attributes, "body2");
        if (a == kNone || b == kNone || a == b) return;
        if (a == kWorld || b == kWorld)
            return attributes.note("",
                                   "<exclude> with a <body> that stands still is not supported; "
                                   "left out");
        BodyDescription& one = bodyOf(a);
        BodyDescription& other = bodyOf(b);
        const std::string group = "only-" + one.name;
        if (std::find(one.groups.begin(), one.groups.end(), group) == one.groups.end())
            one.groups.push_back(group);
        other.ignores.push_back(group);
    }

private:
    static constexpr int kNone = -2;

    BodyDescription& bodyOf(int link) {
        return scene_.bodies[static_cast<std::size_t>(places_[static_cast<std::size_t>(link)])];
    }

    int linkOf(Attributes& attributes, const char* key) const {
        const auto found = tree_.bodies.find(attributes.text(key));
        if (found != tree_.bodies.end()) return found->second.link;
        std::vector<std::string> names;
        for (const auto& [name, at] : tree_.bodies) names.push_back(name);
        attributes.wrong(key, "no body is called '" + attributes.text(key) + "'" +
                                  suggestion(attributes.text(key), names));
        return kNone;
    }

    const BodyTree& tree_;
    const std::vector<int>& places_;
    const Context& context_;
    SceneDescription& scene_;
};

}  // namespace

void separate(const Element& root, const BodyTree& tree, const std::vector<int>& places,
              const Context& context, SceneDescription& scene) {
    ignoreByBits(tree, scene, context);
    Excluder excluder(tree, places, context, scene);
    for (const Element& section : root.children) {
        if (section.name != "contact") continue;
        for (const Element& element : section.children)
            if (element.name == "exclude") excluder.exclude(element);
    }
    Complaints tooMany;
    numberGroups(scene, tooMany);
    if (tooMany.count() > 0)
        context.diagnostics.wrong(root.spot,
                                  "more than 32 groups of bodies that pass through others, by "
                                  "contype, conaffinity and <exclude>; there should be fewer");
}

}  // namespace demos::mjcf
