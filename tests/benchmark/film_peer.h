/// What the drivers of tests/benchmark/film share: one picture, and a clock.
#pragma once
#include <time.h>

#include <algorithm>
#include <functional>
#include <random>
#include <vector>

#include "render/frame.h"
#include "render/palette.h"

namespace film_peer {

constexpr int kWidth = 1280, kHeight = 720, kSamples = 4, kFrames = 12;

inline double processorMs() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

inline double medianOf(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0.0 : values[values.size() / 2];
}

/// Over kFrames pictures, without the first, which compiles shaders.
inline double timeFrames(const std::function<void()>& draw) {
    std::vector<double> ms;
    for (int i = 0; i <= kFrames; ++i) {
        const double before = processorMs();
        draw();
        if (i > 0) ms.push_back(processorMs() - before);
    }
    return medianOf(ms);
}

/// A wall of 196 bricks with a hole, three balls in front of it and a large one: 200 bodies.
inline std::vector<render::Solid> bodies() {
    std::vector<render::Solid> all;
    std::minstd_rand random(5);
    const auto spread = [&] { return static_cast<float>(random() % 10000) / 10000.0f - 0.5f; };
    for (int i = 0; i < 196; ++i) {
        const int row = i / 14, column = i % 14;
        render::Solid brick;
        brick.halfSize = {0.25f, 0.12f, 0.15f};
        brick.position = {-3.3f + 0.5f * static_cast<float>(column) + (row % 2 ? 0.25f : 0.0f),
                          0.12f + 0.24f * static_cast<float>(row), 0.0f};
        if ((brick.position - render::Vec3(0.3f, 1.6f, 0)).norm() < 1.0f) {
            const float x = spread(), y = spread(), z = spread();
            brick.position += render::Vec3(0.8f * x, 0.8f * y, 1.2f * z - 0.6f);
            brick.rotation = render::Quat(1, x, y, z).normalized();
        }
        all.push_back(brick);
    }
    for (int i = 0; i < 4; ++i) {
        render::Solid ball;
        ball.shape = render::SolidShape::sphere;
        const float radius = i == 0 ? 0.5f : 0.2f;
        ball.halfSize.setConstant(radius);
        ball.position = {i == 0 ? 0.3f : 1.5f * static_cast<float>(i) - 3.5f, radius + 0.3f,
                         i == 0 ? 1.2f : 2.5f};
        all.push_back(ball);
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i].color = render::paletteColor(static_cast<int>(i));
        all[i].id = static_cast<int>(i);
    }
    return all;
}

inline const render::Vec3 kFrom(5.5f, 3.6f, 9.5f), kLookAt(0.2f, 1.5f, 0.0f);

}  // namespace film_peer
