// [[force]]

#include <algorithm>

#include "demos/scene/pattern.h"
#include "demos/scene/ranges.h"
#include "demos/scene/repeat.h"
#include "demos/scene/table_readers.h"
#include "demos/text/nearest.h"
#include "engine/base/trigonometry.h"

namespace demos {
namespace {

constexpr Range kMediumDensity{1e-6, 1e6, "kg/m^3"};
constexpr Range kCoefficient{0.0, 100.0};
constexpr Range kNewtons{-1e12, 1e12, "N"};
constexpr std::size_t kMostAttractions = kMostAttracting * kMostAttracting;  // of all forces
constexpr std::size_t kMostActed = 1'000'000;  // bodies, of all forces: 8 MB

const std::vector<std::string> kTypes{"wind",           "drag",   "medium",   "point-gravity",
                                      "n-body-gravity", "spring", "constant", "airfoil"};

class ForceReader {
public:
    ForceReader(const Instance& instance, const BodyNumbers& numbers,
                const SceneDescription& scene, Complaints& complaints)
        : instance_(instance),
          numbers_(numbers),
          scene_(scene),
          complaints_(complaints),
          keys_(instance.keys("a [[force]]", complaints)) {
        force_.place = instance.table->place;
    }

    ForceDescription read() {
        if (!keys_.has("type"))
            keys_.complain("type", "a [[force]] has no type; write type = \"wind\", or " +
                                       anyOf({kTypes.begin() + 1, kTypes.end()}));
        const std::optional<std::string> type = keys_.word("type", kTypes);
        if (!type) return force_;
        readName();
        readTimes();
        type_ = *type;
        if (type_ == "spring") readEnds();
        else readOn();
        readKind();
        keys_.done();
        return force_;
    }

private:
    engine::ForceDef& def() { return force_.def; }

    void readName() {
        const std::optional<std::string> text = keys_.text("name");
        if (!text) return;
        const int before = complaints_.count();
        const std::string name = instance_.named(*text, keys_, "name");
        if (complaints_.count() == before)
            checkName(name, keys_.placeOf("name"), "name", complaints_);
    }

    void readTimes() {
        def().from = keys_.number("from", {0.0, 1e5, "s"}).value_or(def().from);
        def().until = keys_.number("until", {0.0, 1e5, "s"}).value_or(def().until);
        if (def().until <= def().from)
            keys_.complain("until", "until is " + numberText(def().until) +
                                        "; it should be later than from, " +
                                        numberText(def().from) + " s");
    }

    void readKind() {
        if (type_ == "wind") def().kind = readMedium(true);
        if (type_ == "medium") def().kind = readMedium(false);
        if (type_ == "drag") def().kind = readDrag();
        if (type_ == "point-gravity") def().kind = readPointGravity();
        if (type_ == "n-body-gravity") def().kind = readNBodyGravity();
        if (type_ == "spring") def().kind = readSpring();
        if (type_ == "constant") def().kind = readConstant();
        if (type_ == "airfoil") def().kind = readAirfoil();
    }

    bool isDynamic(int body) const {
        return scene_.bodies[body].def.kind == engine::BodyKind::dynamic;
    }

    /// Without 'on': all dynamic bodies.
    void readOn() {
        std::vector<std::string> patterns{"*"};
        if (const auto given = keys_.texts("on")) patterns = *given;
        const int before = complaints_.count();
        if (patterns.size() > kMostPatterns)
            return keys_.complain("on", std::to_string(patterns.size()) +
                                            " names; they should be at most " +
                                            std::to_string(kMostPatterns));
        for (std::string& pattern : patterns) pattern = instance_.named(pattern, keys_, "on");
        if (complaints_.count() > before) return;
        for (const std::string& pattern : patterns) checkPattern(pattern);
        for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
            const auto fits = [&](const std::string& pattern) {
                return matches(pattern, scene_.bodies[i].name);
            };
            const int number = static_cast<int>(i);
            if (isDynamic(number) && std::any_of(patterns.begin(), patterns.end(), fits))
                def().on.push_back({number});
        }
    }

    void checkPattern(const std::string& pattern) {
        bool known = false;
        for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
            if (!matches(pattern, scene_.bodies[i].name)) continue;
            if (isDynamic(static_cast<int>(i))) return;
            known = true;
        }
        if (known)
            keys_.complain("on", "no body called '" + shown(pattern) +
                                     "' can be moved; a force should act on bodies that are "
                                     "neither fixed nor kinematic");
        else
            keys_.complain("on", "no body is called '" + shown(pattern) + "'" +
                                     suggestion(pattern, bodyNames(scene_)));
    }

