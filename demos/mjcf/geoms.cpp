#include "demos/mjcf/geoms.h"

#include "demos/mjcf/hulls.h"
#include "demos/scene/ranges.h"
#include "demos/text/nearest.h"
#include "engine/base/trigonometry.h"
#include "engine/shapes/mass.h"

namespace demos::mjcf {
namespace {

using engine::Shape;

constexpr Range kSizes{0.0, 1e4, "m"};
constexpr double kLeastSize = 1e-5;  // m
constexpr double kRolling = 1e-4;     // m, MuJoCo's default if condim is 6
constexpr int kFirstHiddenGroup = 3;
constexpr double kLargestBits = 2147483647.0;

class GeomReader {
public:
    GeomReader(const Element& element, const std::string& childclass, const Context& context)
        : attributes_(context.defaults.of(element, childclass)), context_(context) {}

    std::optional<Geom> read() {
        geom_.spot = attributes_.spot();
        geom_.name = attributes_.text("name");
        geom_.type = readType();
        const int before = context_.diagnostics.errors();
        const bool meant = readShape();
        readMass();
        readSurface();
        if (!meant || context_.diagnostics.errors() > before) return std::nullopt;
        return geom_;
    }

private:
    std::string readType() {
        static const std::vector<std::string> kTypes{
            "plane", "hfield", "sphere", "capsule", "ellipsoid", "cylinder", "box", "mesh", "sdf"};
        return attributes_.word("type", kTypes).value_or("sphere");
    }

    /// False if there is none.
    bool readShape() {
        if (geom_.type == "hfield" || geom_.type == "sdf") {
            attributes_.note("type",
                             "a <geom> of type " + geom_.type + " is not supported; left out");
            return false;
        }
        geom_.pose = readPose(attributes_, context_.rules.angles);
        if (geom_.type == "mesh") return readMesh();
        if (attributes_.has("mesh")) {
            attributes_.wrong("mesh", "mesh in a <geom> of type " + geom_.type +
                                          ", which MuJoCo would fit to it; write type=\"mesh\"");
            return false;
        }
        if (geom_.type == "plane") {
            geom_.shape = Shape::plane(Vec3(0, 1, 0));
            return true;
        }
        const std::optional<Vec3> size = readSize();
        if (size) shapeFrom(*size);
        return size.has_value();
    }

    bool readMesh() {
        const std::string name = attributes_.text("mesh");
        const auto found = context_.assets.meshes.find(name);
        if (found == context_.assets.meshes.end()) {
            std::vector<std::string> names;
            for (const auto& [known, hull] : context_.assets.meshes) names.push_back(known);
            attributes_.wrong("mesh", "no mesh is called '" + name + "'" + suggestion(name, names));
            return false;
        }
        if (!found->second) return false;
        attributes_.note("mesh", "a mesh collides and weighs as its convex hull");
        takeHull(found->second->hull);
        geom_.picture = found->second->picture;
        return true;
    }

    void takeHull(const Shape& hull) {
        geom_.shape = hull;
        geom_.pose.position = geom_.pose.toWorld(-hull.origin);
    }

    /// How many of the three sizes a type needs, without or with fromto.
    std::size_t sizesOf(bool between) const {
        const std::size_t own = geom_.type == "sphere"                                ? 1
                                : geom_.type == "capsule" || geom_.type == "cylinder" ? 2
                                                                                      : 3;
        return between ? 1 : own;
    }

    /// Radius or half edges, the last along the geom's z.
    std::optional<Vec3> readSize() {
        const bool between = attributes_.has("fromto") && geom_.type != "sphere";
        if (attributes_.has("fromto") && !between)
            attributes_.wrong("fromto", "fromto is given for a sphere; give pos instead");
        const std::size_t count = sizesOf(between);
        if (!attributes_.has("size")) {
            attributes_.wrong("", "a <geom> of type " + geom_.type + " has no size; write size=\"" +
                                      std::string(count == 1   ? "0.1"
                                                  : count == 2 ? "0.1 0.2"
                                                               : "0.1 0.1 0.1") +
                                      "\" (m; half lengths)");
            return std::nullopt;
        }
        const auto numbers = attributes_.numbers("size", count, 3, kSizes);
        if (!numbers) return std::nullopt;
        Vec3 size = Vec3::Constant((*numbers)[0]);
        if (count == 2) size.z() = (*numbers)[1];
        if (count == 3) size = Vec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
        if (between && !readEnds(size)) return std::nullopt;
        if (size.minCoeff() >= kLeastSize) return size;
        attributes_.wrong("size", "size is '" + attributes_.text("size").substr(0, 40) +
                                      "'; each should be at least 0.00001 m");
        return std::nullopt;
    }

