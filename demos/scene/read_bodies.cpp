// [[material]] and [[body]]

#include <algorithm>

#include "demos/look/theme.h"
#include "demos/scene/ranges.h"
#include "demos/scene/read_shape.h"
#include "demos/scene/table_readers.h"
#include "demos/text/nearest.h"
#include "engine/base/trigonometry.h"
#include "engine/shapes/mass.h"

namespace demos {
namespace {

constexpr Range kMass{1e-6, 1e9, "kg"};
constexpr Range kRolling{0.0, 10.0, "m"};

/// Three numbers: the diagonal. Six: xx, yy, zz, xy, xz, yz.
std::optional<engine::Mat3> readInertia(Keys& keys) {
    const auto numbers = keys.numbers("inertia", {-1e18, 1e18, "kg m^2"});
    if (!numbers) return std::nullopt;
    const std::vector<double>& n = *numbers;
    engine::Mat3 inertia = engine::Mat3::Zero();
    if (n.size() == 3 || n.size() == 6) inertia.diagonal() = Vec3(n[0], n[1], n[2]);
    if (n.size() == 6) {
        inertia(0, 1) = inertia(1, 0) = n[3];
        inertia(0, 2) = inertia(2, 0) = n[4];
        inertia(1, 2) = inertia(2, 1) = n[5];
    }
    if (engine::isInertia(inertia)) return inertia;
    keys.complain("inertia",
                  "inertia should be three positive numbers (xx, yy, zz) or six (xx, yy, zz, xy, "
                  "xz, yz) of a positive definite matrix, in kg m^2, with no principal moment "
                  "larger than the sum of the others");
    return std::nullopt;
}

Quat readRotation(Keys& keys) {
    const Quat turned = readTurn(keys);
    const auto q = keys.numbers("quaternion", {-1e3, 1e3});
    if (q && keys.has("turn_deg"))
        keys.complain("quaternion", "turn_deg and quaternion in one body; give one of them");
    if (q) {
        const Quat turn =
            q->size() == 4 ? Quat((*q)[0], (*q)[1], (*q)[2], (*q)[3]) : Quat(0.0, 0.0, 0.0, 0.0);
        if (turn.norm() > 1e-6) return turn.normalized();
        keys.complain("quaternion", "quaternion should be four numbers [w, x, y, z], not all zero");
    }
    return turned;
}

/// The key `look`: one of materialNames().
std::optional<render::Material> readMaterialLook(Keys& keys) {
    const std::optional<std::string> word = keys.word("look", materialNames());
    if (!word) return {};
    const auto at = std::find(materialNames().begin(), materialNames().end(), *word);
    if (at == materialNames().end()) return {};
    return static_cast<render::Material>(at - materialNames().begin());
}

/// Reads one body of the file, or of one turn of a [[repeat]].
class BodyReader {
public:
    BodyReader(const Instance& instance, const Materials& materials, ShapeFiles& files,
               Complaints& complaints)
        : instance_(instance),
          materials_(materials),
          files_(files),
          complaints_(complaints),
          keys_(instance.keys("a [[body]]", complaints)) {
        body_.place = instance.table->place;
    }

    /// The name is empty if the file has no valid one.
    BodyDescription read() {
        readName();
        readMaterial();
        readDensity();
        readShape();
        readKind();
        readPose();
        readMotion();
        readMass();
        readMeetings();
        if (const std::optional<unsigned> color = keys_.color("colour")) body_.color = color;
        body_.look = readMaterialLook(keys_).value_or(body_.look);
        keys_.later({"break_at"});
        keys_.done();
        return body_;
    }

private:
    void readName() {
        if (!keys_.has("name")) {
            keys_.complain("name", "a [[body]] has no name; write name = \"box\"");
            return;
        }
        const std::optional<std::string> text = keys_.text("name");
        if (!text) return;
        const int before = complaints_.count();
        const std::string name = instance_.named(*text, keys_, "name");
        if (complaints_.count() > before) return;
        if (name == "world")
            keys_.complain("name", "a body cannot be called 'world': joints use this name for the "
                                   "fixed world");
        else if (checkName(name, keys_.placeOf("name"), "name", complaints_))
            body_.name = name;
    }

    void readMaterial() {
        const std::optional<std::string> name = keys_.text("material");
        if (!name) return;
        const auto found = materials_.find(*name);
        if (found != materials_.end()) {
            body_.def.material = found->second.material;
            body_.color = found->second.color;
            body_.look = found->second.look;
            return;
        }
        std::vector<std::string> names;
        for (const auto& [known, material] : materials_) names.push_back(known);
        keys_.complain("material", "no material is called '" + *name + "'" +
                                       (names.empty() ? "; write a [[material]] of that name"
                                                      : suggestion(*name, names)));
    }

    void readDensity() {
        const std::optional<double> density = keys_.number("density", kDensity);
        if (keys_.has("mass") && keys_.has("density"))
            keys_.complain("density", "mass and density in one body; give one of them");
        if (density) body_.def.material.density = *density;
    }

