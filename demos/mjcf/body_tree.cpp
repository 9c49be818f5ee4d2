#include "demos/mjcf/body_tree.h"

#include <algorithm>

#include "demos/scene/ranges.h"

namespace demos::mjcf {
namespace {

constexpr std::size_t kMostBodies = 10'000;
constexpr Range kMass{0.0, 1e9, "kg"};
constexpr Range kInertia{-1e12, 1e12, "kg m^2"};
constexpr double kRounded = 1e-6;  // share of their sum by which moments may miss A + B >= C

bool makesBodies(const std::string& element) {
    constexpr std::string_view kMakers[] = {"composite", "flexcomp", "replicate", "attach"};
    return std::find(std::begin(kMakers), std::end(kMakers), element) != std::end(kMakers);
}

/// By the three leading minors (Sylvester).
bool isPositiveDefinite(const Mat3& m) {
    const double second = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
    return m(0, 0) > 0.0 && second > 0.0 && m.determinant() > 0.0;
}

/// A + B >= C for the principal moments. As tr I / 2 - A = (B + C - A) / 2 and so on, it means that
/// tr I / 2 - I, the second moments of the mass, is positive semidefinite.
bool keepsTriangle(const Mat3& inertia) {
    const double trace = inertia.trace();
    if (trace <= 0.0) return true;
    const Mat3 moments = (0.5 + kRounded) * Mat3::Identity() - inertia / trace;
    return isPositiveDefinite(moments);
}

/// Reports an inertia that no rigid body can have; `name`: its attribute.
void checkInertia(Attributes& attributes, const char* name, const Mat3& inertia) {
    const bool full = name == std::string_view("fullinertia");
    const std::string is = std::string(name) + " is '" + attributes.text(name).substr(0, 64);
    if (full && !isPositiveDefinite(inertia))
        attributes.wrong(name, is + "'; it should be positive definite (xx yy zz xy xz yz)");
    else if (!full && inertia.diagonal().minCoeff() < 0.0)
        attributes.wrong(name, is + "'; it should not be negative");
    else if (!keepsTriangle(inertia))
        attributes.wrong(name, is + "'; no moment should be larger than the sum of the others");
}

class TreeBuilder {
public:
    explicit TreeBuilder(const Context& context) : context_(context) {}

    BodyTree build(const Element& root) {
        tree_.bodies["world"] = {};
        for (const Element& element : root.children)
            if (element.name == "worldbody") readChildren(element, {kWorld, {}}, "");
        if (tree_.links.size() + tree_.fixed.size() > kMostBodies)
            context_.diagnostics.wrong(root.spot,
                                       "more than 10000 bodies; a model should have fewer");
        return std::move(tree_);
    }

private:
    /// The masses of the <geom>s and the <inertial> of one <body>, in the axes of its link.
    struct Weights {
        int body = 0;  // its number
        std::vector<MassProperties> geoms;
        std::optional<MassProperties> given;
    };

    void readChildren(const Element& around, const Whereabouts& at, const std::string& childclass) {
        Weights weights;
        weights.body = ++bodiesRead_;
        readInside(around, at, at.pose, childclass, weights);
        if (at.link != kWorld) weigh(around, weights, link(at.link));
        for (const Element& child : around.children) readInner(child, at.link, at.pose, childclass);
    }

    Link& link(int number) { return tree_.links[static_cast<std::size_t>(number)]; }

    /// Reads the <geom>s and the <inertial> of a <body>, including those in its <frame>s.
    void readInside(const Element& around, const Whereabouts& at, const Pose& pose,
                    const std::string& childclass, Weights& weights) {
        for (const Element& child : around.children) {
            if (makesBodies(child.name)) noteLacking(child.name, at.link);
            if (child.name == "site") addSite(child, at, pose, childclass);
            if (child.name == "geom") addGeom(child, at, pose, childclass, weights);
            if (child.name == "inertial") weights.given = readInertial(child, at, pose);
            if (child.name == "frame")
                readInside(child, at, pose * poseOf(child),
                           context_.defaults.childclass(child, childclass), weights);
        }
    }