    /// The number of the body; -1: the world.
    int readEnd(const char* key) {
        if (!keys_.has(key))
            keys_.complain(key, std::string("a spring has no ") + key + "; write " + key +
                                    " = \"NAME\" of a body, or \"world\"");
        const std::optional<std::string> text = keys_.text(key);
        if (!text) return -1;
        const int before = complaints_.count();
        const std::string name = instance_.named(*text, keys_, key);
        if (complaints_.count() > before) return -1;
        const auto found = numbers_.find(name);
        if (found != numbers_.end()) return found->second;
        std::vector<std::string> names = bodyNames(scene_);
        names.push_back("world");
        if (name != "world")
            keys_.complain(key, "no body is called '" + name + "'" + suggestion(name, names));
        return -1;
    }

    void readEnds() {
        const int before = complaints_.count();
        const int a = readEnd("a"), b = readEnd("b");
        def().on = {{a}, {b}};
        if (complaints_.count() > before) return;
        if (a == b)
            keys_.complain("b", "a spring of a body with itself; a and b should differ");
        else if ((a < 0 || !isDynamic(a)) && (b < 0 || !isDynamic(b)))
            keys_.complain("b", "neither end of the spring can be moved; one of them should be a "
                                "body that is neither fixed nor kinematic");
    }

    double required(const char* key, Range range, const char* example) {
        if (!keys_.has(key))
            keys_.complain("type", "a force of type " + type_ + " has no " + key + "; write " +
                                       example);
        return keys_.number(key, range).value_or(1.0);
    }

    void readRegion(engine::Medium& medium) {
        const Value* table = keys_.any("within");
        if (!table) return;
        Keys keys = keys_.inner(*table, "within");
        const std::optional<Vec3> low = keys.vector("from", kMeters);
        const std::optional<Vec3> high = keys.vector("to", kMeters);
        keys.done();
        if (low && high && (low->array() < high->array()).all()) {
            medium.low = *low, medium.high = *high;
            return;
        }
        keys_.complain("within", "within should be a box, each number of `from` below that of "
                                 "`to`: { from = [-5, 0, -5], to = [5, 3, 5] }");
    }

    engine::Medium readMedium(bool wind) {
        engine::Medium medium;
        medium.carries = !wind;
        if (wind && !keys_.has("velocity"))
            keys_.complain("type", "a wind has no velocity; write velocity = [3, 0, 0]");
        if (wind)
            medium.density = keys_.number("density", kMediumDensity).value_or(medium.density);
        else
            medium.density = required("density", kMediumDensity, "density = 1000");
        medium.velocity = keys_.vector("velocity", kSpeed).value_or(medium.velocity);
        medium.dragCoefficient =
            keys_.number("drag", kCoefficient).value_or(medium.dragCoefficient);
        if (!wind) medium.level = keys_.number("level", kMeters).value_or(medium.level);
        readRegion(medium);
        return medium;
    }

    engine::Drag readDrag() {
        if (!keys_.has("linear") && !keys_.has("angular"))
            keys_.complain("type", "a drag has neither linear nor angular; write "
                                   "linear = 0.5 (N s/m) or angular = 0.1 (N m s)");
        return {keys_.number("linear", {0.0, 1e9, "N s/m"}).value_or(0.0),
                keys_.number("angular", {0.0, 1e9, "N m s"}).value_or(0.0)};
    }

    engine::PointGravity readPointGravity() {
        engine::PointGravity gravity;
        if (!keys_.has("at"))
            keys_.complain("type", "a point-gravity has no at; write at = [0, 0, 0]");
        if (const auto at = keys_.vector("at", kMeters)) gravity.centre = instance_.point(*at);
        gravity.strength = required("strength", {-1e20, 1e20, "m^3/s^2"}, "strength = 10");
        gravity.softening = keys_.number("softening", {0.0, 1e5, "m"}).value_or(0.0);
        return gravity;
    }

    engine::NBodyGravity readNBodyGravity() {
        engine::NBodyGravity gravity;
        gravity.constant =
            keys_.number("constant", {-1e20, 1e20, "m^3/(kg s^2)"}).value_or(gravity.constant);
        gravity.softening = keys_.number("softening", {0.0, 1e5, "m"}).value_or(0.0);
        if (def().on.size() > kMostAttracting)
            keys_.complain("on", std::to_string(def().on.size()) +
                                     " bodies attract each other; there should be at most 2000");
        return gravity;
    }

    engine::Pose poseOf(int body) const {
        return body < 0 ? engine::Pose{} : scene_.bodies[body].def.pose;
    }

    /// Written from the origin of the body's shape; the centre of mass if it is missing.
    Vec3 readAnchor(const char* key, int body) {
        const std::optional<Vec3> anchor = keys_.vector(key, kMeters);
        if (body < 0) return instance_.point(anchor.value_or(Vec3(0, 0, 0)));
        return anchor ? Vec3(*anchor + scene_.bodies[body].def.shape.origin) : Vec3(0, 0, 0);
    }

