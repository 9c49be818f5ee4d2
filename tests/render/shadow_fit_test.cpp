#include "render/shadow_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>

#include "render/body_places.h"

namespace render {
namespace {

constexpr int kTexels = 1000, kColumns = 320, kRows = 180;
constexpr float kAspect = 16.0f / 9.0f;

ShadowFit fitOf(const Frame& frame) {
    const View view = makeView(frame.camera, kAspect);
    return fitShadow(frame, view, frame.look.sunDirection, kTexels);
}

Solid ball(const Vec3& at, float radius) {
    Solid solid;
    solid.shape = SolidShape::sphere;
    solid.halfSize = Vec3::Constant(radius);
    solid.position = at;
    return solid;
}

/// A floor, a camera 10 m off and a ball at its subject.
Frame room() {
    Frame frame;
    frame.camera = {{0, 3, 10}, {0, 1, 0}};
    frame.look.sunDirection = {1, 2, 1};
    frame.grounds.push_back({});
    frame.solids.push_back(ball({0, 0.5f, 0}, 0.5f));
    return frame;
}

class Numbers {
public:
    explicit Numbers(unsigned seed) : random_(seed) {}
    float operator()(float low, float high) {
        return low + (high - low) * static_cast<float>(random_() % 100'000) / 100'000.0f;
    }
    Vec3 within(float reach) {
        const float x = (*this)(-reach, reach), y = (*this)(-reach, reach);
        return {x, y, (*this)(-reach, reach)};
    }

private:
    std::minstd_rand random_;
};

/// Where the ray from `from` meets the floor.
std::optional<Vec3> onFloor(const Vec3& from, const Vec3& way) {
    if (from.y() * way.y() >= 0.0f) return {};
    return Vec3(from - from.y() / way.y() * way);
}

/// Where the ray from `from` enters the ball.
std::optional<Vec3> onBall(const Solid& ball, const Vec3& from, const Vec3& way) {
    const Vec3 to = ball.position - from;
    const float along = to.dot(way), radius = ball.halfSize.x();
    const float left = radius * radius - (to - along * way).squaredNorm();
    if (left < 0.0f || along < 0.0f) return {};
    return Vec3(from + (along + std::sqrt(left)) * way);
}

bool isInMap(const ShadowFit& fit, const Vec3& point) {
    const Vec3 p = (fit.worldToTexels() * point.homogeneous()).head<3>();
    return p.x() > 1 && p.y() > 1 && p.x() < kTexels - 1 && p.y() < kTexels - 1 && p.z() > 0 && p.z() < 1;
}

bool isIn(const PixelRect& rect, const Projected& p) {
    const Eigen::Vector2i at(static_cast<int>(p.x), static_cast<int>(p.y));
    return at.x() >= rect.x0 && at.x() < rect.x1 && at.y() >= rect.y0 && at.y() < rect.y1;
}

TEST(ShadowFit, StaysWhileTheCameraDoes) {
    Frame frame = room();
    const ShadowFit first = fitOf(frame);
    Numbers number(1);
    for (int i = 0; i < 200; ++i) {
        frame.solids.resize(1 + i % 3, ball({0, 1, 0}, 0.4f));
        frame.solids[0] = ball(Vec3(0, 1.3f, 0) + number.within(1), number(0.1f, 0.5f));
        EXPECT_TRUE(fitOf(frame) == first) << i;
    }
    frame.camera.lookAt.x() += 0.5f;
    EXPECT_FALSE(fitOf(frame) == first);
}

TEST(ShadowFit, CoversWhatShadesThePicture) {
    Numbers number(2);
    int shaded = 0;
    for (int i = 0; i < 400; ++i) {
        Frame frame = room();
        frame.camera = {number.within(12), number.within(3)};
        frame.camera.from.y() = number(0.5f, 12);
        frame.look.sunDirection = number.within(1);
        frame.look.sunDirection.y() = number(0.2f, 1);
        frame.solids.clear();
        for (int k = 0; k < 3; ++k) frame.solids.push_back(ball(number.within(15), number(0.1f, 3)));
        const ShadowFit fit = fitOf(frame);
        const View view = makeView(frame.camera, kAspect);
        const PixelRect grounds = groundShadows(frame, view, kColumns, kRows, fit);
        for (int ray = 0; ray < 300; ++ray) {
            const float x = number(-1, 1);
            const Vec3 way = view.view.block<3, 3>(0, 0).transpose() *
                             Vec3(x / view.projection(0, 0), number(-1, 1) / view.projection(1, 1), -1);
            const std::optional<Vec3> seen = onFloor(view.eye, way);
            if (!seen || !(way.dot(*seen - view.eye) > 0.0f)) continue;
            for (const Solid& solid : frame.solids) {
                const auto above = onBall(solid, *seen, fit.toLight);
                if (!above || above->y() < 0.0f) continue;
                ++shaded;
                EXPECT_TRUE(isInMap(fit, *above)) << i << ": " << above->transpose();
                EXPECT_TRUE(isIn(grounds, project(view, *seen, kColumns, kRows))) << i;
            }
        }
    }
    EXPECT_GT(shaded, 1000);
}

TEST(ShadowFit, LeavesOutWhatCastsNoShadowIntoThePicture) {
    Frame frame = room();
    const ShadowFit alone = fitOf(frame);
    frame.solids.push_back(ball({0, 60, 0}, 0.5f));  // its shadow is 42 m beside the subject
    EXPECT_TRUE(fitOf(frame) == alone);
    frame.solids.back().position = Vec3(0, 0, -3) + 30.0f * frame.look.sunDirection;  // behind the subject
    EXPECT_FALSE(fitOf(frame) == alone);
    frame.solids.back() = ball({0, 1, 40}, 0.5f);  // behind the eye
    EXPECT_TRUE(fitOf(frame) == alone);
}

TEST(ShadowFit, IsFineEnoughForBodiesFarInFrontOfTheSubject) {
    Frame frame = room();
    const float pixel = 20.0f * std::tan(frame.camera.fovDegrees * 0.00872665f) / kRows;  // m, at 10 m
    EXPECT_LT(fitOf(frame).texel, pixel);
    frame.camera = {{0, 3, 10}, {0, 1, -190}};  // past the ball
    EXPECT_LT(fitOf(frame).texel, pixel);
    frame.camera = {{0, 3, 10}, {0, 2.99f, 9.95f}};  // a subject at the eye: the ball is beyond
    EXPECT_LT(fitOf(frame).texel, pixel);
    EXPECT_TRUE(isInMap(fitOf(frame), {0, 0.5f, 0}));
}

TEST(ShadowFit, StaysInWholeTexelsWhileTheCameraMoves) {
    Frame frame = room();
    const ShadowFit first = fitOf(frame);
    for (int i = 1; i < 50; ++i) {
        const Vec3 way(0.013f * static_cast<float>(i), 0, 0.007f * static_cast<float>(i));
        frame.camera = {Vec3(0, 3, 10) + way, Vec3(0, 1, 0) + way};
        const ShadowFit fit = fitOf(frame);
        for (int axis = 0; axis < 2; ++axis) {
            const float texels = (fit.worldToLight(axis, 3) - first.worldToLight(axis, 3)) / first.texel;
            EXPECT_NEAR(texels, std::round(texels), 0.01f);
        }
    }
}

}  // namespace
}  // namespace render
