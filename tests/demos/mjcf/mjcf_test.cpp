// MuJoCo's models: positions, masses, and how bodies can move.
#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "engine/base/trigonometry.h"
#include "engine/shapes/mass.h"
#include "tests/demos/mjcf/mjcf_reading.h"

namespace demos::test {
namespace {

using engine::Mat3;
using engine::ShapeType;

const std::string kBob = "<geom type='sphere' size='0.01' mass='2'/>";

/// Two rotations are the same if they turn two directions alike.
void expectSameTurn(const Quat& a, const Quat& b, double within = 1e-12) {
    expectNear(a * Vec3(1, 2, 3), b * Vec3(1, 2, 3), within);
    expectNear(a * Vec3(-3, 1, 0), b * Vec3(-3, 1, 0), within);
}

const BodyDescription& bodyCalled(const SceneDescription& scene, const std::string& name) {
    for (const BodyDescription& body : scene.bodies)
        if (body.name == name) return body;
    ADD_FAILURE() << "no body " << name;
    return scene.bodies.front();
}

/// Of a box in `<body ...>`, in MuJoCo's axes.
Quat turnOf(const std::string& attributes, const std::string& compiler = "") {
    const SceneDescription scene =
        readMujoco("<compiler " + compiler + "/><worldbody><body " + attributes +
                   "><freejoint/><geom type='box' size='1 2 3'/></body></worldbody>");
    const Quat& q = scene.bodies[0].def.pose.rotation;
    return {q.w(), q.x(), -q.z(), q.y()};
}

TEST(MujocoAxes, AreTurnedUpright) {
    const SceneDescription scene = readMujoco(
        "<option gravity='1 2 -3'/><worldbody><body pos='1 2 3'><freejoint/>"
        "<geom type='box' size='0.1 0.2 0.3'/></body></worldbody>");
    expectNear(scene.bodies[0].def.pose.position, {1, 3, -2});
    expectNear(scene.bodies[0].def.shape.halfSize, {0.1, 0.3, 0.2});
    expectNear(scene.gravity, {1, -3, -2});
}

TEST(MujocoAxes, OrientationsAreReadInEveryForm) {
    const Quat quarter = engine::turnAbout(Vec3::UnitZ(), 0.5 * engine::kPi);
    expectSameTurn(turnOf("quat='1 0 0 1'"), quarter);
    expectSameTurn(turnOf("axisangle='0 0 2 90'"), quarter);
    expectSameTurn(turnOf("axisangle='0 0 1 0.5'", "angle='radian'"),
                   engine::turnAbout(Vec3::UnitZ(), 0.5));
    expectSameTurn(turnOf("xyaxes='0 1 0 -3 1 0'"), quarter);
    expectSameTurn(turnOf("euler='0 0 90'"), quarter);
    expectNear(turnOf("zaxis='3 0 3'") * Vec3::UnitZ(), Vec3(1, 0, 1).normalized());
    expectNear(turnOf("zaxis='0 0 -1'") * Vec3::UnitZ(), {0, 0, -1});
}

TEST(MujocoAxes, SmallLettersOfEulerTurnAboutMovingAxesAndLargeAboutFixedOnes) {
    const auto about = [](const Vec3& axis, double degrees) {
        return engine::turnAbout(axis, engine::radians(degrees));
    };
    const Quat x = about(Vec3::UnitX(), 20), y = about(Vec3::UnitY(), 30), z = about(Vec3::UnitZ(), 40);
    expectSameTurn(turnOf("euler='20 30 40'"), x * y * z);
    expectSameTurn(turnOf("euler='20 30 40'", "eulerseq='XYZ'"), z * y * x);
    expectSameTurn(turnOf("euler='40 20 30'", "eulerseq='zxy'"), z * x * y);
}

TEST(MujocoGeoms, FromtoPutsTheEndsOfACapsule) {
    const SceneDescription scene = readWorldBody(
        "<body name='rod' pos='0 0 1'><freejoint/>"
        "<geom type='capsule' size='0.1' fromto='1 0 0 1 2 1'/></body>");
    const engine::BodyDef& def = scene.bodies[0].def;
    ASSERT_EQ(def.shape.type, ShapeType::capsule);
    EXPECT_DOUBLE_EQ(def.shape.radius, 0.1);
    EXPECT_DOUBLE_EQ(def.shape.halfLength, 0.5 * std::sqrt(5.0));
    // MuJoCo's (1, 0, 1) and (1, 2, 2)
    expectNear(def.pose.toWorld({0, -def.shape.halfLength, 0}), {1, 1, 0});
    expectNear(def.pose.toWorld({0, def.shape.halfLength, 0}), {1, 2, -2});
}

TEST(MujocoGeoms, SizesAreHalfLengthsAndFromtoSetsTheLast) {
    const SceneDescription scene = readWorldBody(
        "<geom name='c' type='cylinder' size='0.3 0.5'/>"
        "<geom name='k' type='capsule' size='0.3 0.5'/>"
        "<geom name='b' type='box' size='0.3' fromto='0 0 0 4 0 0'/>"
        "<geom name='p' type='plane' size='0 0 1' zaxis='1 0 0'/>");
    EXPECT_EQ(bodyCalled(scene, "c").def.shape.halfLength, 0.5);
    EXPECT_EQ(bodyCalled(scene, "k").def.shape.halfLength, 0.5);
    expectNear(bodyCalled(scene, "b").def.shape.halfSize, {0.3, 2.0, 0.3});
    const engine::BodyDef& plane = bodyCalled(scene, "p").def;
    EXPECT_EQ(plane.kind, engine::BodyKind::fixed);
    expectNear(plane.pose.rotation * plane.shape.normal, {1, 0, 0});
}

TEST(MujocoGeoms, AnEllipsoidHasItsVolumeAndMass) {
    const SceneDescription scene = readWorldBody(
        "<body><freejoint/><geom type='ellipsoid' size='0.1 0.2 0.3'/></body>");
    const double exact = 4.0 / 3.0 * engine::kPi * 0.1 * 0.2 * 0.3;
    EXPECT_NEAR(engine::volume(scene.bodies[0].def.shape), exact, 1e-9 * exact);
    EXPECT_NEAR(*scene.bodies[0].def.mass, 1000.0 * exact, 1e-6 * exact);
    const Vec3 axes = engine::inertiaOf(scene.bodies[0].def.shape, 5.0).diagonal();  // y is MuJoCo's z
    EXPECT_NEAR(axes.y(), 0.1 * 0.1 + 0.2 * 0.2, 0.02 * axes.y());  // m/5 (a^2 + b^2), 120 corners
}

TEST(MujocoMass, DensityMassAndWeldedBodiesAddUp) {
    const SceneDescription scene = readWorldBody(
        "<body name='arm' pos='0 0 5'><freejoint/>"
        "<geom type='box' size='0.5 0.5 0.5' density='2'/>"
        "<body pos='3 0 0'><geom type='sphere' size='0.1' mass='4'/></body></body>");
    ASSERT_EQ(scene.bodies.size(), 1u);
    ASSERT_TRUE(scene.joints.empty());
    const engine::BodyDef& def = scene.bodies[0].def;
    EXPECT_DOUBLE_EQ(*def.mass, 6.0);
    expectNear(def.pose.position, {2, 5, 0});  // (2 * 0 + 4 * 3) / 6
    ASSERT_EQ(def.shape.parts->size(), 2u);
    expectNear((*def.shape.parts)[0].pose.position, {-2, 0, 0});
    // m (a^2 + b^2) / 12 and 2/5 m r^2, by Steiner's rule about the common centre
    EXPECT_NEAR((*def.inertia)(0, 0), 2.0 / 6.0 + 0.4 * 4 * 0.01, 1e-12);
    EXPECT_NEAR((*def.inertia)(1, 1), 2.0 / 6.0 + 2 * 4.0 + 0.4 * 4 * 0.01 + 4 * 1.0, 1e-12);
}

TEST(MujocoMass, InertialCountsUnlessGeomsAreAskedFor) {
    const std::string body =
        "<worldbody><body><freejoint/><inertial pos='0 0 0.5' mass='3' diaginertia='2 3 4'/>"
        "<geom type='sphere' size='0.1' mass='7'/></body></worldbody>";
    const engine::BodyDef own = readMujoco(body).bodies[0].def;
    EXPECT_EQ(*own.mass, 3.0);
    expectNear(own.pose.position, {0, 0.5, 0});
    expectNear((*own.inertia).diagonal(), {2, 4, 3});
    const engine::BodyDef geoms =
        readMujoco("<compiler inertiafromgeom='true'/>" + body).bodies[0].def;
    EXPECT_EQ(*geoms.mass, 7.0);
}

TEST(MujocoMass, FullInertiaIsTurnedWithTheAxes) {
    const engine::BodyDef def = readWorldBody(
        "<body><freejoint/><inertial pos='0 0 0' mass='3' fullinertia='3 4 5 0.1 0.2 0.3'/></body>")
        .bodies[0].def;
    Mat3 expected;  // of x, z, -y
    expected << 3, 0.2, -0.1, 0.2, 5, -0.3, -0.1, -0.3, 4;
    EXPECT_LE((*def.inertia - expected).norm(), 1e-12);
    EXPECT_FALSE(def.collide);
}

TEST(MujocoDefaults, AreInheritedByClassAndChildclass) {
    const SceneDescription scene = readMujoco(
        "<default><geom type='box' size='1 1 1' friction='0.3'/>"
        "<default class='small'><geom size='0.1 0.1 0.1'/>"
        "<default class='slick'><geom friction='0.1 0.005'/></default></default></default>"
        "<worldbody><geom name='outer'/>"
        "<body childclass='small'><geom name='inner'/><geom name='own' class='slick'/>"
        "<body><geom name='deep' type='sphere'/></body>"
        "<body childclass='slick'><geom name='deeper'/></body></body></worldbody>");
    EXPECT_EQ(bodyCalled(scene, "outer").def.shape.halfSize.x(), 1.0);
    EXPECT_EQ(bodyCalled(scene, "inner").def.shape.halfSize.x(), 0.1);
    EXPECT_EQ(bodyCalled(scene, "inner").def.material.friction, 0.3);
    EXPECT_EQ(bodyCalled(scene, "own").def.material.friction, 0.1);
    EXPECT_EQ(bodyCalled(scene, "deep").def.shape.radius, 0.1);
    EXPECT_EQ(bodyCalled(scene, "deeper").def.shape.halfSize.x(), 0.1);
    EXPECT_EQ(bodyCalled(scene, "deeper").def.material.friction, 0.1);
}

TEST(MujocoDefaults, OwnOrientationAndPlaceBeatThoseOfTheClass) {
    const SceneDescription scene = readMujoco(
        "<default><geom type='capsule' size='0.1 0.2' euler='90 0 0' pos='9 9 9'/></default>"
        "<worldbody><geom name='a' quat='1 0 0 0'/><geom name='b' fromto='0 0 0 0 0 1'/></worldbody>");
    expectSameTurn(bodyCalled(scene, "a").def.pose.rotation, Quat::Identity());
    expectNear(bodyCalled(scene, "b").def.pose.position, {0, 0.5, 0});
}

TEST(MujocoAssets, ColoursComeFromMaterialsAndGeoms) {
    const SceneDescription scene = readMujoco(
        "<asset><material name='m' rgba='1 0 0.2 1'/></asset><worldbody>"
        "<geom name='a' size='1' material='m'/><geom name='b' size='1' material='m' rgba='0 1 0 1'/>"
        "<geom name='c' size='1'/></worldbody>");
    EXPECT_EQ(bodyCalled(scene, "a").color, 0xff0033u);
    EXPECT_EQ(bodyCalled(scene, "b").color, 0x00ff00u);
    EXPECT_FALSE(bodyCalled(scene, "c").color);
}

std::string stlOf(const std::vector<std::array<float, 9>>& triangles) {
    std::string bytes(80, ' ');
    const auto put = [&](const auto& value) {
        char raw[sizeof value];
        std::memcpy(raw, &value, sizeof value);
        bytes.append(raw, sizeof value);
    };
    put(static_cast<std::uint32_t>(triangles.size()));
    for (const std::array<float, 9>& t : triangles) {
        put(std::array<float, 3>{});
        put(t);
        put(std::uint16_t{0});
    }
    return bytes;
}

TEST(MujocoAssets, MeshesAreHullsFromTextObjAndStl) {
    const std::string corners = "0 0 0 3 0 0 0 3 0 0 0 3";
    const SceneDescription scene = readMujoco(
        "<compiler meshdir='parts'/><asset><mesh name='text' vertex='" + corners + "'/>"
        "<mesh file='t.obj' scale='2 2 2'/><mesh name='stl' file='t.stl'/></asset>"
        "<worldbody><body name='t'><freejoint/><geom type='mesh' mesh='text'/></body>"
        "<body name='o' pos='9 0 0'><freejoint/><geom type='mesh' mesh='t'/></body>"
        "<body name='s'><freejoint/><geom type='mesh' mesh='stl'/></body></worldbody>",
        {{"parts/t.obj", "# a corner\nv 0 0 0\nv 3 0 0 1\r\nv 0 3 0\nv 0 0 3\nf 1 2 3\n"},
         {"parts/t.stl", stlOf({{0, 0, 0, 3, 0, 0, 0, 3, 0}, {0, 0, 0, 3, 0, 0, 0, 0, 3}})}});
    for (const char* name : {"t", "s"}) {
        EXPECT_NEAR(engine::volume(bodyCalled(scene, name).def.shape), 4.5, 1e-9);
        expectNear(bodyCalled(scene, name).def.pose.position, {0.75, 0.75, -0.75}, 1e-9);
    }
    EXPECT_NEAR(engine::volume(bodyCalled(scene, "o").def.shape), 36.0, 1e-9);
    expectNear(bodyCalled(scene, "o").def.pose.position, {10.5, 1.5, -1.5}, 1e-9);
    EXPECT_EQ(scene.files, (std::vector<std::string>{"parts/t.obj", "parts/t.stl"}));
    EXPECT_TRUE(tells(scene.notes, "a.xml:2:", "a mesh collides and weighs as its convex hull (3 places)"))
        << listed(scene.notes);
}

TEST(MujocoFiles, IncludesAreReadInPlace) {
    const SceneDescription scene = readMujoco(
        "<include file='sub/bodies.xml'/>\n",
        {{"sub/bodies.xml", "<mujocoinclude>\n<worldbody>\n<geom name='g' size='1'/>\n"
                            "<light/>\n</worldbody></mujocoinclude>"}});
    EXPECT_EQ(scene.bodies.at(0).name, "g");
    EXPECT_TRUE(tells(scene.notes, "sub/bodies.xml:4:1: ", "<light>")) << listed(scene.notes);
}

TEST(MujocoFiles, EntitiesOfADocumentAreNotKnown) {
    const std::string bomb =
        "<!DOCTYPE x [<!ENTITY a 'aaaa'><!ENTITY b '&a;&a;&a;&a;'>]>\n<mujoco model='&b;'>"
        "<worldbody><geom size='1'/></worldbody></mujoco>";
    EXPECT_EQ(readModelText(bomb).title, "&b;");
}

TEST(MujocoNames, AreMadeUsableAndUnique) {
    const SceneDescription scene = readWorldBody(
        "<geom size='1'/><geom size='1'/><geom name='sphere-2' size='1'/><geom name='world' size='1'/>"
        "<body name='two crates'><freejoint/>" + kBob + "</body>");
    std::vector<std::string> names;
    for (const BodyDescription& body : scene.bodies) names.push_back(body.name);
    EXPECT_EQ(names, (std::vector<std::string>{"sphere", "sphere-2", "sphere-2-2", "world-2",
                                               "two_crates"}));
}

TEST(MujocoOptions, StepsAreAMultipleOfSixty) {
    const auto hzOf = [](const std::string& timestep) {
        return readMujoco("<option timestep='" + timestep + "'/><worldbody><geom size='1'/></worldbody>")
            .hz;
    };
    EXPECT_EQ(hzOf("0.002"), 540);
    EXPECT_EQ(hzOf("0.005"), 240);
    EXPECT_EQ(hzOf("0.01"), 120);
    EXPECT_EQ(hzOf("0.5"), 60);
    EXPECT_EQ(readWorldBody("<geom size='1'/>").hz, 540);
}

TEST(MujocoOptions, SetIsTakenAfterTheModel) {
    const std::string text = "<mujoco model='arm'><worldbody><geom size='1'/></worldbody></mujoco>";
    const SceneDescription scene = readModelText(
        text, {}, {"world.hz=120", "solver.sweeps=7", "seconds=2", "camera.fov_deg=50"});
    EXPECT_EQ(scene.title, "arm");
    EXPECT_EQ(scene.hz, 120);
    EXPECT_EQ(scene.settings.sweeps, 7);
    EXPECT_EQ(scene.seconds, 2.0);
    EXPECT_EQ(scene.camera.fovDegrees, 50.0);
    EXPECT_TRUE(tells(modelErrors(text, {}, {"world.hx=1"}), "--set world.hx=1: ",
                      "did you mean 'hz'?"));
}

TEST(MujocoOptions, TheCameraLooksAtTheModel) {
    const SceneDescription free = readWorldBody("<body pos='1 2 3'><freejoint/>" + kBob + "</body>");
    expectNear(free.camera.lookAt, {1, 3, -2});
    EXPECT_LT((free.camera.from - free.camera.lookAt).norm(), 0.1);
    const SceneDescription said = readMujoco(
        "<statistic center='0 0 1' extent='3'/><worldbody><geom size='1'/></worldbody>");
    expectNear(said.camera.lookAt, {0, 1, 0});
    EXPECT_GT((said.camera.from - said.camera.lookAt).norm(), 6.0);
}

TEST(MujocoMeetings, FollowContypeAffinityAndExclude) {
    const std::string ball = "<freejoint/><geom size='0.1' ";
    const SceneDescription scene = readMujoco(
        "<worldbody><geom name='floor' type='plane' size='1 1 1'/>"
        "<body name='a'>" + ball + "/></body><body name='b'>" + ball + "/></body>"
        "<body name='c'>" + ball + "contype='2' conaffinity='0'/></body>"
        "<body name='d'>" + ball + "contype='0' conaffinity='0'/></body>"
        "</worldbody><contact><exclude body1='a' body2='b'/></contact>");
    const auto meet = [&](const char* one, const char* other) {
        const engine::BodyDef &a = bodyCalled(scene, one).def, &b = bodyCalled(scene, other).def;
        return a.collide && b.collide && !(a.groups & b.ignores) && !(b.groups & a.ignores);
    };
    EXPECT_TRUE(meet("floor", "a"));
    EXPECT_TRUE(meet("floor", "b"));
    EXPECT_FALSE(meet("a", "b"));
    EXPECT_FALSE(meet("floor", "c"));
    EXPECT_FALSE(meet("a", "c"));
    EXPECT_FALSE(meet("floor", "d"));
    EXPECT_FALSE(readMujoco("<option><flag contact='disable'/></option><worldbody><geom size='1'/>"
                            "</worldbody>").bodies[0].def.collide);
}

TEST(Mujoco, CondimSaysWhichFrictionThereIs) {
    const auto materialOf = [](const std::string& attributes) {
        return readMujoco("<worldbody><geom size='1' " + attributes + "/></worldbody>")
            .bodies.front()
            .def.material;
    };
    EXPECT_EQ(materialOf("friction='0.3 0.1 0.02'").friction, 0.3);
    EXPECT_EQ(materialOf("friction='0.3 0.1 0.02'").rolling, 0.0);
    EXPECT_EQ(materialOf("friction='0.3 0.1 0.02' condim='6'").rolling, 0.02);
    EXPECT_EQ(materialOf("condim='6'").rolling, 1e-4);
    EXPECT_EQ(materialOf("friction='0.3'").frictionRule, engine::FrictionRule::larger);
    EXPECT_EQ(materialOf("friction='0.3' condim='1'").frictionRule, engine::FrictionRule::none);
    EXPECT_EQ(materialOf("friction='0.3' condim='1'").friction, 0.3);
    EXPECT_EQ(materialOf("priority='2'").priority, 2);
}

}  // namespace
}  // namespace demos::test
