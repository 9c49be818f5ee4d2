#include "demos/snapshot/coil.h"

#include <algorithm>
#include <cmath>

#include "render/palette.h"

namespace demos {
namespace {

constexpr int kCoilTurns = 9, kFewestRods = 5, kMostRods = 10;  // rods per turn
constexpr float kStraight = 0.12f;  // of the length, at each end
constexpr float kWide = 0.09f;      // of the length at rest: the coil's radius
constexpr float kThick = 0.15f;     // of that radius: the wire's
constexpr float kSmall = 4.0f;      // pixels: the turns of a smaller coil cannot be told apart,
constexpr float kBar = 0.5f;        // and a bar of this share of its radius stands for it

/// A length at a place, in pixels of a picture 720 high.
float pixelsOf(float length, const render::Camera& camera, const render::Vec3& place) {
    const float away = std::max((place - camera.from).norm(), 1e-3f);
    return 360.0f * length / (std::tan(0.5f * camera.fovDegrees * 0.01745329252f) * away);
}

/// As many as keep the error of a turn, r (1 - cos(pi / n)), below half a pixel.
int rodsPerTurn(float pixels) {
    const float wanted = 3.14159265359f * std::sqrt(pixels);  // cos(x) is about 1 - x^2 / 2
    return std::clamp(static_cast<int>(std::ceil(wanted)), kFewestRods, kMostRods);
}

float coilRadius(float rest) { return std::clamp(kWide * rest, 0.02f, 0.2f); }

}  // namespace

float coilWire(float rest) { return kThick * coilRadius(rest); }

void addCoil(const render::Vec3& from, const render::Vec3& to, float rest, int id,
             render::Frame& frame) {
    const render::Vec3 way = to - from;
    const float length = way.norm();
    if (length <= 0.0f) return;
    const render::Vec3 along = way / length;
    const render::Vec3 across =
        along.cross(std::abs(along.y()) < 0.9f ? render::Vec3::UnitY() : render::Vec3::UnitX())
            .normalized();
    const render::Vec3 third = along.cross(across);
    const float radius = coilRadius(rest), wire = coilWire(rest);
    const float pixels = pixelsOf(radius, frame.camera, 0.5f * (from + to));
    if (pixels < kSmall) {
        frame.rods.push_back({from, to, kBar * radius, render::jointColor(), id});
        return;
    }
    render::Vec3 last = from;
    const auto go = [&](const render::Vec3& next) {
        frame.rods.push_back({last, next, wire, render::jointColor(), id});
        last = next;
    };
    const int rods = kCoilTurns * rodsPerTurn(pixels);
    for (int i = 0; i <= rods; ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(rods);
        const float angle = 6.28318530718f * kCoilTurns * share;
        go(from + (kStraight + (1.0f - 2.0f * kStraight) * share) * way +
           radius * (std::cos(angle) * across + std::sin(angle) * third));
    }
    go(to);
}

}  // namespace demos
