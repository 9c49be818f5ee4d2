// [[joint]]

#include <set>

#include "demos/scene/joint_kinds.h"
#include "demos/scene/ranges.h"
#include "demos/scene/read_freedom.h"
#include "demos/scene/table_readers.h"
#include "demos/text/nearest.h"
#include "engine/base/trigonometry.h"

namespace demos {
namespace {

using engine::JointType;

constexpr double kShortest = 1e-3;  // m, between the ends of a distance joint

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
        if (!kind_) return joint_;
        checkJointKeys(keys_, *kind_);
        readBodies();
        readName();
        readAnchors();
        readAxes();
        readCoordinates();
        readBreaking();
        readRest();
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
            keys_.complain("type", "a [[joint]] has no type; write type = \"ball\", or " +
                                       anyOf(jointKindNames()));
        const std::optional<std::string> type = keys_.word("type", jointKindNames());
        for (const JointKind& kind : jointKinds())
            if (type == kind.name) kind_ = &kind;
        if (kind_) def().type = kind_->type;
    }

    /// The index in scene.bodies; -1 for 'world' and after an error.
    int readBody(const char* key) {
        if (!keys_.has(key))
            keys_.complain(key, std::string("a [[joint]] has no ") + key + "; write " + key +
                                    " = \"NAME\" of a body, or \"world\"");
        const std::optional<std::string> text = keys_.text(key);
        if (!text) return -1;
        const int before = complaints_.count();
        const std::string name = instance_.named(*text, keys_, key);
        if (name == "world" || complaints_.count() > before) return -1;
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
            keys_.complain(
                "b", "a joint of '" + nameOf(b()) + "' with itself; a and b should differ");
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
        const int before = complaints_.count();
        const std::string name = instance_.named(*text, keys_, "name");
        if (complaints_.count() > before) return;
        if (checkName(name, keys_.placeOf("name"), "name", complaints_)) joint_.name = name;
    }

    engine::Pose poseOf(int body) const {
        return body < 0 ? engine::Pose{} : scene_.bodies[body].def.pose;
    }

    /// From the origin of the body's shape, as written, to its centre of mass. Points of the world
    /// are moved by [[repeat]] like a body.
    Vec3 local(int body, const Vec3& point) const {
        return body < 0 ? instance_.point(point)
                        : Vec3(point + scene_.bodies[body].def.shape.origin);
    }

