// Rays and data passes on cylinders, cones, polyhedra and meshes, against walks and closed forms.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "render/edge_rays.h"
#include "render/mesh_tree.h"
#include "tests/render/data_frames.h"
#include "tests/render/ray_walks.h"
#include "tests/render/solids.h"

namespace render {
namespace {

float shareOf(std::mt19937& random) { return static_cast<float>(random() % 65536u) / 65536.0f; }

/// Seen from above and from the side.
Frame emptyBelow() {
    Frame frame;
    frame.camera = {{2, 3, 7}, {0, 0, 0}, {0, 1, 0}, 30};
    return frame;
}

Solid turned(Solid solid) {
    solid.rotation = Quat(Eigen::AngleAxisf(0.9f, Vec3(1, 2, 3).normalized()));
    solid.position = {0.1f, 0.2f, -0.1f};
    return solid;
}

std::vector<Solid> oneSolidOfEach() {
    return {turned(solidOf(SolidShape::cylinder, {0.7f, 0.9f, 0.7f}, {0, 0, 0}, {})),
            turned(solidOf(SolidShape::cone, {0.8f, 0.7f, 0.8f}, {0, 0, 0}, {})),
            turned(solidOf(octahedron(1.2f), {0, 0, 0}, {})),
            turned(solidOf(hexagonalNut(0.4f), {0, 0, 0}, {})),
            turned(solidOf(angleBar(), {0, 0, 0}, {}))};
}

Vec3d along(const Sight& sight, float x, float y) {
    return (sight.ahead + x * sight.right + y * sight.down).cast<double>();
}

TEST(SolidRays, EnterWhereAWalkAlongThemGetsInside) {
    std::mt19937 random(11);
    const Sight sight =
        sightOf(viewOf(emptyBelow(), kDataWidth, kDataHeight), kDataWidth, kDataHeight);
    for (const Solid& solid : oneSolidOfEach()) {
        const Surface surface = surfaceOf(solid);
        const SeenSurface seen(surface, sight);
        int hits = 0, misses = 0;
        for (int i = 0; i < 60; ++i) {
            Four x, y;
            for (int lane = 0; lane < kFour; ++lane) {
                x[lane] = (0.3f + 0.4f * shareOf(random)) * kDataWidth;
                y[lane] = (0.1f + 0.8f * shareOf(random)) * kDataHeight;
            }
            const FourHits found = seen.enter(x, y);
            for (int lane = 0; lane < kFour; ++lane) {
                const Vec3d way = along(sight, x[lane], y[lane]);
                const Vec3d eye = sight.eye.cast<double>();
                const double walked = walk(surface, eye, way, 2e-3, 5.0, 11.0);
                const double t = std::min(static_cast<double>(found.t[lane]), kFarthest);
                if (t == kFarthest && walked < kFarthest) {  // it barely touches a corner
                    EXPECT_FALSE(isInside(surface, eye + (walked + 0.02) * way));
                    continue;
                }
                if (walked == kFarthest && t < kFarthest) {
                    EXPECT_FALSE(isInside(surface, eye + (t + 0.02) * way));
                    continue;
                }
                EXPECT_NEAR(t, walked, 4e-3) << static_cast<int>(surface.kind);
                ++(t < kFarthest ? hits : misses);
            }
        }
        EXPECT_GT(hits, 30) << static_cast<int>(surface.kind);
        EXPECT_GT(misses, 30) << static_cast<int>(surface.kind);
    }
}

// The four-wide rays find the face; the double-precision rays agree when given that face.
TEST(SolidRays, KnowTheFaceThatTheyEnter) {
    const Sight sight =
        sightOf(viewOf(emptyBelow(), kDataWidth, kDataHeight), kDataWidth, kDataHeight);
    for (const Solid& solid : oneSolidOfEach()) {
        const Surface surface = surfaceOf(solid);
        const SeenSurface seen(surface, sight);
        int hits = 0;
        for (int y = 0; y < kDataHeight; y += 3)
            for (int x = 0; x < kDataWidth; x += 2) {
                const float px = static_cast<float>(x), py = static_cast<float>(y);
                const FourHits found = seen.enter(fourOf(px), fourOf(py));
                if (std::isinf(found.t[0])) continue;
                const Vec3d way = along(sight, px, py);
                const Hit hit = enter(surface, found.face[0], {sight.eye.cast<double>(), way});
                ++hits;
                ASSERT_NEAR(hit.t, static_cast<double>(found.t[0]), 2e-4)
                    << static_cast<int>(surface.kind) << " face " << found.face[0];
                ASSERT_LT(hit.normal.dot(way), 1e-3);
                // a step along the normal is outside: it is the surface's normal
                const Vec3d point = sight.eye.cast<double>() + hit.t * way;
                ASSERT_FALSE(isInside(surface, point + 1e-3 * hit.normal));
            }
        EXPECT_GT(hits, 100);
    }
}

TEST(SolidRays, DoNotMeetWhatIsBehindTheEye) {
    Frame frame = emptyBelow();
    frame.camera.lookAt = {4, 6, 14};
    const Sight sight = sightOf(viewOf(frame, 8, 8), 8, 8);
    for (const Solid& solid : oneSolidOfEach()) {
        const FourHits hits = SeenSurface(surfaceOf(solid), sight).enter(fourOf(4), fourOf(4));
        EXPECT_TRUE(std::isinf(hits.t[0])) << static_cast<int>(solid.shape);
    }
}

TEST(SolidRays, StraightDownAnAxisMeetTheEnd) {
    Frame frame;
    frame.camera = {{0, 9, 0}, {0, 0, 0}, {0, 0, 1}, 30};
    const Sight sight = sightOf(viewOf(frame, 8, 8), 8, 8);
    const Solid cylinder = solidOf(SolidShape::cylinder, {1, 2, 1}, {0, 0, 0}, {});
    const FourHits end = SeenSurface(surfaceOf(cylinder), sight).enter(fourOf(4), fourOf(4));
    EXPECT_NEAR(end.t[0], 7.0f, 1e-5f);
    EXPECT_EQ(end.face[0], 3);
    const Solid cone = solidOf(SolidShape::cone, {1, 2, 1}, {0, 0, 0}, {});
    const FourHits tip = SeenSurface(surfaceOf(cone), sight).enter(fourOf(4), fourOf(4));
    EXPECT_NEAR(tip.t[0], 6.0f, 1e-4f);
}

/// Triangles at random places.
std::shared_ptr<const SolidMesh> soup(int count) {
    std::mt19937 random(5);
    const auto share = [&random] { return shareOf(random) - 0.5f; };
    std::vector<Vec3> corners;
    MeshTriangles triangles;
    for (int i = 0; i < count; ++i) {
        Vec3 middle;
        for (int axis = 0; axis < 3; ++axis) middle[axis] = 3.0f * share();
        for (int corner = 0; corner < 3; ++corner) {
            Vec3 point = middle;
            for (int axis = 0; axis < 3; ++axis) point[axis] += share();
            corners.push_back(point);
        }
        triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return makeMesh(corners, triangles, false);
}

/// By Cramer's rule:  o + t d = a + u e + v f
double meets(const SolidMesh& mesh, std::size_t triangle, const Vec3d& o, const Vec3d& d) {
    const auto& [ia, ib, ic] = mesh.triangles[triangle];
    const Vec3d a = mesh.vertices[ia].cast<double>();
    Mat3d m;
    m << mesh.vertices[ib].cast<double>() - a, mesh.vertices[ic].cast<double>() - a, -d;
    const double none = std::numeric_limits<double>::infinity();
    if (m.col(0).cross(m.col(1)).dot(d) >= 0.0) return none;  // from behind
    const Vec3d uvt = m.inverse() * (o - a);
    const bool inside = uvt.x() >= 0.0 && uvt.y() >= 0.0 && uvt.x() + uvt.y() <= 1.0;
    return inside && uvt.z() > 0.0 ? uvt.z() : none;
}

TEST(MeshTree, FindsWhatTryingAllTrianglesFinds) {
    const auto mesh = soup(300);
    std::mt19937 random(9);
    const auto share = [&random] { return shareOf(random) - 0.5f; };
    int hits = 0;
    for (int i = 0; i < 300; ++i) {
        FourRays rays{{6.0f * share(), 6.0f * share(), 6.0f * share()}, {}};
        for (Four& d : rays.along)
            for (int lane = 0; lane < kFour; ++lane) d[lane] = share();
        const FourTriangles found = nearestTriangles(*mesh, rays);
        for (int lane = 0; lane < kFour; ++lane) {
            const Vec3 way(rays.along[0][lane], rays.along[1][lane], rays.along[2][lane]);
            const Vec3d d = way.cast<double>();
            double nearest = std::numeric_limits<double>::infinity();
            for (std::size_t t = 0; t < mesh->triangles.size(); ++t)
                nearest = std::min(nearest, meets(*mesh, t, rays.from.cast<double>(), d));
            if (std::isinf(nearest)) {
                EXPECT_TRUE(std::isinf(found.t[lane]));
                EXPECT_EQ(found.triangle[lane], -1);
                continue;
            }
            ++hits;
            EXPECT_NEAR(found.t[lane], nearest, 1e-4 * nearest) << i;
        }
    }
    EXPECT_GT(hits, 100);
}

/// Calls check(point, normal) in the solid's axes for every pixel that shows it.
template <class Check>
int forAllPixels(const Solid& solid, Check check) {
    Frame frame = emptyBelow();
    frame.solids.push_back(solid);
    const DataImages data = dataOf(frame);
    const Sight sight = sightOf(viewOf(frame, kDataWidth, kDataHeight), kDataWidth, kDataHeight);
    const Mat3d back = solid.rotation.cast<double>().toRotationMatrix().transpose();
    int covered = 0;
    for (int y = 0; y < kDataHeight; ++y)
        for (int x = 0; x < kDataWidth; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * kDataWidth + x;
            if (data.id[i] == 0) continue;
            ++covered;
            const Vec3d way =
                along(sight, static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            const Vec3d point = sight.eye.cast<double>() +
                                static_cast<double>(data.depth[i]) * way -
                                solid.position.cast<double>();
            check(Vec3d(back * point), Vec3d(back * data.normal[i].cast<double>()));
            if (testing::Test::HasFatalFailure()) return 0;
        }
    return covered;
}

TEST(SolidData, ACylinderIsRoundAtItsSideAndFlatAtItsEnds) {
    int side = 0, end = 0;
    forAllPixels(oneSolidOfEach()[0], [&](const Vec3d& p, const Vec3d& n) {
        if (std::abs(n.y()) > 0.5) {
            ++end;
            ASSERT_NEAR(p.y(), n.y() > 0 ? 0.9 : -0.9, 1e-4);
            ASSERT_NEAR(std::abs(n.y()), 1.0, 1e-6);
        } else {
            ++side;
            ASSERT_NEAR(std::hypot(p.x(), p.z()), 0.7, 5e-3);  // at the very outline
            ASSERT_NEAR(Vec3d(p.x(), 0, p.z()).normalized().dot(n), 1.0, 1e-4);
        }
    });
    EXPECT_GT(side, 300);
    EXPECT_GT(end, 100);
}

TEST(SolidData, AConeGetsThinnerEvenly) {
    Solid cone = oneSolidOfEach()[1];
    for (const float turn : {0.9f, 3.5f}) {  // the second shows the base
        cone.rotation = Quat(Eigen::AngleAxisf(turn, Vec3(1, 0.1f, 0.3f).normalized()));
        int side = 0, base = 0;
        forAllPixels(cone, [&](const Vec3d& p, const Vec3d& n) {
            if (n.y() < -0.5) {
                ++base;
                ASSERT_NEAR(p.y(), -0.35, 1e-4);
                return;
            }
            ++side;
            const double across = std::hypot(p.x(), p.z());
            ASSERT_NEAR(across, 0.8 / 1.4 * (1.05 - p.y()), 5e-3);
            // 1.4 m high, 0.8 m wide: the normal leans up by 0.8 in 1.4
            const Vec3d right = Vec3d(1.4 * p.x() / across, 0.8, 1.4 * p.z() / across).normalized();
            if (across > 0.05) {
                ASSERT_GT(right.dot(n), 0.999);
            }
        });
        EXPECT_GT(side, turn < 1.0f ? 300 : 20);
        EXPECT_GT(base, turn < 1.0f ? -1 : 300);
    }
}

TEST(SolidData, AnOctahedronHasEightFlatFaces) {
    const int covered = forAllPixels(oneSolidOfEach()[2], [](const Vec3d& p, const Vec3d& n) {
        ASSERT_NEAR(n.cwiseAbs().dot(Vec3d::Ones()), std::sqrt(3.0), 1e-5);
        // on the face's plane; a pixel at its border may be slightly beyond
        ASSERT_NEAR(n.dot(p), 1.2 / std::sqrt(3.0), 1e-4);
        ASSERT_NEAR(p.cwiseAbs().sum(), 1.2, 5e-3);
    });
    EXPECT_GT(covered, 500);
}

TEST(SolidData, AMeshIsWhereItsTrianglesAre) {
    const int covered = forAllPixels(oneSolidOfEach()[4], [](const Vec3d& p, const Vec3d& n) {
        const Vec3d size = n.cwiseAbs();
        ASSERT_NEAR(size.maxCoeff(), 1.0, 1e-6);
        if (size.z() > 0.5) {
            ASSERT_NEAR(std::abs(p.z()), 0.5, 1e-4);
            return;
        }
        const double across = size.x() > 0.5 ? p.x() : p.y();
        const bool atOuter = std::abs(std::abs(across) - 1.0) < 1e-4;
        ASSERT_TRUE(atOuter || std::abs(across + 0.4) < 1e-4) << across;
    });
    EXPECT_GT(covered, 500);
}

TEST(SolidData, AHeightFieldIsAsHighAsItsTriangles) {
    const auto valley = heightField(3, 6, [](float x, float) { return 0.5f * std::abs(x); });
    const Solid solid = solidOf(valley, {0, -0.3f, 0}, {});
    const int covered = forAllPixels(solid, [](const Vec3d& p, const Vec3d& n) {
        ASSERT_NEAR(p.y(), 0.5 * std::abs(p.x()), 2e-3);
        ASSERT_NEAR(std::abs(n.x()), 0.5 * n.y(), 1e-6);
    });
    EXPECT_GT(covered, 1500);
}

TEST(SolidData, FlowOfAMovedAndTurnedConeIsTheDifferenceOfItsProjections) {
    Frame now = emptyBelow(), next = emptyBelow();
    now.solids.push_back(oneSolidOfEach()[1]);
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.2, Vec3d(1, 1, 0).normalized()));
    const Vec3d shift(0.2, -0.1, 0.3), from = now.solids[0].position.cast<double>();
    next.solids = now.solids;
    next.solids[0].rotation = turn.cast<float>() * now.solids[0].rotation;
    next.solids[0].position += shift.cast<float>();
    const DataImages data = dataOf(now, &next);
    const View view = viewOf(now, kDataWidth, kDataHeight);
    const Sight sight = sightOf(view, kDataWidth, kDataHeight);
    int covered = 0;
    for (int y = 0; y < kDataHeight; ++y)
        for (int x = 0; x < kDataWidth; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * kDataWidth + x;
            if (data.id[i] == 0) continue;
            ++covered;
            const float px = static_cast<float>(x) + 0.5f, py = static_cast<float>(y) + 0.5f;
            const Vec3d point = sight.eye.cast<double>() +
                                static_cast<double>(data.depth[i]) * along(sight, px, py);
            const Vec3d moved = turn * (point - from) + from + shift;
            const Projected seen = project(view, moved.cast<float>(), kDataWidth, kDataHeight);
            ASSERT_NEAR(data.flow[i].x(), seen.x - px, 2e-3);
            ASSERT_NEAR(data.flow[i].y(), seen.y - py, 2e-3);
        }
    EXPECT_GT(covered, 300);
}

}  // namespace
}  // namespace render
