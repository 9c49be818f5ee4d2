#include "demos/export/replay_codec.h"

#include <algorithm>
#include <cmath>

#include "demos/text/base64.h"
#include "demos/text/deflate.h"

namespace demos {
namespace {

constexpr double kWords = 65535.0;
constexpr double kThird = 0.70710678118654752;  // the most that a smaller number can be
constexpr double kSteps = 32767.0;              // of 15 bits
constexpr double kHalfByte = 127.5;

double signOf(double x) { return x < 0.0 ? -1.0 : 1.0; }

std::uint16_t nearestWord(double value, double most) {
    return static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0, most)));
}

}  // namespace

std::uint16_t WordRange::wordOf(double value) const {
    return size > 0.0 ? nearestWord((value - low) / size * kWords, kWords) : std::uint16_t{0};
}

double WordRange::valueOf(std::uint16_t word) const { return low + size * word / kWords; }

WordRange rangeOf(std::span<const double> values) {
    if (values.empty()) return {};
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return {*low, *high - *low};
}

RotationWords wordsOf(const engine::Quat& rotation) {
    const Eigen::Vector4d q = rotation.normalized().coeffs();
    Eigen::Index largest = 0;
    q.cwiseAbs().maxCoeff(&largest);
    const double sign = signOf(q[largest]);
    RotationWords words{};
    std::size_t next = 0;
    for (Eigen::Index i = 0; i < 4; ++i)
        if (i != largest)
            words[next++] = nearestWord((0.5 + 0.5 * sign * q[i] / kThird) * kSteps, kSteps);
    words[0] = static_cast<std::uint16_t>(words[0] | (largest & 1) << 15);
    words[1] = static_cast<std::uint16_t>(words[1] | (largest >> 1) << 15);
    return words;
}

engine::Quat rotationOf(const RotationWords& words) {
    const Eigen::Index largest = words[0] >> 15 | (words[1] >> 15) << 1;
    Eigen::Vector4d q = Eigen::Vector4d::Zero();
    std::size_t next = 0;
    for (Eigen::Index i = 0; i < 4; ++i)
        if (i != largest) q[i] = (2.0 * (words[next++] & 0x7fff) / kSteps - 1.0) * kThird;
    q[largest] = std::sqrt(std::max(1.0 - q.squaredNorm(), 0.0));
    return engine::Quat(q[3], q[0], q[1], q[2]);
}

std::uint16_t directionWord(const engine::Vec3& direction) {
    const engine::Vec3 d = direction / std::max(direction.lpNorm<1>(), 1e-300);
    double u = d.x(), v = d.y();
    if (d.z() < 0.0) {
        u = (1.0 - std::abs(d.y())) * signOf(d.x());
        v = (1.0 - std::abs(d.x())) * signOf(d.y());
    }
    return static_cast<std::uint16_t>(nearestWord((u + 1.0) * kHalfByte, 255.0) << 8 |
                                      nearestWord((v + 1.0) * kHalfByte, 255.0));
}

engine::Vec3 directionOf(std::uint16_t word) {
    const double u = (word >> 8) / kHalfByte - 1.0, v = (word & 0xff) / kHalfByte - 1.0;
    engine::Vec3 d(u, v, 1.0 - std::abs(u) - std::abs(v));
    if (d.z() < 0.0) {
        d.x() = (1.0 - std::abs(v)) * signOf(u);
        d.y() = (1.0 - std::abs(u)) * signOf(v);
    }
    return d.normalized();
}

std::string textOfColumns(std::span<const std::uint16_t> words, std::size_t length) {
    std::vector<std::uint8_t> bytes(2 * words.size());
    for (std::size_t i = 0; i < words.size(); ++i) {
        const int before = i % length == 0 ? 0 : words[i - 1];
        const auto step = static_cast<std::uint16_t>(words[i] - before);
        bytes[i] = static_cast<std::uint8_t>(step & 0xff);
        bytes[words.size() + i] = static_cast<std::uint8_t>(step >> 8);
    }
    return toBase64(deflated(bytes));
}

}  // namespace demos
