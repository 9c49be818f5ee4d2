#include "demos/mjcf/axes.h"

#include "demos/scene/ranges.h"
#include "engine/base/trigonometry.h"

namespace demos::mjcf {
namespace {

constexpr Range kAngles{-1e5, 1e5};
constexpr Range kComponents{-1e6, 1e6};
constexpr double kLeastLength = 1e-9;

Quat fromQuaternion(Attributes& attributes) {
    const auto q = attributes.numbers("quat", 4, 4, kComponents);
    if (!q) return Quat::Identity();
    const Quat turn((*q)[0], (*q)[1], (*q)[2], (*q)[3]);
    if (turn.norm() > kLeastLength) return turn.normalized();
    attributes.wrong("quat", "quat is 0 0 0 0; it should be a rotation, like 1 0 0 0");
    return Quat::Identity();
}

Quat fromAxisAngle(Attributes& attributes, const AngleRules& rules) {
    const auto a = attributes.numbers("axisangle", 4, 4, kComponents);
    if (!a) return Quat::Identity();
    const Vec3 axis((*a)[0], (*a)[1], (*a)[2]);
    if (axis.norm() > kLeastLength && std::abs((*a)[3]) <= kAngles.high)
        return engine::turnAbout(axis.normalized(), rules.radians((*a)[3]));
    attributes.wrong("axisangle",
                     "axisangle should be an axis that is not zero and an angle of at most 100000");
    return Quat::Identity();
}

/// x as given, y made orthogonal to it in their plane.
Quat fromAxes(Attributes& attributes) {
    const auto a = attributes.numbers("xyaxes", 6, 6, kComponents);
    if (!a) return Quat::Identity();
    const Vec3 x = Vec3((*a)[0], (*a)[1], (*a)[2]).normalized();
    const Vec3 given((*a)[3], (*a)[4], (*a)[5]);
    const Vec3 y = given - x.dot(given) * x;
    Mat3 axes;
    axes << x, y.normalized(), x.cross(y).normalized();
    if (x.norm() > 0.5 && y.norm() > kLeastLength * given.norm() && given.norm() > kLeastLength)
        return Quat(axes).normalized();
    attributes.wrong("xyaxes", "xyaxes should be two directions that are not parallel");
    return Quat::Identity();
}

Quat fromZAxis(Attributes& attributes) {
    const std::optional<Vec3> z = attributes.vector("zaxis", kComponents);
    if (!z) return Quat::Identity();
    if (z->norm() > kLeastLength) return shortestTurn(Vec3::UnitZ(), *z);
    attributes.wrong("zaxis", "zaxis is 0 0 0; it should be a direction, like 0 0 1");
    return Quat::Identity();
}

Quat fromEuler(Attributes& attributes, const AngleRules& rules) {
    const std::optional<Vec3> angles = attributes.vector("euler", kAngles);
    if (!angles) return Quat::Identity();
    Quat turn = Quat::Identity();
    for (int i = 0; i < 3; ++i) {
        const char letter = rules.eulerSequence[static_cast<std::size_t>(i)];
        const bool fixed = letter < 'a';
        const Vec3 axis = Vec3::Unit((fixed ? letter - 'X' : letter - 'x'));
        const Quat one = engine::turnAbout(axis, rules.radians((*angles)[i]));
        turn = fixed ? Quat(one * turn) : Quat(turn * one);
    }
    return turn.normalized();
}

}  // namespace

Mat3 yUp(const Mat3& inertia) {
    Mat3 turn;
    turn << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    return turn * inertia * turn.transpose();
}

double AngleRules::radians(double angle) const { return degrees ? engine::radians(angle) : angle; }

Quat shortestTurn(const Vec3& from, const Vec3& to) {
    const Vec3 a = from.normalized(), b = to.normalized();
    const double c = a.dot(b);
    if (c < -1.0 + 1e-12) {  // half a turn, about any orthogonal axis
        Vec3 across, other;
        engine::tangents(a, across, other);
        return {0.0, across.x(), across.y(), across.z()};
    }
    const Vec3 axis = a.cross(b);
    return Quat(1.0 + c, axis.x(), axis.y(), axis.z()).normalized();
}

Quat readOrientation(Attributes& attributes, const AngleRules& rules) {
    int given = 0;
    for (const char* name : {"quat", "axisangle", "xyaxes", "zaxis", "euler"})
        given += attributes.has(name) ? 1 : 0;
    if (given > 1)
        attributes.wrong("", "two orientations in one <" + attributes.element() +
                                 ">; give one of quat, axisangle, xyaxes, zaxis, euler");
    const Quat turn = attributes.has("quat")        ? fromQuaternion(attributes)
                      : attributes.has("axisangle") ? fromAxisAngle(attributes, rules)
                      : attributes.has("xyaxes")    ? fromAxes(attributes)
                      : attributes.has("zaxis")     ? fromZAxis(attributes)
                                                    : fromEuler(attributes, rules);
    return yUp(turn);
}

Pose readPose(Attributes& attributes, const AngleRules& rules) {
    Pose pose;
    pose.position = yUp(attributes.vector("pos", kMeters).value_or(Vec3(0, 0, 0)));
    pose.rotation = readOrientation(attributes, rules);
    return pose;
}

}  // namespace demos::mjcf
