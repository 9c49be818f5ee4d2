#include "demos/mjcf/rigid_bodies.h"

#include <algorithm>
#include <set>

#include "demos/scene/read_shape.h"

namespace demos::mjcf {
namespace {

using engine::BodyKind;
using engine::Shape;
using engine::ShapePart;

constexpr double kAsideShare = 1e-9;  // of a shape's reach: tolerance of its centre of mass
constexpr double kBallRadius = 0.02;  // m, of the sphere that represents a body without a geom

/// The geoms that collide; if there are none, all, which are only drawn.
std::vector<const Geom*> solidOf(const Link& link) {
    std::vector<const Geom*> solid;
    for (const Geom& geom : link.geoms)
        if (geom.collides()) solid.push_back(&geom);
    if (solid.empty())
        for (const Geom& geom : link.geoms) solid.push_back(&geom);
    return solid;
}

bool sameSurface(const Geom& a, const Geom& b) {
    return a.friction == b.friction && a.rolling == b.rolling && a.priority == b.priority &&
           (a.condim == 1) == (b.condim == 1);
}

/// Of two geoms the larger condim and the larger friction count; condim says if there is friction.
engine::Material surfaceOf(const Geom& geom) {
    engine::Material surface;
    surface.friction = geom.friction;
    surface.rolling = geom.rolling;
    surface.frictionRule =
        geom.condim == 1 ? engine::FrictionRule::none : engine::FrictionRule::larger;
    surface.priority = geom.priority;
    return surface;
}

class BodyMaker {
public:
    BodyMaker(const BodyTree& tree, const Context& context, SceneDescription& scene)
        : context_(context), scene_(scene) {
        for (const Geom& geom : tree.fixed)
            if (geom.isShown) shownBodies_.insert(geom.body);
    }

    void addFixed(const Geom& geom) {
        BodyDescription body;
        body.def.kind = BodyKind::fixed;
        body.def.shape = geom.shape;
        body.def.pose = geom.pose;
        if (!geom.isShown && shownBodies_.contains(geom.body))
            body.looks.emplace();
        else if (geom.picture)
            body.looks = {{*geom.picture, Pose{}}};
        add(std::move(body), geom.name.empty() ? geom.type : geom.name, geom, geom.spot);
    }

    void addMoving(const Link& link) {
        const MassProperties whole = together(link.masses);
        if (!isMovable(whole) && !link.refused)
            context_.diagnostics.wrong(
                link.spot,
                "a <body> with a joint has no mass to move, or no inertia (mass " +
                    numberText(whole.mass) + " kg); it should have <geom>s, or an <inertial>" +
                    (link.lacking.empty() ? "" : ": its <" + link.lacking + "> is not supported"));
        BodyDescription body;
        body.def.mass = whole.mass;
        const std::vector<const Geom*> solid = solidOf(link);
        if (solid.size() > kMostParts)
            return context_.diagnostics.wrong(link.spot, "a <body> has " + std::to_string(solid.size()) +
                                                             " <geom>s that collide; it should have at most " +
                                                             std::to_string(kMostParts));
        if (solid.size() == 1 && isCentred(*solid.front(), whole))
            takeShape(link, *solid.front(), whole, body.def);
        else
            takeParts(link, solid, whole, body.def);
        tellOfDifferent(link, solid);
        dress(link, solid, body);
        Geom none;
        none.contype = none.conaffinity = 0;
        const Geom& first = solid.empty() ? none : *solid.front();
        add(std::move(body), link.name.empty() ? "body" : link.name, first, link.spot);
    }

private:
    static bool isCentred(const Geom& geom, const MassProperties& whole) {
        return (geom.pose.position - whole.centre).norm() <=
               kAsideShare * engine::reachOf(geom.shape);
    }

    /// In the axes of the shape itself.
    static void takeShape(const Link& link, const Geom& geom, const MassProperties& whole,
                          engine::BodyDef& def) {
        def.shape = geom.shape;
        def.pose = link.pose * geom.pose;
        if (link.ownInertia || link.geoms.size() > 1)
            def.inertia = placed(whole, {{0, 0, 0}, geom.pose.rotation.conjugate()}).inertia;
    }