    bool readEnds(Vec3& size) {
        const auto ends = attributes_.numbers("fromto", 6, 6, kMeters);
        if (!ends) return false;
        const std::vector<double>& e = *ends;
        const Vec3 from(e[0], e[1], e[2]), to(e[3], e[4], e[5]), way = to - from;
        size.z() = 0.5 * way.norm();
        if (size.z() < kLeastSize) {
            attributes_.wrong("fromto", "the two ends are the same point; move one of them");
            return false;
        }
        geom_.pose.position = yUp(Vec3(0.5 * (from + to)));
        geom_.pose.rotation = yUp(shortestTurn(Vec3::UnitZ(), way));
        return true;
    }

    void shapeFrom(const Vec3& size) {
        const double r = size.x(), half = size.z();
        if (geom_.type == "sphere") geom_.shape = Shape::sphere(r);
        if (geom_.type == "capsule") geom_.shape = Shape::capsule(r, 2.0 * (half + r));
        if (geom_.type == "cylinder") geom_.shape = Shape::cylinder(r, 2.0 * half);
        if (geom_.type == "box") geom_.shape = Shape::box(2.0 * yUpSizes(size));
        if (geom_.type == "ellipsoid") shapeFromAxes(yUpSizes(size));
    }

    void shapeFromAxes(const Vec3& halfAxes) {
        attributes_.note("type", "an ellipsoid is replaced by a convex hull of 120 corners");
        if (const auto hull = hullOfAny(ellipsoidCorners(halfAxes)))
            takeHull(*hull);
        else
            attributes_.wrong("size",
                              "an ellipsoid should not be 10000 times as long as it is thick");
    }

    void readMass() {
        const std::optional<double> mass = attributes_.number("mass", {0.0, 1e9, "kg"});
        const double density = attributes_.number("density", {0.0, 1e7, "kg/m^3"}).value_or(1000.0);
        const double volume = engine::volume(geom_.shape);
        geom_.ownMass = mass.has_value();
        MassProperties& own = geom_.properties;
        own.mass = volume > 0.0 ? mass.value_or(density * volume) : 0.0;
        if (own.mass > 0.0) own.inertia = engine::inertiaOf(geom_.shape, own.mass);
        own = placed(own, geom_.pose);
    }

    int bits(const char* name) { return attributes_.whole(name, {0.0, kLargestBits}).value_or(1); }

    /// condim 1: none, unless the other geom's is larger; 3: sliding; 4: also torsion; 6: also
    /// rolling.
    void readFriction() {
        const int condim = attributes_.whole("condim", {1.0, 6.0}).value_or(3);
        const std::vector<double> given =
            attributes_.numbers("friction", 1, 3, {0.0, 1e4}).value_or(std::vector<double>{});
        if (condim == 2 || condim == 5)
            attributes_.wrong("condim", "condim is " + std::to_string(condim) +
                                            "; it should be 1, 3, 4 or 6");
        if (condim > 3)
            attributes_.note("condim", "torsional friction is not supported; left out");
        if (!given.empty()) geom_.friction = given.front();
        geom_.condim = condim;
        geom_.priority = attributes_.whole("priority", {-1e6, 1e6}).value_or(0);
        if (condim == 6) geom_.rolling = given.size() > 2 ? given[2] : kRolling;
    }

    void readSurface() {
        readFriction();
        geom_.contype = bits("contype");
        geom_.conaffinity = bits("conaffinity");
        const std::string material = attributes_.text("material");
        const auto found = context_.assets.colors.find(material);
        if (found != context_.assets.colors.end()) geom_.color = found->second;
        if (!material.empty() && found == context_.assets.colors.end()) {
            std::vector<std::string> names;
            for (const auto& [known, color] : context_.assets.colors) names.push_back(known);
            attributes_.wrong("material", "no material is called '" + material + "'" +
                                              suggestion(material, names));
        }
        if (const std::optional<unsigned> color = readColor(attributes_)) geom_.color = color;
        const auto rgba = attributes_.numbers("rgba", 4, 4, {0.0, 1.0});
        const int group = attributes_.whole("group", {-1e6, 1e6}).value_or(0);
        geom_.isShown = group < kFirstHiddenGroup && !(rgba && rgba->back() == 0.0);
    }

    Attributes attributes_;
    const Context& context_;
    Geom geom_;
};

}  // namespace

std::optional<Geom> readGeom(const Element& element, const std::string& childclass,
                             const Context& context) {
    return GeomReader(element, childclass, context).read();
}

}  // namespace demos::mjcf