    void readShape() {
        const auto shape = demos::readShape(keys_, body_.def.material.density, files_);
        shapeKnown_ = shape.has_value();
        if (shape) body_.def.shape = *shape;
    }

    void readKind() {
        const bool fixed = keys_.truth("fixed").value_or(false);
        const Value* kinematic = keys_.any("kinematic");
        if (fixed && kinematic)
            keys_.complain("kinematic", "fixed and kinematic in one body; give one of them");
        if (fixed) body_.def.kind = engine::BodyKind::fixed;
        if (kinematic) {
            body_.def.kind = engine::BodyKind::kinematic;
            readKinematic(keys_.inner(*kinematic, "kinematic"), instance_, body_);
        }
        const bool plane = shapeKnown_ && body_.def.shape.type == engine::ShapeType::plane;
        if (plane && !fixed)
            keys_.complain("shape", "a plane that is not fixed; write fixed = true");
        if (body_.def.kind == engine::BodyKind::dynamic) return checkMovable();
        for (const char* key : {"velocity", "spin", "mass", "density", "inertia"})
            if (keys_.has(key))
                keys_.complain(key, std::string(key) + " of a body that is " +
                                        (fixed ? "fixed" : "kinematic") + "; leave it out" +
                                        (fixed ? "" : ": kinematic = { velocity, spin } moves it"));
    }

    void checkMovable() {
        const engine::ShapeType type = body_.def.shape.type;
        massless_ = type == engine::ShapeType::plane || type == engine::ShapeType::mesh;
        if (shapeKnown_ && type == engine::ShapeType::mesh)
            keys_.complain("shape",
                           "a mesh or height_field cannot be dynamic; write fixed = true "
                           "or kinematic, or make it a hull");
    }

    void readPose() {
        const Vec3 at = keys_.vector("at", kMeters).value_or(Vec3(0, 0, 0));
        body_.def.pose.position = instance_.point(at);
        if (const auto* path = body_.path ? std::get_if<PointPath>(&*body_.path) : nullptr) {
            if (keys_.has("at"))
                keys_.complain("at", "at of a body on a path; leave it out: the path begins at its "
                                     "first point");
            body_.def.pose.position = path->points.front();
        }
        body_.def.pose.rotation = instance_.rotation(readRotation(keys_));
        if (body_.def.pose.position.cwiseAbs().maxCoeff() > kMeters.high)
            keys_.complain("at", "a [[repeat]] puts '" + body_.name +
                                     "' more than 100000 m from the origin; make its step smaller");
        putCentreOfMass();
    }

    /// `at` and paths give the position of the origin of a hull's points or a compound's parts; the
    /// engine's poses are those of the centre of mass.
    void putCentreOfMass() {
        engine::Pose& pose = body_.def.pose;
        pose.position -= pose.rotation * body_.def.shape.origin;
        const double farthest = pose.position.cwiseAbs().maxCoeff();
        if (farthest > kMeters.high && body_.def.shape.origin != Vec3::Zero())
            keys_.complain("shape", "its centre of mass would be " + numberText(farthest) +
                                        " m from the origin; it should be at most 100000 m: move "
                                        "its points towards their own origin");
    }

    void readMotion() {
        const std::optional<Vec3> velocity = keys_.vector("velocity", kSpeed);
        const std::optional<Vec3> spin = keys_.vector("spin", kSpin);
        if (velocity) body_.def.velocity = *velocity;
        if (spin) body_.def.spin = *spin;
        if (body_.def.velocity.norm() >= kSpeed.high)
            keys_.complain("velocity", "the magnitude of velocity should be below 10000 m/s");
    }

    /// What the body collides with.
    void readMeetings() {
        body_.def.sensor = keys_.truth("sensor").value_or(false);
        body_.groups = keys_.texts("group").value_or(std::vector<std::string>{});
        body_.ignores = keys_.texts("ignores").value_or(std::vector<std::string>{});
        body_.ignoresPlace = keys_.placeOf("ignores");
        for (std::string& name : body_.ignores) name = instance_.named(name, keys_, "ignores");
        for (std::string& name : body_.groups) {
            const int before = complaints_.count();
            name = instance_.named(name, keys_, "group");
            if (complaints_.count() == before)
                checkName(name, keys_.placeOf("group"), "group", complaints_);
        }
    }

    void readMass() {
        const std::optional<double> mass = keys_.number("mass", kMass);
        if (mass) body_.def.mass = mass;
        body_.def.inertia = readInertia(keys_);
        if (!shapeKnown_ || massless_ || body_.def.kind != engine::BodyKind::dynamic) return;
        const double own = engine::massOf(body_.def.shape, body_.def.material.density);
        checkInertia(mass.value_or(own));
        if (!mass && (own < kMass.low || own > kMass.high))
            keys_.complain("shape", "its volume and a density of " +
                                        numberText(body_.def.material.density) + " kg/m^3 make " +
                                        numberText(own) +
                                        " kg; it should be from 1e-06 to 1e+09 kg: give a mass");
    }

