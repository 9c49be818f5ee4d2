// Edges: rays that hit surfaces, the samples taken along them, and the partial coverage of trails.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "render/edge_samples.h"
#include "render/ground_corners.h"
#include "render/palette.h"
#include "render/renderer.h"
#include "render/trails.h"
#include "tests/render/averages.h"
#include "tests/render/ray_walks.h"

namespace render {
namespace {

Frame oneSurfaceOfEach() {
    Frame frame;
    frame.camera = {{2, 3, 7}, {0, 1.6f, 0}, {0, 1, 0}, 40};
    frame.grounds.push_back({});
    Solid box;
    box.rotation = Quat(Eigen::AngleAxisf(0.7f, Vec3(1, 2, 3).normalized()));
    box.position = {0, 1, 0};
    Solid ball = box, capsule = box;
    ball.shape = SolidShape::sphere, ball.halfSize = Vec3::Constant(0.6f);
    capsule.shape = SolidShape::capsule, capsule.halfSize = {0.3f, 0.7f, 0.3f};
    frame.solids = {box, ball, capsule};
    Rod rod;
    rod.from = {-1, 0.5f, 0}, rod.to = {1, 1.5f, 0.4f}, rod.radius = 0.2f;
    frame.rods.push_back(rod);
    return frame;
}

TEST(EdgeRays, EnterWhereAWalkAlongThemGetsInside) {
    const Frame frame = oneSurfaceOfEach();
    const Sight sight = sightOf(viewOf(frame, 64, 36), 64, 36);
    std::mt19937 random(7);
    std::uniform_real_distribution<float> share(0.0f, 1.0f);
    for (const Surface& surface : surfacesOf(frame)) {
        const SeenSurface seen(surface, sight);
        const bool tube = surface.kind == SurfaceKind::bar;
        int hits = 0, misses = 0;
        for (int i = 0; i < 40; ++i) {
            Four x, y;
            for (int lane = 0; lane < kFour; ++lane)
                x[lane] = (0.3f + 0.4f * share(random)) * 64, y[lane] = share(random) * 36;
            const FourHits found = seen.enter(x, y);
            for (int lane = 0; lane < kFour; ++lane) {
                const Vec3 along = sight.ahead + x[lane] * sight.right + y[lane] * sight.down;
                const double walked =
                    walk(surface, sight.eye.cast<double>(), along.cast<double>());
                const double t = std::min(static_cast<double>(found.t[lane]), kFarthest);
                if (tube && t == kFarthest) continue;  // a walk may enter through an open end
                EXPECT_NEAR(t, walked, 2e-3) << "surface " << static_cast<int>(surface.kind);
                ++(t < kFarthest ? hits : misses);
            }
        }
        EXPECT_GT(hits, 3) << static_cast<int>(surface.kind);
        EXPECT_TRUE(tube || misses > 3) << static_cast<int>(surface.kind);
    }
}

TEST(EdgeRays, NameTheFaceOfABox) {
    Frame frame;
    frame.solids.emplace_back();
    const struct {
        Vec3 from;
        int face;
    } cases[] = {{{-5, 0, 0}, 0}, {{5, 0, 0}, 1}, {{0, -5, 0.1f}, 2},
                 {{0, 5, 0.1f}, 3}, {{0, 0, -5}, 4}, {{0, 0, 5}, 5}};
    for (const auto& one : cases) {
        frame.camera = {one.from, {0, 0, 0}, Vec3(0.1f, 1, 0.2f).normalized(), 30};
        const SeenSurface box(surfacesOf(frame)[0], sightOf(viewOf(frame, 8, 8), 8, 8));
        const FourHits hits = box.enter(fourOf(4.0f), fourOf(4.0f));
        EXPECT_EQ(hits.face[0], one.face);
        EXPECT_NEAR(hits.t[0], 4.5f, 0.01f);
    }
}

TEST(EdgeRays, DoNotMeetWhatIsBehindTheEye) {
    Frame frame = oneSurfaceOfEach();
    frame.camera.lookAt = {4, 6, 14};  // away from all of them
    const Sight sight = sightOf(viewOf(frame, 8, 8), 8, 8);
    const std::vector<Surface> surfaces = surfacesOf(frame);
    for (std::size_t i = 0; i + 1 < surfaces.size(); ++i) {
        const FourHits hits = SeenSurface(surfaces[i], sight).enter(fourOf(4), fourOf(4));
        EXPECT_TRUE(std::isinf(hits.t[0])) << i;
    }
}

/// Every surface has a single colour.
Frame flatSurfaces() {
    Frame frame = oneSurfaceOfEach();
    frame.look.shadows = frame.look.ambientOcclusion = frame.look.edges = false;
    frame.grounds.clear();  // its lines have the same width in a larger picture
    Solid floor;
    floor.position = {0, -1, 0}, floor.halfSize = {4, 0.6f, 4}, floor.color = fromHex(0x808890);
    frame.solids[0].color = fromHex(0x1f77d0);
    frame.solids[1].position = {1.2f, 1.0f, 0.5f}, frame.solids[1].color = fromHex(0xd02020);
    frame.solids[2].position = {-1.4f, 0.8f, 0.5f}, frame.solids[2].color = fromHex(0xe0c020);
    frame.solids.push_back(floor);
    frame.rods[0].radius = 0.05f, frame.rods[0].from.y() = frame.rods[0].to.y() = 2.2f;
    return frame;
}

TEST(EdgeSamples, AreAsGoodAsAMuchLargerPicture) {
    const Frame frame = flatSurfaces();
    const Image exact = shrunk(Renderer(plainSettings(8 * 160, 8 * 90, 1)).draw(frame));
    std::vector<double> off;
    for (const int samples : {1, 2, 4, 8, 16})
        off.push_back(apart(Renderer(plainSettings(160, 90, samples)).draw(frame), exact));
    for (std::size_t i = 1; i < off.size(); ++i) EXPECT_LT(off[i], off[i - 1]) << i;
    EXPECT_LT(off.back(), 0.33 * off.front());
    EXPECT_LT(off[3], 1.5);  // levels
}

TEST(EdgeSamples, LeaveAllElseAsItIs) {
    const Frame frame = flatSurfaces();
    Renderer renderer(plainSettings(160, 90, 1));
    const Image before = renderer.draw(frame);
    const SurfaceMap map = renderer.surfaces(frame);
    Image after = before;
    smoothEdges(after, map, frame, viewOf(frame, 160, 90), 8);
    int changed = 0;
    for (int y = 1; y + 1 < 90; ++y)
        for (int x = 1; x + 1 < 160; ++x) {
            const bool same = std::equal(before.at(x, y), before.at(x, y) + 4, after.at(x, y));
            const int s = map.at(x, y);
            const bool inner = s == map.at(x - 1, y) && s == map.at(x + 1, y) &&
                               s == map.at(x, y - 1) && s == map.at(x, y + 1);
            EXPECT_TRUE(same || !inner) << x << "," << y;
            changed += !same;
        }
    EXPECT_GT(changed, 100);
}

TEST(EdgeSamples, WorkOnPicturesOfAnySize) {
    const Frame frame = flatSurfaces();
    for (const auto& [w, h] : {std::pair(1, 1), {1, 7}, {2, 3}, {5, 1}, {7, 6}}) {
        SurfaceMap map{w, h, std::vector<std::int32_t>(static_cast<std::size_t>(w * h))};
        Image image{w, h, std::vector<std::uint8_t>(static_cast<std::size_t>(4 * w * h), 90)};
        for (std::size_t i = 0; i < map.packed.size(); ++i)
            map.packed[i] = i % 3 == 0 ? kNoSurface : packedSurface(static_cast<int>(i % 3), 0);
        const std::vector<std::uint8_t> before = image.pixels;
        smoothEdges(image, map, frame, viewOf(frame, w, h), 4);
        EXPECT_EQ(image.pixels, before);  // the mean of one colour
    }
}

/// A slab half in a ghost box, as in water; with glass before all.
Frame afloat(bool glass) {
    Frame frame = flatSurfaces();
    frame.solids.erase(frame.solids.begin() + 1, frame.solids.end());
    frame.rods.clear();
    frame.solids[0].color = fromHex(0xf0e0d0);
    Solid water;
    water.position = {0, 0.2f, 0}, water.halfSize = {3, 0.8f, 1.2f};
    water.color = {0.1f, 0.3f, 0.8f, 0.7f};
    frame.ghosts.push_back(water);
    if (!glass) return frame;
    Solid pane;
    pane.position = {0, 1, 2}, pane.halfSize = {4, 3, 0.02f}, pane.material = Material::glass;
    frame.solids.push_back(pane);
    return frame;
}

TEST(Ghosts, MeetBodiesInASmoothLine) {
    const SurfaceMap map = Renderer(plainSettings(160, 90, 1)).surfaces(afloat(false));
    for (const bool glass : {false, true}) {
        const Frame frame = afloat(glass);
        Frame dry = frame;
        dry.ghosts.clear();
        const Image exact = shrunk(Renderer(plainSettings(8 * 160, 8 * 90, 8)).draw(frame));
        const Image before = Renderer(plainSettings(160, 90, 1)).draw(dry);
        for (const int samples : {1, 8}) {
            const Image small = Renderer(plainSettings(160, 90, samples)).draw(frame);
            int under = 0, over = 0;
            for (int y = 1; y < 89; ++y)  // on the slab, away from its own edges
                for (int x = 1; x < 159; ++x) {
                    const int s = map.at(x, y);
                    if (map.surface(x, y) != 0 || map.at(x - 1, y) != s || map.at(x + 1, y) != s ||
                        map.at(x, y - 1) != s || map.at(x, y + 1) != s)
                        continue;
                    for (int c = 0; c < 3; ++c)
                        EXPECT_NEAR(small.at(x, y)[c], exact.at(x, y)[c], 16)
                            << x << "," << y << (glass ? " behind glass" : "");
                    ++(std::abs(small.at(x, y)[0] - before.at(x, y)[0]) > 30 ? under : over);
                }
            EXPECT_GT(under, 40);
            EXPECT_GT(over, 40);
        }
    }
}

TEST(EdgeSamples, AThinRodHasNoGaps) {
    Frame frame;
    frame.camera = {{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 35};
    frame.look.shadows = frame.look.ambientOcclusion = false;
    Rod rod;
    rod.from = {-0.3f, -2.5f, 0}, rod.to = {0.2f, 2.5f, 0}, rod.radius = 0.002f;  // 0.06 pixels
    rod.color = fromHex(0x101010);
    frame.rods.push_back(rod);
    const Image image = Renderer(plainSettings(160, 90, 8)).draw(frame);
    for (int y = 10; y < 80; ++y) {
        int darkest = 255;
        for (int x = 60; x < 100; ++x) darkest = std::min<int>(darkest, image.at(x, y)[1]);
        EXPECT_LT(darkest, 150) << y;
    }
}

TEST(RowsOfSky, HoldAllOfItAndLittleElse) {
    const struct {
        Camera camera;
        int fewest, most;
    } cases[] = {{{{8, 5, 14}, {0, 2, 0}, {0, 1, 0}, 35}, 15, 60},
                 {{{8, 5, 14}, {0, 2, 0}, Vec3(0.5f, 1, 0).normalized(), 35}, 40, 90},
                 {{{0, 9, 1}, {0, 0, 0}, {0, 1, 0}, 35}, 0, 0},    // straight down
                 {{{0, 1, 5}, {0, 9, 0}, {0, 1, 0}, 35}, 90, 90},  // up
                 {{{0, 200, 900}, {0, 0, 0}, {0, 1, 0}, 35}, 1, 60},
                 {{{0, -2, 9}, {0, 0, 0}, {0, 1, 0}, 35}, 10, 90}};  // from below
    for (const auto& one : cases) {
        Frame frame;
        frame.camera = one.camera;
        frame.grounds.push_back({});
        const int rows = rowsOfSky(frame, viewOf(frame, 160, 90), 160, 90);
        const Vec3& from = one.camera.from;
        EXPECT_GE(rows, one.fewest) << from.transpose();
        EXPECT_LE(rows, one.most) << from.transpose();
        const SurfaceMap map = Renderer(plainSettings(160, 90, 1)).surfaces(frame);
        for (int y = rows; y < 90; ++y)
            for (int x = 0; x < 160; ++x)
                ASSERT_NE(map.at(x, y), kNoSurface) << from.transpose() << ": " << x << "," << y;
    }
}

TEST(Trails, CoverAsMuchAsTheyAreWide) {
    Frame frame;
    frame.camera = {{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 35};
    frame.look.shadows = frame.look.ambientOcclusion = false;
    const Image empty = Renderer(plainSettings(160, 90, 1)).draw(frame);
    Trail trail;
    trail.color = {0, 0, 0, 1};
    for (float y = -2.0f; y < 2.01f; y += 0.1f) trail.points.push_back({0.1f * (y + 2.0f), y, 0});
    trail.pixels = 16.0f;  // at 720 rows: 2 here
    frame.trails.push_back(trail);
    const Image image = Renderer(plainSettings(160, 90, 1)).draw(frame);
    double before = 1e9;
    for (int y = 20; y < 50; ++y) {  // from the newest point, which is the widest and darkest, down
        double missing = 0.0;
        for (int x = 0; x < 160; ++x) missing += empty.at(x, y)[1] - image.at(x, y)[1];
        missing /= empty.at(0, y)[1];
        EXPECT_GT(missing, 0.2) << y;
        EXPECT_LT(missing, before + 0.03) << y;  // black ink, in pixels: no steps, no gaps
        before = missing;
    }
}

}  // namespace
}  // namespace render
