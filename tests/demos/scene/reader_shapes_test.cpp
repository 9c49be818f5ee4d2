// Every shape in a scene file, and the positions of its points.

#include <gtest/gtest.h>

#include "demos/play/stage.h"
#include "engine/shapes/hull.h"
#include "engine/shapes/mass.h"
#include "engine/shapes/mesh.h"
#include "tests/demos/reading.h"

namespace demos::test {
namespace {

using engine::Shape;
using engine::ShapeType;

std::string body(const std::string& shape, const std::string& more = "") {
    return "[[body]]\nname = 'b'\nshape = { " + shape + " }\n" + more;
}

BodyDescription read1(const std::string& shape, const std::string& more = "") {
    return read(body(shape, more)).bodies.at(0);
}

/// A box of 1 x 2 x 3 m whose corner is at (1, 0, 0).
const std::string kCorners =
    "hull = [[1, 0, 0], [2, 0, 0], [1, 2, 0], [2, 2, 0], [1, 0, 3], [2, 0, 3], [1, 2, 3], "
    "[2, 2, 3], [1.5, 1, 1]]";
const Vec3 kMiddle(1.5, 1, 1.5);

const std::string kSquare =
    "mesh = { points = [[0, 0, 0], [0, 0, 2], [2, 0, 0], [2, 0, 2]], "
    "triangles = [[0, 1, 2], [2, 1, 3]] }";

TEST(ReaderShapes, ReadRoundOnes) {
    const Shape cylinder = read1("cylinder = { radius = 0.2, height = 0.6 }").def.shape;
    EXPECT_EQ(cylinder.type, ShapeType::cylinder);
    EXPECT_EQ(cylinder.radius, 0.2);
    EXPECT_EQ(cylinder.halfLength, 0.3);
    const Shape cone = read1("cone = { radius = 0.2, height = 0.1 }").def.shape;
    EXPECT_EQ(cone.type, ShapeType::cone);
    EXPECT_EQ(cone.halfLength, 0.05);
}

TEST(ReaderShapes, AHullLiesWhereItsPointsAreWritten) {
    const BodyDescription hull = read1(kCorners, "at = [10, 20, 30]\nturn_deg = [0, 0, 90]\n");
    ASSERT_EQ(hull.def.shape.type, ShapeType::hull);
    EXPECT_EQ(hull.def.shape.hull->corners.size(), 8u);
    EXPECT_NEAR((hull.def.shape.origin + kMiddle).norm(), 0.0, 1e-14);
    // x goes to y: the middle is at (10, 20, 30) + (-1, 1.5, 1.5).
    EXPECT_NEAR((hull.def.pose.position - Vec3(9, 21.5, 31.5)).norm(), 0.0, 1e-13);
    EXPECT_NEAR(engine::volume(hull.def.shape), 6.0, 1e-13);
}

TEST(ReaderShapes, PointsAreScaledAndTurned) {
    const Shape hull = read1(kCorners + ", scale = [2, 1, 1], turn_deg = [0, 90, 0]").def.shape;
    // (3, 1, 1.5) about y: x goes to -z, z to x.
    EXPECT_NEAR((hull.origin + Vec3(1.5, 1, -3)).norm(), 0.0, 1e-13);
    EXPECT_NEAR(engine::volume(hull), 12.0, 1e-12);
    EXPECT_NEAR(engine::volume(read1(kCorners + ", scale = 0.5").def.shape), 0.75, 1e-13);
}

TEST(ReaderShapes, AnchorsCountFromTheOriginOfThePoints) {
    const SceneDescription scene =
        read(body(kCorners, "at = [0, 5, 0]\n") +
             "[[joint]]\ntype = 'ball'\na = 'world'\nb = 'b'\nanchor_a = [1, 5, 0]\n"
             "anchor_b = [1, 0, 0]\n[[joint]]\ntype = 'ball'\na = 'world'\nb = 'b'\n"
             "anchor = [1, 5, 0]\n"
             "[[force]]\ntype = 'spring'\na = 'b'\nb = 'world'\nanchor_a = [1, 0, 0]\n"
             "anchor_b = [1, 7, 0]\nstiffness = 1\n");
    const Vec3 corner = Vec3(1, 0, 0) - kMiddle;
    EXPECT_NEAR((scene.joints[0].def.anchorB - corner).norm(), 0.0, 1e-14);
    EXPECT_NEAR((scene.joints[1].def.anchorB - corner).norm(), 0.0, 1e-14);
    const auto& spring = std::get<engine::SpringForce>(scene.forces[0].def.kind);
    EXPECT_NEAR((spring.anchorA - corner).norm(), 0.0, 1e-14);
    EXPECT_NEAR(spring.length, 2.0, 1e-14);
}

TEST(ReaderShapes, APathLeadsTheOriginOfThePoints) {
    const std::string orbit =
        "kinematic = { orbit = { centre = [0, 0, 0], axis = [0, 0, 1], deg_per_s = 90 } }\n";
    Stage stage(read(body(kCorners, "at = [4, 0, 0]\n" + orbit)));
    for (int i = 0; i < 60; ++i) ASSERT_TRUE(stage.step());
    const engine::Pose& pose = stage.world.pose(stage.bodies[0]);
    const Vec3 origin = pose.toWorld(stage.scene.bodies[0].def.shape.origin);
    EXPECT_NEAR((origin - Vec3(0, 4, 0)).norm(), 0.0, 1e-6);  // rotations are accurate to 1e-7 rad
}

TEST(ReaderShapes, ACompoundWeighsItsPartsByTheirDensities) {
    // A light rod along x, its end at 0, and a heavy ball at its far end.
    const BodyDescription hammer = read1(
        "compound = [{ shape = { box = [2, 0.1, 0.1] }, at = [1, 0, 0] }, "
        "{ shape = { sphere = 0.2 }, at = [2, 0, 0], density = 5000 }]",
        "density = 500\nat = [0, 1, 0]\n");
    const Shape& shape = hammer.def.shape;
    ASSERT_EQ(shape.type, ShapeType::compound);
    const double rod = 500 * 2 * 0.01, ball = 5000 * 4.0 / 3.0 * std::acos(-1.0) * 0.008;
    EXPECT_NEAR(engine::massOf(shape, 500), rod + ball, 1e-10);
    const double centre = (rod * 1.0 + ball * 2.0) / (rod + ball);
    EXPECT_NEAR(shape.origin.x(), -centre, 1e-13);
    EXPECT_NEAR((hammer.def.pose.position - Vec3(centre, 1, 0)).norm(), 0.0, 1e-13);
}

TEST(ReaderShapes, PartsOfACompoundLieByTheirOwnOrigins) {
    const Shape shape = read1("compound = [{ shape = { " + kCorners +
                              " }, at = [1, 0, 0] }, "
                              "{ shape = { compound = [{ shape = { sphere = 0.5 }, "
                              "at = [0, 0, 1] }] }, turn_deg = [0, 90, 0] }]")
                            .def.shape;
    const engine::ShapeParts& parts = *shape.parts;
    ASSERT_EQ(parts.size(), 2u);
    const auto written = [&](std::size_t i) { return Vec3(parts[i].pose.position - shape.origin); };
    EXPECT_NEAR((written(0) - Vec3(kMiddle + Vec3(1, 0, 0))).norm(), 0.0, 1e-13);
    EXPECT_NEAR((written(1) - Vec3(1, 0, 0)).norm(), 0.0, 1e-13);  // z turned about y is x
}

TEST(ReaderShapes, MeshesAndHeightFieldsHoldABall) {
    for (const std::string& ground :
         {kSquare, std::string("height_field = { columns = 3, rows = 2, spacing = 2, "
                               "heights = [0, 0, 0, 0, 0, 0] }")}) {
        Stage stage(
            read("[[body]]\nname = 'ball'\nshape = { sphere = 0.2 }\nat = [0.5, 0.3, 0.5]\n" +
                 body(ground, "fixed = true\n")));
        EXPECT_EQ(stage.scene.bodies[1].def.shape.type, ShapeType::mesh);
        EXPECT_FALSE(stage.drawn[1].empty());
        for (int i = 0; i < 60; ++i) ASSERT_TRUE(stage.step());
        EXPECT_NEAR(stage.world.pose(stage.bodies[0]).position.y(), 0.2, 2e-3) << ground;
    }
    const Shape field =
        read1("height_field = { columns = 3, rows = 2, spacing = 2, heights = [0, 1, 2, 3, 4, 5] }",
              "fixed = true\n")
            .def.shape;
    EXPECT_EQ(field.mesh->corners[5], Vec3(2, 5, 1));
    EXPECT_EQ(field.mesh->triangles.size(), 4u);
}

TEST(ReaderShapes, AllButPlanesAreDrawnByTheirParts) {
    const std::pair<std::string, std::size_t> shapes[] = {
        {"sphere = 1", 1},
        {"box = [1, 1, 1]", 1},
        {"capsule = { radius = 0.1, height = 1 }", 1},
        {"cylinder = { radius = 0.1, height = 1 }", 1},
        {"cone = { radius = 0.1, height = 1 }", 1},
        {"plane = [0, 1, 0]", 0},  // the ground is drawn separately
        {kCorners, 1},
        {kSquare, 1},
        {"compound = [{ shape = { sphere = 1 } }, { shape = { " + kCorners + " } }]", 2},
    };
    for (const auto& [shape, parts] : shapes)
        EXPECT_EQ(Stage(read(body(shape, "fixed = true\n"))).drawn.at(0).size(), parts) << shape;
}

struct BadShape {
    std::string shape, more;
    const char* message;
};

TEST(ReaderShapes, ComplainOfWhatIsWrong) {
    const std::string fixed = "fixed = true\n";
    const BadShape bad[] = {
        {"cone = { radius = 1 }", "", "a cone has no height; write cone = { radius = 0.1"},
        {"cylinder = { radius = 0, height = 1 }", "", "radius is 0; it should be a number"},
        {"box = [1, 1, 1], scale = 2", "", "scale is given for a box; leave it out"},
        {"sphere = 1, turn_deg = [0, 0, 1]", "", "turn_deg is given for a sphere"},
        {"spere = 1", "", "unknown key 'spere' in a shape; did you mean 'sphere'?"},
        {"", "",
         "an empty shape; give one of sphere, box, capsule, cylinder, cone, plane, hull, "
         "mesh, height_field or compound"},
        {"hull = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]", "", "hull is flat, 3 points"},
        {"hull = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]", "",
         "hull is flat, 4 points; it should be four or more that are not in one plane"},
        {"hull = [[0, 0, 0], [1, 0], [0, 1, 0], [1, 1, 0]]", "", "three numbers [x, y, z]"},
        {"hull = 3", "", "hull is 3; it should be a list of points"},
        {kCorners + ", scale = 1e-4", "", "m across; it should be from 0.001 to 1000 m"},
        {kCorners + ", scale = 0", "", "scale is 0; it should be a number from"},
        {kCorners + ", scale = 1e6", "", "all should be within 100000 m: give a scale"},
        {kSquare, "", "a mesh or height_field cannot be dynamic; write fixed = true or kinematic"},
        {"mesh = { points = [[0, 0, 0]] }", fixed, "a mesh has no triangles; write mesh = {"},
        {"mesh = { points = [[0, 0, 0]], triangles = [] }", fixed, "mesh has no triangles"},
        {"mesh = { points = [[0, 0, 0]], triangles = [[0, 0, 0]] }", fixed,
         "no triangle of mesh has an area"},
        {"mesh = { points = [[0, 0, 0]], triangles = [[0, 1, 0]] }", fixed,
         "triangle 0 should be three whole numbers below 1, the number of points"},
        {"mesh = { points = [[0, 0, 0]], triangles = [[0, 0.5, 0]] }", fixed,
         "triangle 0 should be three whole numbers"},
        {"height_field = { columns = 1, rows = 2, spacing = 1, heights = [] }", fixed,
         "columns is 1; it should be a whole number from 2 to 2000"},
        {"height_field = { columns = 2, rows = 2, spacing = 1, heights = [0] }", fixed,
         "the number of heights is 1; it should be 4, columns times rows"},
        {"height_field = { columns = 2, rows = 2, heights = [0] }", fixed,
         "a height_field has no spacing"},
        {"compound = []", "", "compound has 0 parts; it should have 1 to 1000"},
        {"compound = 3", "", "compound is 3; it should be one or more tables"},
        {"compound = [{ at = [0, 0, 0] }]", "", "a part has no shape"},
        {"compound = [{ shape = { plane = [0, 1, 0] } }]", "", "a part that is a plane"},
        {"compound = [{ shape = { " + kSquare + " } }]", "", "a part that is a mesh"},
        {"compound = [{ shape = { sphere = 1 }, density = 0 }]", "", "density is 0"},
        {"compound = [{ shape = { sphere = 1 }, mass = 1 }]", "", "unknown key 'mass' in a part"},
        {kCorners, "density = 0.001\nat = [1e5, 0, 0]\n", "its centre of mass would be"},
        {"compound = [{ shape = { sphere = 0.001 }, at = [-9e4, -9e4, 0] }, "
         "{ shape = { sphere = 0.001 }, at = [9e4, 9e4, 0] }]",
         "mass = 1\n", "its inertia is not positive definite"},
        {"hull = 'rock.obj'", "", "'rock.obj' cannot be read, because the scene itself is not in"},
    };
    for (const BadShape& b : bad) {
        const auto lines = errorsOf("format = 1\n" + body(b.shape, b.more));
        EXPECT_TRUE(tells(lines, "a.toml:", b.message)) << b.shape << "\n" << listed(lines);
    }
}

/// 257 points on a sphere are all corners.
TEST(ReaderShapes, ComplainOfAHullWithTooManyCorners) {
    std::string points;
    for (int i = 0; i < 257; ++i) {
        const double y = -1.0 + 2.0 * (i + 0.5) / 257.0, r = std::sqrt(1.0 - y * y), a = 2.4 * i;
        points += (i ? ", [" : "[") + numberText(r * std::cos(a)) + ", " + numberText(y) + ", " +
                  numberText(r * std::sin(a)) + "]";
    }
    const auto lines = errorsOf("format = 1\n" + body("hull = [" + points + "]"));
    EXPECT_TRUE(tells(lines, "a.toml:4:", "hull has more than 256 corners")) << listed(lines);
}

}  // namespace
}  // namespace demos::test