    engine::SpringForce readSpring() {
        const int a = def().on[0].index, b = def().on[1].index;
        engine::SpringForce spring;
        spring.anchorA = readAnchor("anchor_a", a);
        spring.anchorB = readAnchor("anchor_b", b);
        const Vec3 way = poseOf(b).toWorld(spring.anchorB) - poseOf(a).toWorld(spring.anchorA);
        spring.length = keys_.number("length", {0.0, 1e5, "m"}).value_or(way.norm());
        spring.stiffness = required("stiffness", {0.0, 1e9, "N/m"}, "stiffness = 100");
        spring.damping = keys_.number("damping", {0.0, 1e9, "N s/m"}).value_or(0.0);
        return spring;
    }

    engine::ConstantForce readConstant() {
        if (!keys_.has("force") && !keys_.has("torque"))
            keys_.complain("type", "a constant force has neither force nor torque; write "
                                   "force = [10, 0, 0] (N) or torque = [0, 1, 0] (N m)");
        engine::ConstantForce force;
        force.force = keys_.vector("force", kNewtons).value_or(force.force);
        force.torque = keys_.vector("torque", {-1e12, 1e12, "N m"}).value_or(force.torque);
        force.at = keys_.vector("at", kMeters).value_or(force.at);
        force.turns = keys_.truth("turn").value_or(false);
        if (force.turns) return force;
        force.force = instance_.direction(force.force);
        force.torque = instance_.direction(force.torque);
        return force;
    }

    /// Chord and normal as unit vectors at right angles.
    void readFrame(engine::Airfoil& airfoil) {
        const Vec3 chord = keys_.vector("chord", {-1e6, 1e6}).value_or(airfoil.chord);
        const Vec3 normal = keys_.vector("normal", {-1e6, 1e6}).value_or(airfoil.normal);
        if (chord.cross(normal).norm() <= 1e-6 * chord.norm() * normal.norm() ||
            chord.cross(normal).norm() == 0.0) {
            keys_.complain(keys_.has("normal") ? "normal" : "chord",
                           "chord and normal should be two directions that are not parallel, like "
                           "[1, 0, 0] and [0, 1, 0]");
            return;
        }
        airfoil.chord = chord.normalized();
        airfoil.normal = (normal - airfoil.chord.dot(normal) * airfoil.chord).normalized();
    }

    engine::Airfoil readAirfoil() {
        engine::Airfoil foil;
        foil.area = required("area", {1e-6, 1e6, "m^2"}, "area = 0.5");
        foil.at = keys_.vector("at", kMeters).value_or(foil.at);
        readFrame(foil);
        foil.density = keys_.number("density", kMediumDensity).value_or(foil.density);
        foil.wind = keys_.vector("velocity", kSpeed).value_or(foil.wind);
        foil.liftSlope = keys_.number("lift_slope", kCoefficient).value_or(foil.liftSlope);
        const auto stall = keys_.number("stall_deg", {0.0, 90.0, "deg"});
        if (stall) foil.stall = engine::radians(*stall);
        foil.profileDrag = keys_.number("drag", kCoefficient).value_or(foil.profileDrag);
        foil.plateDrag = keys_.number("plate_drag", kCoefficient).value_or(foil.plateDrag);
        foil.aspect = keys_.number("aspect", {0.01, 1e6}).value_or(foil.aspect);
        return foil;
    }

    const Instance& instance_;
    const BodyNumbers& numbers_;
    const SceneDescription& scene_;
    Complaints& complaints_;
    Keys keys_;
    ForceDescription force_;
    std::string type_;
};

}  // namespace

void readForces(const std::vector<Instance>& instances, const BodyNumbers& numbers,
                SceneDescription& scene, Complaints& complaints) {
    const Value* complainedOf = nullptr;  // one message for all turns of a [[repeat]]
    std::size_t acted = 0, attractions = 0;
    for (const Instance& instance : instances) {
        if (instance.table == complainedOf) continue;
        const int before = complaints.count();
        scene.forces.push_back(ForceReader(instance, numbers, scene, complaints).read());
        const engine::ForceDef& def = scene.forces.back().def;
        acted += def.on.size();
        if (std::holds_alternative<engine::NBodyGravity>(def.kind)) attractions += def.on.size() * def.on.size();
        if (complaints.count() > before) complainedOf = instance.table;
        if (complaints.count() >= kEnoughComplaints) return;
        if (complaints.count() == before && attractions > kMostAttractions)
            return complaints.add(instance.table->place,
                                  "the n-body-gravities up to this one are between more bodies than one of 2000 "
                                  "bodies; name fewer in on");
        if (acted <= kMostActed) continue;
        return complaints.add(instance.table->place,
                              "the forces up to this one act on more than a million bodies in "
                              "all; name fewer in on");
    }
}

}  // namespace demos
