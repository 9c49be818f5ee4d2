// Data passes against closed forms: planes, spheres and boxes at known places, for a known camera.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/render/data_frames.h"

namespace render {
namespace {

/// From (0, 0, 10) along -z, upright.
Frame emptyAhead() {
    Frame frame;
    frame.camera = {{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 40};
    return frame;
}

Solid solid(SolidShape shape, const Vec3& at, const Vec3& half, int id) {
    Solid s;
    s.shape = shape;
    s.position = at;
    s.halfSize = half;
    s.id = id;
    return s;
}

std::size_t at(int x, int y) { return static_cast<std::size_t>(y) * kDataWidth + x; }

/// The ray of a pixel's centre in emptyAhead(), 1 m long along the view axis.
Eigen::Vector3d ray(int x, int y) {
    const double tangent = std::tan(20.0 * 3.14159265358979 / 180.0);
    return {(2.0 * (x + 0.5) / kDataWidth - 1.0) * tangent * kDataWidth / kDataHeight,
            (1.0 - 2.0 * (y + 0.5) / kDataHeight) * tangent, -1.0};
}

Eigen::Vector2d seenAt(const Eigen::Vector3d& fromEye) {
    const double f = 0.5 * kDataHeight / std::tan(20.0 * 3.14159265358979 / 180.0);
    return {0.5 * kDataWidth - f * fromEye.x() / fromEye.z(),
            0.5 * kDataHeight + f * fromEye.y() / fromEye.z()};
}

TEST(DataPass, DepthOfASlantedPlaneIsExactAtEveryPixel) {
    Frame frame = emptyAhead();
    // through (0, -1, 0), leaning towards the viewer: n . x = offset
    const Vec3 n = Vec3(0.2f, 1.0f, 0.5f).normalized();
    frame.grounds.push_back({true, n, -n.y(), 0});
    const DataImages data = dataOf(frame);
    int covered = 0;
    for (int y = 0; y < kDataHeight; ++y)
        for (int x = 0; x < kDataWidth; ++x) {
            const Eigen::Vector3d d = ray(x, y), m = n.cast<double>();
            const double t = (-m.y() - 10.0 * m.z()) / m.dot(d);
            if (data.id[at(x, y)] == 0) continue;
            ++covered;
            ASSERT_NEAR(data.depth[at(x, y)], t, 1e-5 * t) << x << "," << y;
            ASSERT_LT((data.normal[at(x, y)] - n).norm(), 1e-6f);
        }
    EXPECT_GT(covered, kDataWidth * kDataHeight / 2);
}

TEST(DataPass, ASphereIsRoundAndTheSkyIsNothing) {
    Frame frame = emptyAhead();
    frame.solids.push_back(solid(SolidShape::sphere, {0, 0, 0}, {2, 2, 2}, 6));
    const DataImages data = dataOf(frame);
    for (int y = 0; y < kDataHeight; ++y)
        for (int x = 0; x < kDataWidth; ++x) {
            const Eigen::Vector3d d = ray(x, y);
            const double a = d.squaredNorm(), b = 10.0 * d.z(), c = 96.0;
            const double root = b * b - a * c;
            if (data.id[at(x, y)] == 0) {
                EXPECT_EQ(data.depth[at(x, y)], kNoDepth);
                EXPECT_EQ(data.normal[at(x, y)], Vec3(0, 0, 0));
                continue;
            }
            ASSERT_EQ(data.id[at(x, y)], 7);
            if (root < 0.0) continue;  // the outermost pixels: see enter()
            const double t = (-b - std::sqrt(root)) / a;
            const Eigen::Vector3d normal = (t * d + Eigen::Vector3d(0, 0, 10)) / 2.0;
            // the camera is in floats: 1e-6 of the angle, more for a grazing ray
            const double hard = 1e-4 / std::max(std::sqrt(root), 0.05);
            ASSERT_NEAR(data.depth[at(x, y)], t, hard) << x << "," << y;
            ASSERT_LT((data.normal[at(x, y)].cast<double>() - normal).norm(), hard);
        }
    EXPECT_NEAR(data.depth[at(kDataWidth / 2, kDataHeight / 2)], 8.0f, 1e-3f);
}

// The outline of the mesh is within a pixel of the sphere's.
TEST(DataPass, TheOutlineIsThatOfTheSphere) {
    Frame frame = emptyAhead();
    frame.solids.push_back(solid(SolidShape::sphere, {0, 0, 0}, {2, 2, 2}, 0));
    const DataImages data = dataOf(frame);
    int inside = 0, round = 0;
    for (int y = 0; y < kDataHeight; ++y)
        for (int x = 0; x < kDataWidth; ++x) {
            inside += data.id[at(x, y)] != 0;
            const Eigen::Vector3d d = ray(x, y);
            round += 100.0 * d.z() * d.z() - 96.0 * d.squaredNorm() >= 0.0;
        }
    EXPECT_NEAR(inside, round, 0.02 * round);
}

TEST(DataPass, NormalsOfATurnedBoxAreItsAxes) {
    Frame frame = emptyAhead();
    Solid box = solid(SolidShape::box, {0.3f, 0.2f, 0}, {1, 1.5f, 0.5f}, 2);
    box.rotation = Quat(Eigen::AngleAxisf(0.7f, Vec3(1, 2, 0.5f).normalized()));
    frame.solids.push_back(box);
    const DataImages data = dataOf(frame);
    const Eigen::Matrix3f axes = box.rotation.toRotationMatrix();
    int faces[3] = {0, 0, 0};
    for (std::size_t i = 0; i < data.id.size(); ++i) {
        if (data.id[i] == 0) continue;
        const Vec3 local = axes.transpose() * data.normal[i];
        Eigen::Index axis = 0;
        ASSERT_NEAR(local.cwiseAbs().maxCoeff(&axis), 1.0f, 1e-6f);
        const Eigen::Vector3d d =
            ray(static_cast<int>(i) % kDataWidth, static_cast<int>(i) / kDataWidth);
        ASSERT_LT(data.normal[i].cast<double>().dot(d), 0.0);  // towards the viewer
        ++faces[axis];
        // and the point lies in that face
        const Eigen::Vector3d p =
            static_cast<double>(data.depth[i]) * d + Eigen::Vector3d(0, 0, 10) -
            box.position.cast<double>();
        const Vec3 inBox = axes.transpose() * p.cast<float>();
        ASSERT_NEAR(std::abs(inBox[axis]), box.halfSize[axis], 2e-5f);
    }
    for (const int count : faces) EXPECT_GT(count, 20);
}

// Between two boxes of one size the rasteriser's rounding decides; a ray that barely misses the
// front of the lower one would hit its covered top.
TEST(DataPass, ACoveredFaceIsNeverSeen) {
    Frame frame = emptyAhead();
    frame.camera.from = {4, 3, 9};
    for (int i = 0; i < 8; ++i)
        frame.solids.push_back(solid(SolidShape::box, {0, 0.4f * static_cast<float>(i) - 1.6f, 0},
                                     {0.7f, 0.2f, 0.7f}, i));
    const DataImages data = dataOf(frame);
    int covered = 0;
    for (std::size_t i = 0; i < data.id.size(); ++i) {
        if (data.id[i] == 0 || data.id[i] == 8) continue;
        ++covered;
        ASSERT_LT(data.normal[i].y(), 0.5f) << i;
    }
    EXPECT_GT(covered, 500);
}

TEST(DataPass, TheNearerOfTwoBodiesIsNamed) {
    Frame frame = emptyAhead();
    frame.solids.push_back(solid(SolidShape::box, {0, 0, 0}, {2, 2, 0.5f}, 0));
    frame.solids.push_back(solid(SolidShape::box, {1, 0, 2}, {1, 1, 0.5f}, 40000));
    frame.rods.push_back({{-1.5f, -1, 3}, {-1.5f, 1, 3}, 0.2f, {}, 12});
    const DataImages data = dataOf(frame);
    const auto pixel = [](const Vec3& p) {
        const Eigen::Vector2d seen = seenAt(p.cast<double>() - Eigen::Vector3d(0, 0, 10));
        return at(static_cast<int>(seen.x()), static_cast<int>(seen.y()));
    };
    EXPECT_EQ(data.id[pixel({1, 0, 2.5f})], 40001);
    EXPECT_EQ(data.id[pixel({0, 1.5f, 0.5f})], 1);
    EXPECT_EQ(data.id[pixel({-1.5f, 0, 3.2f})], 13);
    EXPECT_NEAR(data.depth[pixel({-1.5f, 0, 3.2f})], 6.8f, 0.02f);
    EXPECT_EQ(data.id[at(0, 0)], 0);
}

TEST(DataPass, ACapsuleIsRoundAtItsEndsAndStraightBetween) {
    Frame frame = emptyAhead();
    frame.solids.push_back(solid(SolidShape::capsule, {0, 0, 0}, {0.8f, 1.2f, 0.8f}, 0));
    const DataImages data = dataOf(frame);
    int covered = 0;
    for (int y = 0; y < kDataHeight; ++y)
        for (int x = 0; x < kDataWidth; ++x) {
            if (data.id[at(x, y)] == 0) continue;
            ++covered;
            const Eigen::Vector3d p =
                static_cast<double>(data.depth[at(x, y)]) * ray(x, y) + Eigen::Vector3d(0, 0, 10);
            const double core = std::clamp(p.y(), -1.2, 1.2);
            const Eigen::Vector3d out = p - Eigen::Vector3d(0, core, 0);
            ASSERT_NEAR(out.norm(), 0.8, 5e-3) << x << "," << y;  // at the very outline
            ASSERT_GT(out.normalized().dot(data.normal[at(x, y)].cast<double>()), 0.999);
        }
    EXPECT_GT(covered, 500);
}

TEST(DataPass, FlowOfAMovedAndTurnedBoxIsTheDifferenceOfItsProjections) {
    Frame now = emptyAhead(), next = emptyAhead();
    Solid box = solid(SolidShape::box, {0.1f, 0, 0}, {1, 1.2f, 0.6f}, 0);
    box.rotation = Quat(Eigen::AngleAxisf(0.3f, Vec3::UnitY()));
    now.solids.push_back(box);
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.2, Eigen::Vector3d(1, 1, 0).normalized()));
    const Eigen::Vector3d move(0.3, -0.2, 0.5);
    box.position += move.cast<float>();
    box.rotation = turn.cast<float>() * box.rotation;
    next.solids.push_back(box);
    const DataImages data = dataOf(now, &next);
    int covered = 0;
    for (int y = 0; y < kDataHeight; ++y)
        for (int x = 0; x < kDataWidth; ++x) {
            if (data.id[at(x, y)] == 0) {
                ASSERT_EQ(data.flow[at(x, y)], Eigen::Vector2f(0, 0));  // the sky does not move
                continue;
            }
            ++covered;
            const Eigen::Vector3d eye(0, 0, 10), middle(0.1, 0, 0);
            const Eigen::Vector3d p = static_cast<double>(data.depth[at(x, y)]) * ray(x, y) + eye;
            const Eigen::Vector3d moved = turn * (p - middle) + middle + move;
            const Eigen::Vector2d flow = seenAt(moved - eye) - Eigen::Vector2d(x + 0.5, y + 0.5);
            ASSERT_LT((flow - data.flow[at(x, y)].cast<double>()).norm(), 1e-3) << x << "," << y;
        }
    EXPECT_GT(covered, 500);
}

TEST(DataPass, FlowUnderAMovingCameraIsThatOfTheStandingPoints) {
    Frame now = emptyAhead(), next = emptyAhead();
    for (Frame* frame : {&now, &next}) {
        frame->grounds.push_back({true, {0, 1, 0}, -1.5f, 0});
        frame->solids.push_back(solid(SolidShape::sphere, {0, 0, 0}, {1, 1, 1}, 1));
    }
    next.camera.from = {0.5f, 0.25f, 9};  // still looks along -z
    next.camera.lookAt = {0.5f, 0.25f, 0};
    const DataImages data = dataOf(now, &next);
    int sky = 0;
    for (int y = 0; y < kDataHeight; ++y)
        for (int x = 0; x < kDataWidth; ++x) {
            const Eigen::Vector2d pixel(x + 0.5, y + 0.5);
            const Eigen::Vector2d flow = data.flow[at(x, y)].cast<double>();
            if (data.id[at(x, y)] == 0) {
                ++sky;
                ASSERT_LT(flow.norm(), 1e-4);  // infinitely far away, and the camera does not turn
                continue;
            }
            const Eigen::Vector3d p = static_cast<double>(data.depth[at(x, y)]) * ray(x, y);
            const Eigen::Vector2d expected = seenAt(p - Eigen::Vector3d(0.5, 0.25, -1)) - pixel;
            ASSERT_LT((flow - expected).norm(), 1e-3 * (1 + expected.norm())) << x << "," << y;
        }
    EXPECT_GT(sky, 100);
}

TEST(DataPass, FlowIsUnknownWithoutANextFrameAndForWhatIsGone) {
    Frame now = emptyAhead(), next = emptyAhead();
    now.solids.push_back(solid(SolidShape::sphere, {0, 0, 0}, {1, 1, 1}, 1));
    const std::size_t middle = at(kDataWidth / 2, kDataHeight / 2);
    EXPECT_EQ(dataOf(now).flow[middle].x(), kNoFlow);
    EXPECT_EQ(dataOf(now).flow[0].y(), kNoFlow);
    EXPECT_EQ(dataOf(now, &next).flow[middle].x(), kNoFlow);
    EXPECT_EQ(dataOf(now, &next).flow[0].x(), 0.0f);
}

// White bodies on black, lit by ambient light only: every bright pixel belongs to a body.
TEST(DataPass, LinesUpWithThePicture) {
    Frame frame = emptyAhead();
    frame.look.skyTop = frame.look.skyHorizon = frame.look.fog = {0, 0, 0, 1};
    frame.look.ambientOcclusion = frame.look.edges = frame.look.shadows = false;
    frame.solids.push_back(solid(SolidShape::sphere, {1, 0.5f, 0}, {1.5f, 1.5f, 1.5f}, 0));
    frame.solids.push_back(solid(SolidShape::box, {-2, -0.7f, 1}, {0.8f, 0.4f, 1}, 1));
    for (Solid& s : frame.solids) s.color = {1, 1, 1, 1};
    const Image picture = dataRenderer().draw(frame);
    const DataImages data = dataOf(frame);
    int covered = 0;
    for (int y = 0; y < kDataHeight; ++y)
        for (int x = 0; x < kDataWidth; ++x) {
            const bool seen = picture.at(x, y)[0] > 20, named = data.id[at(x, y)] != 0;
            ASSERT_EQ(seen, named) << x << "," << y;
            covered += seen;
        }
    EXPECT_GT(covered, 1000);
}

TEST(DataPass, TheLensProjectsAsThePictureDoes) {
    Camera camera{{3, 4, 8}, {0.5f, 1, 0}, {0, 1, 0}, 33};
    const View view = makeView(camera, static_cast<float>(kDataWidth) / kDataHeight);
    const Lens lens = lensOf(view, kDataWidth, kDataHeight);
    const Vec3 world(0.7f, 0.4f, -1.2f);
    const Eigen::Vector4f eye = view.view * world.homogeneous();
    const Projected seen = project(view, world, kDataWidth, kDataHeight);
    const double depth = -static_cast<double>(eye.z());
    EXPECT_NEAR(seen.x, lens.centreX + lens.focalX * static_cast<double>(eye.x()) / depth, 1e-3);
    EXPECT_NEAR(seen.y, lens.centreY - lens.focalY * static_cast<double>(eye.y()) / depth, 1e-3);
    EXPECT_NEAR(seen.depth, depth, 1e-5);
}

TEST(DataPass, ThePictureIsTheSameAfterwards) {
    Frame frame = emptyAhead();
    frame.grounds.push_back({true, {0, 1, 0}, -1.5f, 0});
    frame.solids.push_back(solid(SolidShape::sphere, {0, 0, 0}, {1, 1, 1}, 1));
    const Image before = dataRenderer().draw(frame);
    dataRenderer().surfaces(frame);
    EXPECT_EQ(dataRenderer().draw(frame).pixels, before.pixels);
}

}  // namespace
}  // namespace render