    void noteLacking(const std::string& element, int number) {
        tree_.lacking = element;
        if (number != kWorld) link(number).lacking = element;
    }

    void refuse(int number) {
        if (number != kWorld) link(number).refused = true;
    }

    /// Reads the <body>s in a <body> or in its <frame>s.
    void readInner(const Element& child, int around, const Pose& pose,
                   const std::string& childclass) {
        const std::string inside = context_.defaults.childclass(child, childclass);
        if (child.name == "body") readBody(child, around, pose, inside);
        if (child.name != "frame") return;
        const Pose frame = pose * poseOf(child);
        for (const Element& inner : child.children) readInner(inner, around, frame, inside);
    }

    Pose poseOf(const Element& element) const {
        Attributes attributes = context_.defaults.of(element, "");
        return readPose(attributes, context_.rules.angles);
    }

    void readBody(const Element& body, int around, const Pose& outer,
                  const std::string& childclass) {
        const Pose pose = outer * poseOf(body);
        Whereabouts at{around, pose};
        std::vector<JointElement> joints;
        const int free = readJoints(body, childclass, joints);
        const bool isFree = free > 0;
        if (free > 1 || (isFree && (around != kWorld || !joints.empty())))
            context_.diagnostics.wrong(body.spot,
                                       "a free joint with other joints, or in a moving <body>; "
                                       "it should be the only joint of a <body> in <worldbody>");
        if (isMocap(body))
            joints.clear();
        else if (isFree || !joints.empty())
            at.link = addLink(body, around, pose, std::move(joints));
        addName(body, at);
        readChildren(body, at, childclass);
    }

    bool isMocap(const Element& body) const {
        Attributes attributes = context_.defaults.of(body, "");
        const bool mocap = attributes.truth("mocap").value_or(false);
        if (mocap)
            attributes.note("mocap", "a mocap <body> is moved by a program; it stands still here");
        return mocap;
    }

    /// Gives the number of free joints, which are not added to `joints`.
    int readJoints(const Element& body, const std::string& childclass,
                   std::vector<JointElement>& joints) const {
        int free = 0;
        for (const Element& child : body.children) {
            if (child.name == "freejoint") ++free;
            if (child.name != "joint") continue;
            if (context_.defaults.of(child, childclass).text("type") == "free")
                ++free;
            else
                joints.push_back({&child, childclass});
        }
        return free;
    }

    int addLink(const Element& body, int around, const Pose& pose,
                std::vector<JointElement> joints) {
        Link link;
        const Attribute* name = body.find("name");
        link.name = name ? name->value : "";
        link.parent = around;
        link.pose = pose;
        link.joints = std::move(joints);
        link.spot = body.spot;
        tree_.links.push_back(std::move(link));
        return static_cast<int>(tree_.links.size()) - 1;
    }

    void addName(const Element& body, const Whereabouts& at) {
        const Attribute* name = body.find("name");
        if (!name || name->value.empty()) return;
        if (!tree_.bodies.emplace(name->value, at).second)
            context_.diagnostics.wrong(name->spot,
                                       "two bodies are called '" + name->value + "'; rename one");
    }

    /// `inner`, given in the axes of `pose`, in those of the link.
    Pose inLink(const Whereabouts& at, const Pose& pose, const Pose& inner) {
        const Pose world = pose * inner;
        if (at.link == kWorld) return world;
        const Pose& own = link(at.link).pose;
        return {own.toLocal(world.position),
                (own.rotation.conjugate() * world.rotation).normalized()};
    }

    void addGeom(const Element& element, const Whereabouts& at, const Pose& pose,
                 const std::string& childclass, Weights& weights) {
        const int before = context_.diagnostics.errors();
        std::optional<Geom> geom = readGeom(element, childclass, context_);
        if (!geom) {
            // An invalid mesh is reported with its <asset>; other types are left out with a note.
            const bool isMesh = context_.defaults.of(element, childclass).text("type") == "mesh";
            if (isMesh || context_.diagnostics.errors() > before) refuse(at.link);
            return;
        }
        const Pose there = inLink(at, pose, {});
        geom->pose = there * geom->pose;
        geom->properties = placed(geom->properties, there);
        geom->body = weights.body;
        if (at.link == kWorld) {
            tree_.fixed.push_back(std::move(*geom));
            return;
        }
        if (geom->shape.type == engine::ShapeType::plane) {
            refuse(at.link);
            return context_.diagnostics.wrong(geom->spot,
                                              "a plane in a <body> that moves; it should be "
                                              "in <worldbody>, or a box");
        }
        weights.geoms.push_back(geom->properties);
        link(at.link).geoms.push_back(std::move(*geom));
    }