    /// For small parts far apart, rounding leaves no inertia about the line through them.
    void checkInertia(double mass) {
        if (body_.def.inertia) return;
        const Eigen::LLT<engine::Mat3> factor(engine::inertiaOf(body_.def.shape, mass));
        if (factor.info() != Eigen::Success)
            keys_.complain("shape", "its inertia is not positive definite, because it is too thin "
                                    "for its length; give an inertia");
    }

    const Instance& instance_;
    const Materials& materials_;
    ShapeFiles& files_;
    Complaints& complaints_;
    Keys keys_;
    BodyDescription body_;
    bool shapeKnown_ = false;
    bool massless_ = false;  // a dynamic plane or mesh: an error that is reported elsewhere
};

}  // namespace

bool checkName(const std::string& name, Place place, const char* what, Complaints& complaints) {
    constexpr std::size_t kMostOfName = 64;
    const bool good = !name.empty() && name.size() <= kMostOfName &&
                      std::all_of(name.begin(), name.end(), [](char c) {
                          return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                                 (c >= '0' && c <= '9') ||
                                 std::string_view("_.{}+-").find(c) != std::string_view::npos;
                      });
    if (!good)
        complaints.add(place, std::string(what) + " is '" + name.substr(0, kMostOfName) +
                                  "'; it should be 1 to 64 of A-Z a-z 0-9 _ . { } + -");
    return good;
}

namespace {

/// In the order of engine::FrictionRule.
const std::vector<std::string> kFrictionRules{"none",    "geometric", "average",
                                              "smaller", "product",   "larger"};

void readMeeting(Keys& keys, engine::Material& material) {
    const std::optional<std::string> rule = keys.word("friction_rule", kFrictionRules);
    for (std::size_t i = 0; i < kFrictionRules.size(); ++i)
        if (rule == kFrictionRules[i]) material.frictionRule = static_cast<engine::FrictionRule>(i);
    material.priority = keys.whole("priority", {-1e6, 1e6}).value_or(material.priority);
}

}  // namespace

Materials readMaterials(Keys& top, Complaints& complaints) {
    Materials materials;
    for (const Value* table : top.tables("material")) {
        Keys keys = top.inner(*table, "a [[material]]");
        if (!keys.has("name"))
            keys.complain("name", "a [[material]] has no name; write name = \"wood\"");
        const std::string name = keys.text("name").value_or("");
        MaterialDescription m;
        m.material.density = keys.number("density", kDensity).value_or(m.material.density);
        m.material.friction = keys.number("friction", {0.0, 100.0}).value_or(m.material.friction);
        m.material.restitution =
            keys.number("restitution", {0.0, 1.0}).value_or(m.material.restitution);
        m.material.rolling = keys.number("rolling", kRolling).value_or(m.material.rolling);
        readMeeting(keys, m.material);
        m.color = keys.color("colour");
        m.look = readMaterialLook(keys).value_or(m.look);
        keys.done();
        if (!keys.has("name") || !checkName(name, keys.placeOf("name"), "name", complaints))
            continue;
        if (!materials.insert({name, m}).second)
            keys.complain("name", "two materials are called '" + name + "'; rename one");
    }
    return materials;
}

BodyNumbers readBodies(const std::vector<Instance>& instances, const Materials& materials,
                       SceneDescription& scene, Complaints& complaints) {
    BodyNumbers numbers;
    ShapeFiles files{scene.folder, {}};
    const Value* complainedOf = nullptr;  // one message for all turns of a [[repeat]]
    for (const Instance& instance : instances) {
        const int before = complaints.count();
        std::string told;
        BodyDescription body;
        if (instance.table != complainedOf)
            body = BodyReader(instance, materials, files, complaints).read();
        else if (const Value* name = instance.table->find("name"))
            body.name = instance.named(name->text, told);  // for joints that name it
        const int number = static_cast<int>(scene.bodies.size());
        const bool twice = !body.name.empty() && !numbers.insert({body.name, number}).second;
        if (twice && instance.table != complainedOf)
            complaints.add(body.place,
                           "two bodies are called '" + body.name + "'; rename one" +
                               (instance.isRepeated() ? ", in a [[repeat]] with {i}" : ""));
        if (complaints.count() > before) complainedOf = instance.table;
        scene.bodies.push_back(std::move(body));
        if (complaints.count() >= kEnoughComplaints) break;
    }
    scene.contents = files.contents.value();
    scene.files = std::move(files.paths);
    return numbers;
}

std::vector<std::string> bodyNames(const SceneDescription& scene) {
    std::vector<std::string> names;
    for (const BodyDescription& body : scene.bodies) names.push_back(body.name);
    return names;
}

std::vector<std::string> jointNames(const SceneDescription& scene) {
    std::vector<std::string> names;
    for (const JointDescription& joint : scene.joints) names.push_back(joint.name);
    return names;
}

}  // namespace demos
