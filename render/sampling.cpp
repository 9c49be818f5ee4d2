#include "render/sampling.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>

namespace render {
namespace {

constexpr float kTwoPi = 6.28318531f;
constexpr float kSunRadius = 0.035f;  // rad: seven times the real sun's, as of a large studio lamp

/// The digits of `index` in `base`, mirrored at the radix point (van der Corput): 0 <= result < 1.
float mirrored(int index, int base) {
    float result = 0.0f, digit = 1.0f;
    for (; index > 0; index /= base) {
        digit /= static_cast<float>(base);
        result += digit * static_cast<float>(index % base);
    }
    return result;
}

/// A uniform distribution over a disc of radius 1; u, v: 0..1.
Eigen::Vector2f onDisc(float u, float v) {
    const float radius = std::sqrt(u), angle = kTwoPi * v;
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// The middles of `count` strips of 0..1, each once, in an order that depends on `stride`.
float strip(int index, int count, int stride) {
    while (std::gcd(stride, count) != 1) ++stride;
    return (static_cast<float>(index * stride % count) + 0.5f) / static_cast<float>(count);
}

}  // namespace

std::vector<SampleOffset> sampleOffsets(int samples) {
    constexpr int kTwo[][2] = {{4, 4}, {-4, -4}};
    constexpr int kFourth[][2] = {{-2, -6}, {6, -2}, {-6, 2}, {2, 6}};
    constexpr int kEighth[][2] = {{1, -3}, {-1, 3}, {5, 1}, {-3, -5},
                                  {-5, 5}, {-7, -1}, {3, 7}, {7, -7}};
    constexpr int kSixteenth[][2] = {{1, 1},  {-1, -3}, {-3, 2}, {4, -1}, {-5, -2}, {2, 5},
                                     {5, 3},  {3, -5},  {-2, 6}, {0, -7}, {-4, -6}, {-6, 4},
                                     {-8, 0}, {7, -4},  {6, 7},  {-7, -8}};
    std::vector<SampleOffset> result;
    const auto add = [&result](const auto& places) {
        for (const auto& p : places)
            result.push_back({static_cast<float>(p[0]) / 16.0f, static_cast<float>(p[1]) / 16.0f});
    };
    if (samples == 2) add(kTwo), add(kTwo);  // twice, to fill four
    if (samples == 4) add(kFourth);
    if (samples == 8) add(kEighth);
    if (samples == 16) add(kSixteenth);
    return result;
}

SubSample subSample(int index, int count, const Vec3& sun) {
    SubSample sample;
    sample.pixel = {mirrored(index + 1, 2) - 0.5f, mirrored(index + 1, 3) - 0.5f};
    const Vec3 middle = sun.normalized();
    const Vec3 helper = std::abs(middle.y()) < 0.9f ? Vec3(Vec3::UnitY()) : Vec3(Vec3::UnitX());
    const Vec3 u = helper.cross(middle).normalized(), v = middle.cross(u);
    const Eigen::Vector2f disc = onDisc(strip(index, count, 7), mirrored(index, 2));
    sample.toSun = (middle + kSunRadius * (disc.x() * u + disc.y() * v)).normalized();
    sample.lens = onDisc(strip(index, count, 3), mirrored(index, 3));
    sample.turn = strip(index, count, 5);
    return sample;
}

}  // namespace render
