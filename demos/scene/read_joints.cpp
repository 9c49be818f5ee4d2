// [[joint]]

#include <set>

#include "demos/scene/nearest.h"
#include "demos/scene/read_parts.h"

namespace demos {
namespace {

constexpr Range kMeters{-1e5, 1e5, "m"};
constexpr double kShortest = 1e-3;  // m, of a distance joint

class JointReader {
public:
    JointReader(const Instance& instance, const BodyNumbers& numbers, const SceneDescription& scene,
                Complaints& complaints)
        : instance_(instance),
          numbers_(numbers),
          scene_(scene),
          complaints_(complaints),
          before_(complaints.count()),
          keys_(instance.keys("a [[joint]]", complaints)) {
        joint_.place = instance.table->place;
    }

    JointDescription read() {
        readType();
        readBodies();
        readName();
        readAnchors();
        readAxis();
        readSpring();
        keys_.later({"limits", "limits_deg", "motor", "break_at"});
        keys_.done();
        return joint_;
    }

private:
    engine::JointDef& def() { return joint_.def; }
    int a() const { return joint_.def.a.index; }
    int b() const { return joint_.def.b.index; }

    bool good() const { return complaints_.count() == before_; }

    void readType() {
        if (!keys_.has("type"))
            keys_.complain("type",
                           "a [[joint]] has no type; write type = \"ball\", or distance, "
                           "hinge, weld");
        const std::optional<std::string> type =
            keys_.word("type", {"ball", "distance", "hinge", "weld"},
                       {"slider", "universal", "look-at", "axis", "six-dof"});
        if (!type) return;
        type_ = *type;
        def().type = type_ == "ball"       ? engine::JointType::ball
                      : type_ == "distance" ? engine::JointType::distance
                      : type_ == "hinge"    ? engine::JointType::hinge
                                            : engine::JointType::weld;
    }

    /// The place in scene.bodies; -1 for 'world' and for what is wrong.
    int readBody(const char* key) {
        if (!keys_.has(key))
            keys_.complain(key, std::string("a [[joint]] has no ") + key + "; write " + key +
                                    " = \"NAME\" of a body, or \"world\"");
        const std::optional<std::string> text = keys_.text(key);
        if (!text) return -1;
        const std::string name = instance_.named(*text);
        if (name == "world") return -1;
        const auto found = numbers_.find(name);
        if (found != numbers_.end()) return found->second;
        std::vector<std::string> names = bodyNames(scene_);
        names.push_back("world");
        keys_.complain(key, "no body is called '" + name + "'" + suggestion(name, names));
        return -1;
    }

    bool isDynamic(int body) const {
        return body >= 0 && scene_.bodies[body].def.kind == engine::BodyKind::dynamic;
    }

    void readBodies() {
        const int before = complaints_.count();
        def().a = {readBody("a")};
        def().b = {readBody("b")};
        if (complaints_.count() > before) return;
        if (a() == b())
            keys_.complain("b", "a joint of '" + nameOf(b()) +
                                    "' with itself; a and b should be two bodies");
        else if (!isDynamic(a()) && !isDynamic(b()))
            keys_.complain("b", "neither '" + nameOf(a()) + "' nor '" + nameOf(b()) +
                                    "' can be moved; one of a joint's bodies should be dynamic");
    }

    const std::string& nameOf(int body) const {
        static const std::string world = "world";
        return body < 0 ? world : scene_.bodies[body].name;
    }

    void readName() {
        joint_.name = nameOf(a()) + "-" + nameOf(b());
        const std::optional<std::string> text = keys_.text("name");
        if (!text) return;
        const std::string name = instance_.named(*text);
        if (checkName(name, keys_.placeOf("name"), "name", complaints_)) joint_.name = name;
    }

    engine::Pose poseOf(int body) const {
        return body < 0 ? engine::Pose{} : scene_.bodies[body].def.pose;
    }

    /// In body axes; those of the world are moved by [[repeat]], like a body would be.
    Vec3 local(int body, const Vec3& anchor) const {
        return body < 0 ? instance_.point(anchor) : anchor;
    }

