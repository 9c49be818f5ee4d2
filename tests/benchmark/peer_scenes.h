/// The scenes in which engines are compared: what to build, and what to measure there.
/// No engine is used here; of ours only the types for vectors and poses. y is up.
#pragma once
#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/math.h"

namespace peers {

using engine::Pose;
using engine::Quat;
using engine::Vec3;

/// hull: convex. drum: plates, each a hull, that turn together. mesh: a surface that never moves.
enum class Kind { box, sphere, capsule, hull, drum, mesh };

/// A plate of a drum, in the drum's axes.
struct Plate {
    Vec3 halfSize;  // m
    Pose pose;
};

struct Body {
    Kind kind = Kind::box;
    Vec3 halfSize{0.5, 0.5, 0.5};  // m; box: half edges; capsule: y is half its core, along y
    double radius = 0.5;           // m; sphere, capsule; hull: of about the same volume
    std::vector<Vec3> corners;     // m; hull: each with its opposite, so that the centre is 0; mesh
    std::vector<std::array<int, 3>> triangles;  // mesh: counter-clockwise from outside
    std::vector<Plate> plates;     // drum
    Pose pose;
    Vec3 velocity{0, 0, 0};   // m/s
    Vec3 spin{0, 0, 0};       // rad/s, world axes
    double density = 1000.0;  // kg/m^3
    bool dynamic = true;      // else it only turns, at its spin
    bool collide = true;      // false: passes through everything

    bool turns() const { return !dynamic && !spin.isZero(0.0); }
    double mass() const;   // kg
    Vec3 inertia() const;  // kg m^2, about the body's axes
    double reach() const;  // m, from the centre to the farthest point
};

/// Joined bodies do not collide with each other.
struct Joint {
    bool isHinge = false;  // else a ball joint
    int a = 0, b = 0;      // bodies
    Vec3 at{0, 0, 0};      // m, world axes, at the start
    Vec3 axis{0, 0, 1};    // of a hinge, world axes, at the start; of a ball's cone, in both bodies
    double most = kFree;   // rad: a hinge turns by at most this either way, a ball swings in a cone
    double twist = kFree;  // rad: a ball, either way
    bool isLimited() const { return most < kFree; }

    static constexpr double kFree = std::numeric_limits<double>::infinity();
};

struct Scene {
    std::string name;
    std::vector<Body> bodies;
    std::vector<Joint> joints;
    double seconds = 10.0;      // s, of simulated time
    double step = 1.0 / 60.0;   // s
    Vec3 gravity{0, -9.81, 0};  // m/s^2
    double friction = 0.6;      // mu, where two surfaces meet
    double restitution = 0.0;   // the same
    bool sleeps = false;        // bodies at rest may fall asleep

    bool watchPenetration = true;     // measured by us, not reported by the engine
    bool shouldStand = false;         // it has fallen when a body is half a metre from its start
    bool watchEnergy = false;         // nothing here may take or give energy
    double energyScale = 1.0;         // J: what 100 % of an energy error is
    bool watchMomentum = false;       // nothing here may turn the angular momentum
    double slide = 0.0;               // m/s^2: body 1 should slide with this acceleration
    std::optional<double> lostBelow;  // m: lower than this a body has left the scene
    std::function<double(double, double)> ground;  // m: its height at x, z, where bodies may sink in

    int stepCount() const;
};

/// As in the table of README.md; p: perturbed; P<n>: a pyramid of n boxes at its base.
std::vector<std::string> sceneNames();

/// Nothing if there is no scene of this name.
std::optional<Scene> makeScene(const std::string& name);

}  // namespace peers