    /// The point of a <site>, or the middle of its fromto.
    void addSite(const Element& element, const Whereabouts& at, const Pose& pose,
                 const std::string& childclass) {
        Attributes attributes = context_.defaults.of(element, childclass);
        const std::string name = attributes.text("name");
        if (name.empty()) return;
        Vec3 point = attributes.vector("pos", kMeters).value_or(Vec3(0, 0, 0));
        if (const auto ends = attributes.numbers("fromto", 6, 6, kMeters))
            for (int i = 0; i < 3; ++i)
                point[i] = 0.5 * ((*ends)[static_cast<std::size_t>(i)] +
                                  (*ends)[static_cast<std::size_t>(i + 3)]);
        if (!tree_.sites.emplace(name, Whereabouts{at.link, {pose.toWorld(yUp(point)), Quat::Identity()}}).second)
            attributes.wrong("name", "two sites are called '" + name.substr(0, 64) + "'; rename one");
    }

    std::optional<MassProperties> readInertial(const Element& element, const Whereabouts& at,
                                               const Pose& pose) {
        const int before = context_.diagnostics.errors();
        Attributes attributes = context_.defaults.of(element, "");
        const Pose own = readPose(attributes, context_.rules.angles);
        MassProperties given;
        const std::optional<double> mass = attributes.number("mass", kMass);
        if (!attributes.has("mass"))
            attributes.wrong("", "an <inertial> has no mass; write mass=\"1\" (kg)");
        given.mass = mass.value_or(0.0);
        given.inertia = yUp(readInertia(attributes, context_.rules.inertiaFromGeom != "true"));
        if (context_.diagnostics.errors() > before) refuse(at.link);
        return placed(given, inLink(at, pose, own));
    }

    /// kg m^2, in the axes of the file. `counts`: the inertia of the <geom>s does not replace it.
    static Mat3 readInertia(Attributes& attributes, bool counts) {
        Mat3 inertia = Mat3::Zero();
        const auto full = attributes.numbers("fullinertia", 6, 6, kInertia);
        const std::optional<Vec3> diagonal = attributes.vector("diaginertia", kInertia);
        if (diagonal) inertia.diagonal() = *diagonal;
        if (full) {
            const std::vector<double>& n = *full;  // xx yy zz xy xz yz
            inertia << n[0], n[3], n[4], n[3], n[1], n[5], n[4], n[5], n[2];
        }
        if (counts && (full || diagonal))
            checkInertia(attributes, full ? "fullinertia" : "diaginertia", inertia);
        if (!attributes.has("fullinertia") && !attributes.has("diaginertia"))
            attributes.wrong("", "an <inertial> has no inertia; write diaginertia or fullinertia");
        return inertia;
    }

    /// <inertial> takes precedence unless <compiler> sets inertiafromgeom.
    void weigh(const Element& body, const Weights& weights, Link& link) {
        const std::string& rule = context_.rules.inertiaFromGeom;
        if (weights.given && rule != "true") {
            link.masses.push_back(*weights.given);
            link.ownInertia = true;
        } else if (rule == "false") {
            context_.diagnostics.wrong(body.spot,
                                       "a <body> that moves has no <inertial>, and "
                                       "inertiafromgeom is 'false'; write one");
        } else {
            link.masses.push_back(together(weights.geoms));
        }
    }

    const Context& context_;
    BodyTree tree_;
    int bodiesRead_ = 0;
};

}  // namespace

BodyTree readBodies(const Element& root, const Context& context) {
    return TreeBuilder(context).build(root);
}

}  // namespace demos::mjcf
