// How meshes are split for drawing, and pictures of solids made of triangles.
#include "tests/render/solids.h"

#include <gtest/gtest.h>

#include <set>

#include "render/edge_samples.h"
#include "render/error.h"
#include "render/facet_mesh.h"
#include "render/joined_faces.h"
#include "render/pixel_rect.h"
#include "render/renderer.h"
#include "tests/render/averages.h"

namespace render {
namespace {

TEST(SolidMesh, FacetsOfAPolyhedronAreItsFaces) {
    EXPECT_EQ(octahedron(1)->facetCount, 8);
    EXPECT_EQ(hexagonalNut(0.3f)->facetCount, 8);  // each of its ends is four triangles
    EXPECT_EQ(angleBar()->facetCount, 8);
    const auto eight = octahedron(1);
    EXPECT_EQ(eight->planes.size(), 8u);
    for (const MeshPlane& plane : eight->planes)
        EXPECT_NEAR(plane.offset, 1.0 / std::sqrt(3.0), 1e-6);
    EXPECT_TRUE(angleBar()->planes.empty());
}

TEST(SolidMesh, HasItsSize) {
    const auto nut = hexagonalNut(0.3f);
    EXPECT_NEAR(nut->halfSize.x(), 1.0f, 1e-6f);
    EXPECT_NEAR(nut->halfSize.y(), std::sqrt(0.75f), 1e-6f);
    EXPECT_NEAR(nut->thinnest, 0.3f, 1e-6f);
    const auto aside = makeMesh({{1, 0, 0}, {3, 0, 0}, {1, 2, -1}}, {{0, 1, 2}}, false);
    EXPECT_EQ(aside->halfSize, Vec3(3, 2, 1));
}

TEST(SolidMesh, GentleHillsAreOnePieceAndSteepOnesAreNot) {
    const auto field = [](float height, MeshEdges edges) {
        return heightField(
            6, 30, [height](float x, float z) { return height * std::sin(x) * std::cos(z); },
            edges);
    };
    EXPECT_EQ(field(0.05f, MeshEdges::sharp)->facetCount, 1);
    const int some = field(0.5f, MeshEdges::sharp)->facetCount;
    EXPECT_GT(some, 3);    // no fold within a facet
    EXPECT_LT(some, 100);  // of 1800 triangles
    EXPECT_GT(field(0.5f, MeshEdges::all)->facetCount, 900);
    EXPECT_EQ(field(5.0f, MeshEdges::none)->crisp[7], (std::array{false, false, false}));
}

TEST(SolidMesh, VerticesAtOnePlaceAreOne) {
    const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0},  {0, 0, -1},
                                    {1, 0, 0}, {1, 0, -1}, {0, 0, -1}};
    const auto mesh = makeMesh(corners, {{0, 1, 2}, {3, 4, 5}}, false);
    EXPECT_EQ(mesh->facetCount, 1);
    EXPECT_EQ(mesh->beyond[0][1], 1);
}