    /// In the axes of the link, about its centre of mass.
    static void takeParts(const Link& link, const std::vector<const Geom*>& solid,
                          const MassProperties& whole, engine::BodyDef& def) {
        std::vector<ShapePart> parts;
        for (const Geom* geom : solid) parts.push_back({geom->shape, geom->pose});
        def.shape =
            parts.empty() ? Shape::sphere(kBallRadius) : Shape::compound(parts, whole.centre);
        def.pose = {link.pose.toWorld(whole.centre), link.pose.rotation};
        def.inertia = whole.inertia;
    }

    /// Draws the geoms that MuJoCo's viewer shows, or else those that collide.
    static void dress(const Link& link, const std::vector<const Geom*>& solid,
                      BodyDescription& body) {
        std::vector<const Geom*> shown;
        for (const Geom& geom : link.geoms)
            if (geom.isShown) shown.push_back(&geom);
        if (shown.empty()) shown = solid;
        bool same = shown == solid;
        for (const Geom* geom : shown) same = same && !geom->picture;
        if (!shown.empty()) body.color = shown.front()->color;
        if (same) return;
        body.looks.emplace();
        for (const Geom* geom : shown) {
            const Pose there = link.pose * geom->pose;
            const Quat turn = body.def.pose.rotation.conjugate() * there.rotation;
            body.looks->push_back({geom->picture.value_or(geom->shape),
                                   {body.def.pose.toLocal(there.position), turn.normalized()}});
        }
    }

    void tellOfDifferent(const Link& link, const std::vector<const Geom*>& solid) {
        for (const Geom& geom : link.geoms) {
            if (!geom.collides()) continue;
            if (!sameSurface(geom, *solid.front()))
                context_.diagnostics.note(geom.spot,
                                          "friction, condim or priority differ between the <geom>s "
                                          "of a body; the first <geom>'s apply to all");
            if (geom.contype != solid.front()->contype ||
                geom.conaffinity != solid.front()->conaffinity)
                context_.diagnostics.note(geom.spot,
                                          "contype or conaffinity differ between the <geom>s of "
                                          "a body; the first <geom>'s apply to all");
        }
    }

    void add(BodyDescription body, const std::string& name, const Geom& first, const Spot& spot) {
        body.name = names_.next(name);
        if (!body.color) body.color = first.color;
        body.place = body.ignoresPlace = spot.place;
        body.def.material = surfaceOf(first);
        body.def.collide = first.collides() && context_.rules.contacts;
        if (body.def.pose.position.cwiseAbs().maxCoeff() > 1e5)
            context_.diagnostics.wrong(
                spot, "a body more than 100000 m from the origin; it should be nearer");
        scene_.bodies.push_back(std::move(body));
    }

    const Context& context_;
    SceneDescription& scene_;
    Names names_;
    std::set<int> shownBodies_;  // fixed <body>s with at least one shown geom
};

}  // namespace

std::vector<int> addBodies(const BodyTree& tree, const Context& context, SceneDescription& scene) {
    BodyMaker maker(tree, context, scene);
    for (const Geom& geom : tree.fixed) maker.addFixed(geom);
    std::vector<int> places;
    for (const Link& link : tree.links) {
        places.push_back(static_cast<int>(scene.bodies.size()));
        maker.addMoving(link);
    }
    return places;
}

std::string Names::next(const std::string& wanted) {
    constexpr std::size_t kLongest = 56;  // of 64: leaves room for a number
    std::string name = wanted.empty() ? "body" : wanted.substr(0, kLongest);
    for (char& c : name) {
        const bool usual =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (!usual && std::string_view("_.{}+-").find(c) == std::string_view::npos) c = '_';
    }
    std::string numbered = name;
    int& last = counts_[name];
    while (last > 0 && counts_.contains(numbered)) numbered = name + "-" + std::to_string(++last);
    last = std::max(last, 1);
    counts_.emplace(numbered, 1);
    return numbered;
}

}  // namespace demos::mjcf