    void readAnchors() {
        const std::optional<Vec3> anchor = keys_.vector("anchor", kMeters);
        const std::optional<Vec3> anchorA = keys_.vector("anchor_a", kMeters);
        const std::optional<Vec3> anchorB = keys_.vector("anchor_b", kMeters);
        if (!kind_->has("anchor")) return placeEnds(anchorA, anchorB);
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

    /// Two separate points; the centres of mass by default.
    void placeEnds(const std::optional<Vec3>& anchorA, const std::optional<Vec3>& anchorB) {
        const char* worldEnd = a() < 0 ? "anchor_a" : b() < 0 ? "anchor_b" : nullptr;
        if (good() && worldEnd && kind_->has(worldEnd) && !keys_.has(worldEnd))
            keys_.complain("type", std::string("the world has no centre; give ") + worldEnd +
                                       ", a point of the world");
        if (anchorA) def().anchorA = local(a(), *anchorA);
        if (anchorB) def().anchorB = local(b(), *anchorB);
    }

    double endsApart() const {
        const engine::JointDef& def = joint_.def;
        return (poseOf(b()).toWorld(def.anchorB) - poseOf(a()).toWorld(def.anchorA)).norm();
    }

    void readDirection(const char* key, Vec3& direction) {
        const std::optional<Vec3> given = keys_.vector(key, {-1e6, 1e6});
        if (!given) return;
        if (given->norm() > 1e-6)
            direction = instance_.direction(given->normalized());
        else
            keys_.complain(key, std::string(key) +
                                    " is [0, 0, 0]; it should be a direction, like "
                                    "[0, 0, 1]");
    }

    void readAxes() {
        readDirection("axis", def().axis);
        readDirection("axis2", def().axis2);
        if (!good() || !keys_.has("axis2")) return;
        const bool across = def().type == JointType::universal || def().type == JointType::wheel;
        if (across && std::abs(def().axis.dot(def().axis2)) > 1e-7)
            keys_.complain("axis2",
                           "axis2 of " + kind_->text() + " should be at right angles to axis");
    }

    /// For the types with one or two free coordinates.
    void readCoordinates() {
        const bool isWay = def().type == JointType::distance || def().type == JointType::slider ||
                           def().type == JointType::wheel || def().type == JointType::path;
        const Way way = isWay ? Way::along : Way::about;
        engine::Freedom &first = def().free[0], &second = def().free[1];
        if (const auto limits = readLimits(keys_, isWay ? "limits" : "limits_deg", way))
            first.limits = *limits;
        if (const auto limits = readLimits(keys_, "limits2_deg", Way::about))
            second.limits = *limits;
        const bool spins = def().type == JointType::wheel;
        if (const auto motor = readMotor(keys_, "motor", spins ? Way::about : way))
            (spins ? second : first).motor = *motor;
        if (const auto motor = readMotor(keys_, "motor2", Way::about)) second.motor = *motor;
        if (const auto twist = readLimits(keys_, "twist_deg", Way::about)) first.limits = *twist;
        if (const auto swing = keys_.number("swing_deg", {0.0, 180.0, "deg"}))
            second.limits.high = engine::radians(*swing);
        if (const auto inertia = readInertia(keys_, "inertia", way)) first.inertia = *inertia;
        if (kind_->has("soft")) readRestingSpring(keys_, "spring", way, first);
        def().spring =
            readSpring(keys_, kind_->has("soft") ? "soft" : "spring").value_or(engine::Spring{});
    }

    void readBreaking() {
        const Range newtons{1e-6, 1e12, "N"}, newtonMetres{1e-6, 1e12, "N m"};
        def().breakForce = keys_.number("break_at", newtons).value_or(engine::kUnlimited);
        def().breakTorque = keys_.number("break_torque", newtonMetres).value_or(engine::kUnlimited);
    }

    /// Keys of a single type.
    void readRest() {
        const bool limited = keys_.has("twist_deg") || keys_.has("swing_deg");
        if (def().type == JointType::ball && limited && !keys_.has("axis"))
            keys_.complain("type", "twist_deg and swing_deg need an axis; write axis = [0, 1, 0]");
        if (def().type == JointType::distance) readLength();
        if (def().type == JointType::sixDof) readSixDof();
        if (def().type == JointType::gear) readRatio();
        if (def().type == JointType::path) readPath();
        if (def().type == JointType::lookAt && good() && endsApart() < kShortest)
            keys_.complain("type",
                           "the ends of a look-at joint are at the same point; they should be at "
                           "least 0.001 m apart: b looks from anchor_b at anchor_a");
    }

    void readLength() {
        const auto length = keys_.number("length", {kShortest, 1e5, "m"});
        def().length = length.value_or(endsApart());
        if (def().free[0].limits.low < 0.0 && keys_.has("limits"))
            keys_.complain("limits", "limits of a distance joint should not be below 0");
        const bool held = def().spring.isSoft() || !def().acts();
        if (good() && held && def().length < kShortest)
            keys_.complain("type", "the ends of a distance joint are " + numberText(def().length) +
                                       " m apart; they should be at least 0.001 m apart, or use a "
                                       "ball");
    }

    void readSixDof() {
        constexpr const char* kNames[] = {"x", "y", "z", "rx", "ry", "rz"};
        bool any = false;
        for (std::size_t i = 0; i < 6; ++i) {
            def().free[i] = readFreedom(keys_, kNames[i], i < 3 ? Way::along : Way::about);
            any = any || def().free[i].locked || def().free[i].acts();
        }
        if (good() && !any)
            keys_.complain("type",
                           "a six-dof joint that leaves everything free; write x = "
                           "\"locked\", or y, z, rx, ry, rz");
        if (keys_.has("axis") != keys_.has("axis2"))
            keys_.complain(keys_.has("axis") ? "axis" : "axis2",
                           "a six-dof joint has axis (its x) and axis2 (its y), or neither for "
                           "the world's axes");
        else if (good() && keys_.has("axis") && def().axis.cross(def().axis2).norm() < 1e-3)
            keys_.complain("axis2", "axis2 should not be parallel to axis");
    }

    void readRatio() {
        def().ratio = keys_.number("ratio", {-1e4, 1e4}).value_or(1.0);
        if (std::abs(def().ratio) >= 1e-4) return;
        keys_.complain("ratio", "ratio is " + numberText(def().ratio) +
                                    "; it should be from 0.0001 to 10000, or -10000 to -0.0001");
    }

    void readPath() {
        constexpr std::size_t kMostPoints = 1000;
        def().closed = keys_.truth("closed").value_or(false);
        const auto points = keys_.vectors("points", kMeters);
        if (!points) return;
        const std::size_t least = def().closed ? 3 : 2;
        if (points->size() < least || points->size() > kMostPoints) {
            keys_.complain("points", "the number of points is " + std::to_string(points->size()) +
                                         "; a path should have " + std::to_string(least) + " to " +
                                         std::to_string(kMostPoints));
            return;
        }
        for (const Vec3& point : *points) def().path.push_back(local(a(), point));
        for (std::size_t i = def().closed ? 0 : 1; i < points->size(); ++i) {
            const Vec3& before = i == 0 ? points->back() : (*points)[i - 1];
            if (((*points)[i] - before).norm() >= kShortest) continue;
            keys_.complain("points", "point " + std::to_string(i) +
                                         " of the path is at the same place as the one before; "
                                         "they should be at least 0.001 m apart" +
                                         (i == 0 ? ": leave the last one out" : ""));
            return;
        }
    }

    const Instance& instance_;
    const BodyNumbers& numbers_;
    const SceneDescription& scene_;
    Complaints& complaints_;
    int before_;
    Keys keys_;
    JointDescription joint_;
    const JointKind* kind_ = nullptr;
};

}  // namespace

void readJoints(const std::vector<Instance>& instances, const BodyNumbers& numbers,
                SceneDescription& scene, Complaints& complaints) {
    const Value* complainedOf = nullptr;  // one message for all turns of a [[repeat]]
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
        if (complaints.count() >= kEnoughComplaints) return;
    }
}

}  // namespace demos