TEST(SolidMesh, RefusesWhatIsNoMesh) {
    const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
    const auto message = [](std::vector<Vec3> v, MeshTriangles t) {
        try {
            makeMesh(std::move(v), std::move(t), false);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(message(corners, {{0, 1, 2}}), "");
    EXPECT_NE(message(corners, {{0, 1, 4}}).find("vertex 4 of 4"), std::string::npos);
    EXPECT_NE(message(corners, {{0, -1, 2}}).find("vertex -1"), std::string::npos);
    EXPECT_NE(message(corners, {{0, 1, 3}}).find("area"), std::string::npos);
    EXPECT_NE(message(corners, {}).find("area"), std::string::npos);
    EXPECT_NE(message({{0, 0, 0}, {1, 0, std::nanf("")}, {0, 1, 0}}, {{0, 1, 2}}).find("finite"),
              std::string::npos);
}

// The volume inside the triangles; it would be negative if they were turned inside out.
TEST(FacetMesh, IsAsLargeAsTheSolidAndTurnedOutwards) {
    const auto volume = [](const std::vector<FacetVertex>& mesh) {
        double sum = 0.0;
        for (std::size_t i = 0; i < mesh.size(); i += 3)
            sum += static_cast<double>(
                mesh[i].position.dot(mesh[i + 1].position.cross(mesh[i + 2].position)));
        return sum / 6.0;
    };
    const double ring = 64 * std::sin(3.14159265 / 64) * std::cos(3.14159265 / 64);  // 64 corners
    EXPECT_NEAR(volume(cylinderMesh(64)), 2 * ring, 1e-4);
    EXPECT_NEAR(volume(coneMesh(64)), 2.0 / 3.0 * ring, 1e-3);
    EXPECT_NEAR(volume(facetMesh(*octahedron(1))), 4.0 / 3.0, 1e-5);
    EXPECT_NEAR(volume(facetMesh(*hexagonalNut(0.3f))), 0.6 * 1.5 * std::sqrt(3.0), 1e-5);
    EXPECT_NEAR(volume(facetMesh(*angleBar())), 2.0 * 0.6 + 1.4 * 0.6, 1e-5);
}

TEST(FacetMesh, KnowsHowFarItsEdgesAre) {
    // The apothem of a face of an octahedron of radius 1: edge sqrt(2), a third of its height.
    const float apothem = std::sqrt(1.5f) / 3.0f;
    for (const FacetVertex& v : facetMesh(*octahedron(1))) {
        EXPECT_NEAR(v.apothem, apothem, 1e-6f);
        const bool middle = v.toEdges.minCoeff() > 0.1f;
        EXPECT_NEAR(middle ? v.toEdges.maxCoeff() : v.toEdges.minCoeff(), middle ? apothem : 0.0f,
                    1e-6f);
        for (const Vec3& beyond : v.beyond) EXPECT_NEAR(beyond.dot(v.normal), 1.0f / 3.0f, 1e-5f);
    }
}

TEST(JoinedFaces, AreThoseThatHideNothing) {
    const auto faces = [](std::shared_ptr<const SolidMesh> mesh, const Vec3& eye) {
        const Solid solid = solidOf(std::move(mesh), {0, 0, 0}, {});
        const FaceTables tables = joinedFaces({surfaceOf(solid)}, eye);
        return static_cast<int>(std::set<int>(tables[0].begin(), tables[0].end()).size());
    };
    const auto field = hills(12, 80);
    const int high = faces(field, {0, 50, 0}), low = faces(field, {0, 1, 8});
    EXPECT_LT(high, low);
    EXPECT_LT(2 * high, field->facetCount);  // all are one, except for those at the border
    EXPECT_EQ(faces(angleBar(), {3, 4, 5}), 5 + 1);  // the faces that face away are one
    const Solid hull = solidOf(octahedron(1), {0, 0, 0}, {});
    EXPECT_TRUE(joinedFaces({surfaceOf(hull)}, {0, 0, 9}).empty());
}

TEST(PixelRect, HoldsASolidWithItsTip) {
    Frame frame;
    frame.camera = {{0, 0, 20}, {0, 0, 0}, {0, 1, 0}, 30};
    frame.solids = {solidOf(SolidShape::cone, {0.5f, 1, 0.5f}, {0, 0, 0}, {})};
    const View view = makeView(frame.camera, 1.0f);
    const std::vector<PixelRect> rects = bodyRects(frame, view, 200, 200);
    ASSERT_EQ(rects.size(), 1u);
    EXPECT_LE(rects[0].y0, static_cast<int>(project(view, {0, 1.5f, 0}, 200, 200).y));
    Solid none;
    none.shape = SolidShape::mesh;
    EXPECT_EQ(holdingHalfSize(none), Vec3(0, 0, 0));
}

Frame flatSolids() {
    Frame frame = everySolid();
    frame.look.shadows = frame.look.ambientOcclusion = frame.look.edges = false;
    frame.grounds.clear();  // its lines have the same width in a larger picture
    return frame;
}

TEST(SolidEdges, AreAsGoodAsAMuchLargerPicture) {
    const Frame frame = flatSolids();
    const Image exact = shrunk(Renderer(plainSettings(8 * 160, 8 * 90, 1)).draw(frame));
    std::vector<double> off;
    for (const int samples : {1, 2, 4, 8, 16})
        off.push_back(apart(Renderer(plainSettings(160, 90, samples)).draw(frame), exact));
    for (std::size_t i = 1; i < off.size(); ++i) EXPECT_LT(off[i], off[i - 1]) << i;
    EXPECT_LT(off.back(), 0.4 * off.front());
    EXPECT_LT(off[3], 1.5);  // levels
}

// A ridge in front of another slope of the same mesh is an edge like any other.
TEST(SolidEdges, ARidgeOfAHeightFieldIsSmoothToo) {
    Frame frame;
    frame.camera = {{0, 1.6f, 6}, {0, 0, 0}, {0, 1, 0}, 30};
    frame.look.shadows = frame.look.ambientOcclusion = frame.look.edges = false;
    const auto waves = heightField(
        6, 60, [](float x, float z) { return 0.5f * std::cos(2.5f * (z + 0.2f * x)); });
    frame.solids = {solidOf(waves, {0, 0, 0}, fromHex(0x808890))};
    const Image exact = shrunk(Renderer(plainSettings(8 * 160, 8 * 90, 1)).draw(frame));
    const double one = apart(Renderer(plainSettings(160, 90, 1)).draw(frame), exact);
    EXPECT_LT(apart(Renderer(plainSettings(160, 90, 8)).draw(frame), exact), 0.5 * one);
}

TEST(SolidPicture, EverySurfaceIsNumberedAsItIsDrawn) {
    const Frame frame = everySolid();
    const SurfaceMap map = Renderer(plainSettings(160, 90, 1)).surfaces(frame);
    std::vector<std::set<int>> faces(frame.solids.size());
    for (const std::int32_t packed : map.packed) {
        const int surface = surfaceIn(packed);
        if (surface >= 0 && surface < static_cast<int>(faces.size()))
            faces[surface].insert(faceIn(packed));
    }
    EXPECT_GT(faces[0].size(), 3u);                     // hills
    EXPECT_EQ(faces[1], (std::set{0, 3}));              // cylinder: side and top
    EXPECT_EQ(faces[2], (std::set{0}));                 // cone: its side
    EXPECT_GE(faces[3].size(), 3u);                     // octahedron
    EXPECT_LE(faces[3].size(), 4u);
    EXPECT_GE(faces[5].size(), 3u);                     // angle bar
    EXPECT_EQ(faces[7], (std::set{0}));                 // ball
}

TEST(SolidPicture, AMeshThatIsGoneOrIsNotThereDoesNoHarm) {
    Frame frame = everySolid();
    Renderer renderer(plainSettings(160, 90, 8));
    const Image first = renderer.draw(frame);
    Frame without = frame;
    without.solids[4].mesh = nullptr;
    const Image image = renderer.draw(without);
    EXPECT_NE(image.pixels, first.pixels);
    without.solids.erase(without.solids.begin() + 4);
    EXPECT_EQ(renderer.draw(without).pixels, image.pixels);
    EXPECT_EQ(renderer.draw(frame).pixels, first.pixels);
}

TEST(SolidPicture, DraftsAndFilmsShowThemToo) {
    const Frame frame = everySolid();
    Frame bare = frame;
    bare.solids.resize(1);
    RendererSettings draft = plainSettings(160, 90, 1);
    draft.finish = Finish::draft;
    Renderer one(draft), film(plainSettings(160, 90, 1));
    EXPECT_GT(apart(one.draw(frame), one.draw(bare)), 10.0);
    const std::vector<Frame> moments(4, frame), others(4, bare);
    EXPECT_GT(apart(film.draw(moments), film.draw(others)), 10.0);
}

}  // namespace
}  // namespace render