    void readAnchors() {
        const std::optional<Vec3> anchor = keys_.vector("anchor", kMeters);
        const std::optional<Vec3> anchorA = keys_.vector("anchor_a", kMeters);
        const std::optional<Vec3> anchorB = keys_.vector("anchor_b", kMeters);
        if (type_ == "distance") return placeDistance(anchorA, anchorB);
        const bool one = keys_.has("anchor");
        const bool two = keys_.has("anchor_a") && keys_.has("anchor_b");
        const bool any = keys_.has("anchor_a") || keys_.has("anchor_b");
        if ((one && any) || (!one && !two)) {
            keys_.complain(one ? "anchor" : "type",
                           "give either anchor (a point of the world) or both anchor_a and "
                           "anchor_b (points of the bodies)");
            return;
        }
        if (anchor) {
            const Vec3 point = instance_.point(*anchor);
            def().anchorA = poseOf(a()).toLocal(point);
            def().anchorB = poseOf(b()).toLocal(point);
        } else if (anchorA && anchorB) {
            def().anchorA = local(a(), *anchorA);
            def().anchorB = local(b(), *anchorB);
        }
    }

    void placeDistance(const std::optional<Vec3>& anchorA, const std::optional<Vec3>& anchorB) {
        if (keys_.has("anchor"))
            keys_.complain("anchor", "a distance joint has two ends: give anchor_a and anchor_b");
        const char* worldEnd = a() < 0 ? "anchor_a" : b() < 0 ? "anchor_b" : nullptr;
        if (good() && worldEnd && !keys_.has(worldEnd))
            keys_.complain("type", std::string("the world has no centre; give ") + worldEnd +
                                       ", a point of the world");
        def().anchorA = local(a(), anchorA.value_or(Vec3(0, 0, 0)));
        def().anchorB = local(b(), anchorB.value_or(Vec3(0, 0, 0)));
        def().length =
            (poseOf(b()).toWorld(def().anchorB) - poseOf(a()).toWorld(def().anchorA))
                .norm();
        if (good() && def().length < kShortest)
            keys_.complain("type", "the ends of a distance joint are " + numberText(def().length) +
                                       " m apart; they should be at least 0.001 m: or use a ball");
    }

    void readAxis() {
        const std::optional<Vec3> axis = keys_.vector("axis", {-1e6, 1e6});
        if (type_ == "hinge" && !keys_.has("axis"))
            keys_.complain("type", "a hinge has no axis; write axis = [0, 0, 1]");
        if (!type_.empty() && type_ != "hinge" && keys_.has("axis"))
            keys_.complain("axis", "a " + type_ + " joint has no axis; leave it out");
        if (!axis) return;
        if (axis->norm() > 1e-6)
            def().axis = instance_.direction(axis->normalized());
        else
            keys_.complain("axis", "axis is [0, 0, 0]; it should be a direction, like [0, 0, 1]");
    }

    void readSpring() {
        const Value* table = keys_.any("spring");
        if (!table) return;
        Keys keys = keys_.inner(*table, "a spring");
        if (!keys.has("hz"))
            keys.complain("hz", "a spring has no frequency; write spring = { hz = 2, damping = 0.5 }");
        def().spring.hz = keys.number("hz", {1e-3, 1e3, "hz"}).value_or(1.0);
        def().spring.damping = keys.number("damping", {0.0, 100.0}).value_or(0.0);
        keys.done();
    }

    const Instance& instance_;
    const BodyNumbers& numbers_;
    const SceneDescription& scene_;
    Complaints& complaints_;
    int before_;
    Keys keys_;
    JointDescription joint_;
    std::string type_;
};

}  // namespace

void readJoints(const std::vector<Instance>& instances, const BodyNumbers& numbers,
                SceneDescription& scene, Complaints& complaints) {
    const Value* complainedOf = nullptr;  // once is enough for all turns of a [[repeat]]
    std::set<std::string> given;
    for (const Instance& instance : instances) {
        if (instance.table == complainedOf) continue;
        const int before = complaints.count();
        JointDescription joint = JointReader(instance, numbers, scene, complaints).read();
        const bool named = instance.table->find("name") != nullptr;
        if (named && !given.insert(joint.name).second)
            complaints.add(joint.place, "two joints are called '" + joint.name + "'; rename one");
        if (complaints.count() > before) complainedOf = instance.table;
        scene.joints.push_back(std::move(joint));
    }
}

}  // namespace demos
