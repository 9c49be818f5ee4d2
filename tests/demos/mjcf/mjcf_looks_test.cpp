// How MuJoCo's models are drawn: as in its viewer, meshes as their triangles.
#include <gtest/gtest.h>

#include "engine/shapes/mesh.h"
#include "tests/demos/mjcf/mjcf_reading.h"

namespace demos::test {
namespace {

using engine::ShapeType;

const std::string kAsset =
    "<asset><mesh name='wedge' vertex='0 0 0 1 0 0 0 1 0 0 0 1' "
    "face='0 2 1 0 1 3 0 3 2 1 2 3'/></asset>";

TEST(MujocoLooks, AMeshIsDrawnAsItsTrianglesWhereItIs) {
    const SceneDescription scene = readMujoco(
        kAsset + "<worldbody><body pos='0 0 5'><freejoint/><geom type='mesh' mesh='wedge' "
                 "pos='1 0 0'/></body></worldbody>");
    const BodyDescription& body = scene.bodies.at(0);
    EXPECT_EQ(body.def.shape.type, ShapeType::hull);
    ASSERT_TRUE(body.looks);
    ASSERT_EQ(body.looks->size(), 1u);
    const engine::ShapePart& part = body.looks->front();
    ASSERT_EQ(part.shape.type, ShapeType::mesh);
    EXPECT_EQ(part.shape.mesh->triangles.size(), 4u);
    // Its corners have the model's positions: (1, 0, 5) is (1, 5, 0) here.
    const Vec3 corner = part.pose.toWorld(part.shape.mesh->corners.front());
    expectNear(body.def.pose.toWorld(corner), {1, 5, 0}, 1e-12);
    EXPECT_EQ(Stage(scene).drawn.at(0).size(), 1u);
}

TEST(MujocoLooks, HiddenHullsAreMetAndVisualOnesDrawn) {
    const SceneDescription scene = readMujoco(
        kAsset + "<worldbody><body><freejoint/>"
                 "<geom type='mesh' mesh='wedge' contype='0' conaffinity='0' group='2' rgba='1 0 0 1'/>"
                 "<geom type='sphere' size='0.3' contype='0' conaffinity='0' group='1'/>"
                 "<geom type='box' size='1 1 1' group='3' rgba='0 1 0 1'/></body></worldbody>");
    const BodyDescription& body = scene.bodies.at(0);
    ASSERT_EQ(body.def.shape.type, ShapeType::compound);  // all of them count for the mass
    ASSERT_EQ(body.def.shape.parts->size(), 1u);
    EXPECT_EQ(body.def.shape.parts->front().shape.type, ShapeType::box);
    ASSERT_TRUE(body.looks);
    ASSERT_EQ(body.looks->size(), 2u);
    EXPECT_EQ(body.looks->at(0).shape.type, ShapeType::mesh);
    EXPECT_EQ(body.looks->at(1).shape.type, ShapeType::sphere);
    EXPECT_EQ(body.color, 0xff0000u);
    EXPECT_TRUE(body.def.collide);
}

TEST(MujocoLooks, WhatHasNothingElseIsDrawnAsWhatIsMet) {
    const SceneDescription scene = readMujoco(
        "<worldbody><body><freejoint/><geom size='0.1' group='3'/></body>"
        "<body><geom name='hull' size='0.1' group='3'/><geom name='skin' size='0.1' group='2'/></body>"
        "<body><geom name='lone' size='0.1' group='4'/></body></worldbody>");
    const Stage stage(scene);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        EXPECT_EQ(stage.drawn[i].size(), scene.bodies[i].name == "hull" ? 0u : 1u)
            << scene.bodies[i].name;
}

}  // namespace
}  // namespace demos::test
