// A run as binary glTF, read back from its bytes and compared with the engine.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "demos/export/glb_scene.h"
#include "demos/look/key_light.h"
#include "demos/text/version.h"
#include "tests/demos/export/glb_reading.h"
#include "tests/demos/recorded.h"

namespace demos::test {
namespace {

constexpr int kStepsPerFrame = 2;

const std::string kShapes = kFloor + R"(
[[body]]
name = "spinner"
shape = { box = [0.4, 0.6, 0.8] }
at = [0, 3, 0]
spin = [3, 5, 1]
colour = "#3579b1"
[[body]]
name = "ball"
shape = { sphere = 0.5 }
at = [4, 0.5, 0]
colour = "#3579b1"
[[body]]
name = "big"
shape = { sphere = 0.7 }
at = [6, 0.7, 0]
colour = "#3579b1"
[[body]]
name = "hammer"
shape = { compound = [
  { shape = { box = [0.2, 0.2, 1] } },
  { shape = { cylinder = { radius = 0.2, height = 0.6 } }, at = [0, 0, 0.5] } ] }
at = [-3, 2, 0]
[[body]]
name = "gate"
shape = { box = [1, 1, 1] }
at = [0, 9, 0]
fixed = true
sensor = true
[[body]]
name = "pill"
shape = { capsule = { radius = 0.2, height = 1.0 } }
at = [-6, 1, 0]
[[body]]
name = "cone"
shape = { cone = { radius = 0.4, height = 1.0 } }
at = [-8, 1, 0]
[[body]]
name = "rock"
shape = { hull = [[0,0,0], [1,0,0], [0,1,0], [0,0,1], [0.8, 0.8, 0.8]] }
at = [-10, 2, 0]
)";

/// One run of a scene and its file.
struct Exported : Recorded {
    Glb glb;

    explicit Exported(const std::string& text, int steps = 60)
        : Recorded(text, steps, kStepsPerFrame), glb(readGlb(glbOf(run))) {}
    std::size_t bodyCalled(const std::string& name) const {
        const auto& bodies = player.stage().scene.bodies;
        return static_cast<std::size_t>(
            std::find_if(bodies.begin(), bodies.end(),
                         [&](const BodyDescription& body) { return body.name == name; }) -
            bodies.begin());
    }
};

const Exported& exported() {
    static const Exported one(kShapes);
    return one;
}

TEST(Glb, SaysWhoMadeItAndWhatItHolds) {
    const nlohmann::json& json = exported().glb.json;
    EXPECT_EQ(json["asset"]["version"], "2.0");
    EXPECT_EQ(json["asset"]["generator"], std::string("impulse ") + kVersion);
    const nlohmann::json& roots = json["scenes"][0]["nodes"];
    EXPECT_EQ(roots.size(), 9u + 2u);  // bodies, camera, sun
    for (const BodyDescription& body : exported().player.stage().scene.bodies)
        EXPECT_GE(exported().glb.numberOf(body.name), 0) << body.name;
}

TEST(Glb, MaterialsHaveTheValuesOfTheirLook) {
    const Exported steel(kFloor + "[[body]]\nname = 'ball'\nshape = { sphere = 1 }\nat = [0, 1, 0]\n"
                                  "look = 'steel'\n[[body]]\nname = 'pane'\n"
                                  "shape = { box = [1, 1, 1] }\nat = [3, 1, 0]\nlook = 'glass'\n");
    const auto materialOf = [&steel](const std::string& name) {
        const nlohmann::json& node = steel.glb.json["nodes"][steel.glb.numberOf(name)];
        const nlohmann::json& mesh = steel.glb.json["meshes"][node["mesh"].get<int>()];
        return steel.glb.json["materials"][mesh["primitives"][0]["material"].get<int>()];
    };
    const nlohmann::json metal = materialOf("ball")["pbrMetallicRoughness"];
    EXPECT_EQ(metal["metallicFactor"], 1.0);
    EXPECT_NEAR(metal["roughnessFactor"].get<double>(), 0.3, 1e-6);
    EXPECT_EQ(materialOf("pane")["alphaMode"], "BLEND");
}

TEST(Glb, AccessorsTellTheirLeastAndLargest) {
    const Glb& glb = exported().glb;
    int told = 0;
    for (std::size_t i = 0; i < glb.json["accessors"].size(); ++i) {
        const nlohmann::json& accessor = glb.json["accessors"][i];
        if (!accessor.contains("min")) continue;
        const std::size_t width = accessor["min"].size();
        const auto values = glb.numbers<float>(static_cast<int>(i), width);
        for (std::size_t k = 0; k < width; ++k) {
            float low = values[k], high = values[k];
            for (std::size_t at = k; at < values.size(); at += width) {
                low = std::min(low, values[at]);
                high = std::max(high, values[at]);
            }
            EXPECT_EQ(accessor["min"][k].get<float>(), low);
            EXPECT_EQ(accessor["max"][k].get<float>(), high);
        }
        ++told;
    }
    EXPECT_EQ(told, 1 + 7);  // times; square, box, ball, cylinder, cone, capsule, hull
}

TEST(Glb, MeshesAreTrianglesOfUnitNormalsSeenFromOutside) {
    const Glb& glb = exported().glb;
    for (const nlohmann::json& mesh : glb.json["meshes"]) {
        const nlohmann::json& part = mesh["primitives"][0];
        const auto points = glb.numbers<float>(part["attributes"]["POSITION"], 3);
        const auto normals = glb.numbers<float>(part["attributes"]["NORMAL"], 3);
        const auto corners = glb.numbers<std::uint16_t>(part["indices"], 1);
        ASSERT_EQ(points.size(), normals.size());
        ASSERT_EQ(corners.size() % 3, 0u);
        const auto at = [](const std::vector<float>& list, int i) {
            return Eigen::Vector3f(list[3 * i], list[3 * i + 1], list[3 * i + 2]);
        };
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
            const Eigen::Vector3f a = at(points, corners[i]), b = at(points, corners[i + 1]),
                                  c = at(points, corners[i + 2]);
            const Eigen::Vector3f own = (b - a).cross(c - a);
            EXPECT_GT(own.norm(), 0.0f);
            for (int k = 0; k < 3; ++k) {
                const Eigen::Vector3f normal = at(normals, corners[i + k]);
                EXPECT_NEAR(normal.norm(), 1.0f, 1e-5f);
                EXPECT_GT(normal.dot(own), 0.0f);
            }
        }
    }
}

// The sizes of what is drawn: a unit shape, scaled by its node.
TEST(Glb, ShapesHaveTheirSizes) {
    const Glb& glb = exported().glb;
    const auto sizeOf = [&](const nlohmann::json& node) {
        const int mesh = node["mesh"];
        const int positions = glb.json["meshes"][mesh]["primitives"][0]["attributes"]["POSITION"];
        const nlohmann::json& accessor = glb.json["accessors"][positions];
        Eigen::Vector3f size;
        for (int k = 0; k < 3; ++k)
            size[k] = (accessor["max"][k].get<float>() - accessor["min"][k].get<float>()) *
                      (node.contains("scale") ? node["scale"][k].get<float>() : 1.0f);
        return size;
    };
    const auto expectSize = [&](const char* name, float x, float y, float z) {
        const Eigen::Vector3f size = sizeOf(glb.node(name));
        EXPECT_LT((size - Eigen::Vector3f(x, y, z)).norm(), 1e-5f) << name << ": " << size;
    };
    expectSize("spinner", 0.4f, 0.6f, 0.8f);
    expectSize("ball", 1, 1, 1);
    expectSize("big", 1.4f, 1.4f, 1.4f);
    expectSize("pill", 0.4f, 1.0f, 0.4f);
    expectSize("cone", 0.8f, 1.0f, 0.8f);
    expectSize("hammer part 2", 0.4f, 0.6f, 0.4f);
    expectSize("rock", 1, 1, 1);
    expectSize("floor", 40, 0, 40);
}

TEST(Glb, SharesMeshesAndMaterials) {
    const Glb& glb = exported().glb;
    EXPECT_EQ(glb.node("ball")["mesh"], glb.node("big")["mesh"]);
    EXPECT_NE(glb.node("ball")["mesh"], glb.node("spinner")["mesh"]);
    const auto materialOf = [&](const char* name) {
        return glb.json["meshes"][glb.node(name)["mesh"].get<int>()]["primitives"][0]["material"];
    };
    EXPECT_EQ(materialOf("ball"), materialOf("spinner"));
}

// 0x35 = 53: ((53 / 255 + 0.055) / 1.055)^2.4 = 0.0356.
TEST(Glb, ColorsAreLinearAndSensorsSeeThrough) {
    const Glb& glb = exported().glb;
    const auto material = [&](const char* name) {
        const int mesh = glb.node(name)["mesh"];
        const int number = glb.json["meshes"][mesh]["primitives"][0]["material"];
        return glb.json["materials"][number];
    };
    const nlohmann::json blue = material("ball")["pbrMetallicRoughness"];
    EXPECT_NEAR(blue["baseColorFactor"][0].get<double>(), 0.0356, 1e-4);
    EXPECT_EQ(blue["baseColorFactor"][3], 1.0);
    EXPECT_EQ(blue["metallicFactor"], 0.0);
    EXPECT_FALSE(material("ball").contains("alphaMode"));
    EXPECT_EQ(material("gate")["alphaMode"], "BLEND");
    EXPECT_LT(material("gate")["pbrMetallicRoughness"]["baseColorFactor"][3].get<double>(), 0.5);
}

TEST(Glb, PartsHangBelowTheirBody) {
    const Glb& glb = exported().glb;
    const nlohmann::json& children = glb.node("hammer")["children"];
    ASSERT_EQ(children.size(), 2u);
    EXPECT_FALSE(glb.node("hammer").contains("mesh"));
    const auto& drawn = exported().player.stage().drawn[exported().bodyCalled("hammer")];
    for (std::size_t i = 0; i < 2; ++i) {
        const nlohmann::json& part = glb.json["nodes"][children[i].get<int>()];
        for (int k = 0; k < 3; ++k)
            EXPECT_EQ(part["translation"][k].get<float>(),
                      static_cast<float>(drawn[i].place.position[k]));
    }
}

TEST(Glb, PosesAreTheEnginesInEveryFrame) {
    const Exported& one = exported();
    int channels = 0;
    for (std::size_t body = 0; body < one.player.stage().bodies.size(); ++body) {
        const std::string& name = one.player.stage().scene.bodies[body].name;
        std::vector<float> times;
        const int node = one.glb.numberOf(name);
        const auto places = one.glb.motion(node, "translation", &times);
        const auto turns = one.glb.motion(node, "rotation");
        channels += !places.empty() + !turns.empty();
        ASSERT_EQ(one.run.frames.size(), 31u);
        for (std::size_t frame = 0; frame < 31; ++frame) {
            const engine::Pose& pose = one.run.frames[frame].bodies[body].pose;
            if (!places.empty()) {
                EXPECT_EQ(times[frame], static_cast<float>(frame) / 30.0f);
                for (int k = 0; k < 3; ++k)
                    EXPECT_EQ(places[3 * frame + k], static_cast<float>(pose.position[k]));
            }
            if (turns.empty()) continue;
            const Eigen::Map<const Eigen::Vector4f> q(&turns[4 * frame]);
            EXPECT_NEAR(q.norm(), 1.0f, 1e-6f);
            EXPECT_NEAR(std::abs(q.cast<double>().dot(pose.rotation.coeffs())), 1.0, 1e-6);
            const Eigen::Map<const Eigen::Vector4f> before(&turns[4 * (frame > 0 ? frame - 1 : 0)]);
            EXPECT_GT(q.dot(before), 0.0f);
        }
    }
    EXPECT_GE(channels, 8);
}

// A node has its body's pose at time 0, for programs that do not animate.
TEST(Glb, NodesStandWhereTheRunBegins) {
    const Exported& one = exported();
    const Vec3 at = one.run.frames[0].bodies[one.bodyCalled("spinner")].pose.position;
    const nlohmann::json& node = one.glb.node("spinner");
    for (int k = 0; k < 3; ++k)
        EXPECT_EQ(node["translation"][k].get<float>(), static_cast<float>(at[k]));
}

TEST(Glb, WhatStaysHasNoChannel) {
    const Glb& glb = exported().glb;
    for (const char* name : {"floor", "gate", "camera", "sun"})
        for (const char* path : {"translation", "rotation"})
            EXPECT_TRUE(glb.motion(glb.numberOf(name), path).empty()) << name << " " << path;
    const Exported still(kFloor, 10);
    EXPECT_FALSE(still.glb.json.contains("animations"));
}

TEST(Glb, ABodyThatTurnsManyTimesNeverJumpsToTheOtherQuaternion) {
    const Exported top(
        "[world]\ngravity = [0, 0, 0]\n[[body]]\nname = 'top'\n"
        "shape = { sphere = 0.5 }\nat = [0, 1, 0]\nspin = [0, 20, 0]\n",
        240);
    const auto turns = top.glb.motion(top.glb.numberOf("top"), "rotation");
    ASSERT_EQ(turns.size(), 4u * 121u);  // 80 rad: twelve turns, 0.67 rad a frame
    for (std::size_t frame = 1; frame < 121; ++frame)
        EXPECT_NEAR(Eigen::Map<const Eigen::Vector4f>(&turns[4 * frame])
                        .dot(Eigen::Map<const Eigen::Vector4f>(&turns[4 * frame - 4])),
                    std::cos(20.0f / 30.0f / 2.0f), 1e-3f);
    EXPECT_TRUE(top.glb.motion(top.glb.numberOf("top"), "translation").empty());
}

/// The axes of a node: the columns of its rotation.
Eigen::Matrix3f axesOf(const nlohmann::json& node) {
    const nlohmann::json& q = node["rotation"];
    return Eigen::Quaternionf(q[3].get<float>(), q[0].get<float>(), q[1].get<float>(),
                              q[2].get<float>())
        .toRotationMatrix();
}

TEST(Glb, TheCameraLooksAtItsPointAndTheSunShinesDown) {
    const Exported one(kFloor + "[camera]\nfrom = [3, 4, 12]\nlook_at = [0, 1, 0]\nfov_deg = 50\n",
                       2);
    const nlohmann::json& node = one.glb.node("camera");
    const Eigen::Matrix3f axes = axesOf(node);
    const Eigen::Vector3f towards = (Eigen::Vector3f(0, 1, 0) - Eigen::Vector3f(3, 4, 12));
    EXPECT_GT((-axes.col(2)).dot(towards.normalized()), 0.999999f);
    EXPECT_NEAR(axes.col(0).y(), 0.0f, 1e-6f);  // level
    EXPECT_GT(axes.col(1).y(), 0.5f);
    const nlohmann::json& lens = one.glb.json["cameras"][0]["perspective"];
    EXPECT_NEAR(lens["yfov"].get<double>(), 50.0 * 3.14159265 / 180.0, 1e-6);
    EXPECT_LT(lens["znear"].get<double>(), lens["zfar"].get<double>());
    const Eigen::Vector3f sun = keyLight({3, 4, 12}, {0, 1, 0});
    EXPECT_GT(axesOf(one.glb.node("sun")).col(2).dot(sun), 0.999999f);
}

TEST(Glb, ACameraThatMovesIsAnimated) {
    const Exported orbit(kFloor + "[camera]\norbit_deg_per_s = 90\n");
    const int camera = orbit.glb.numberOf("camera");
    EXPECT_EQ(orbit.glb.motion(camera, "translation").size(), 3u * 31u);
    EXPECT_EQ(orbit.glb.motion(camera, "rotation").size(), 4u * 31u);
    const auto places = orbit.glb.motion(camera, "translation");
    for (int k = 0; k < 3; ++k) EXPECT_EQ(places[90 + k], orbit.run.frames[30].camera.from[k]);
}

TEST(Glb, AJointIsABarThatMoves) {
    const Exported one(kPendulum);
    const int bar = one.glb.numberOf("hook bar 1");
    ASSERT_GE(bar, 0);
    const auto places = one.glb.motion(bar, "translation");
    ASSERT_EQ(places.size(), 3u * 31u);
    const Vec3 bob = one.run.frames[30].bodies[0].pose.position;
    EXPECT_NEAR(places[90], 0.5 * bob.x(), 1e-6);
    EXPECT_EQ(one.glb.motion(bar, "rotation").size(), 4u * 31u);
    EXPECT_NEAR(one.glb.node("hook bar 1")["scale"][1].get<double>(), 0.5, 1e-6);
}

TEST(Glb, AGroundThatLeansIsASquareAcrossItsNormal) {
    const Exported one(
        "[[body]]\nname = 'ramp'\nshape = { plane = [1, 2, 0] }\nfixed = true\nat = [0, 1, 0]\n",
        2);
    const nlohmann::json& ramp = one.glb.node("ramp");
    EXPECT_EQ(ramp["translation"][1], 1.0);
    const nlohmann::json& square = one.glb.json["nodes"][ramp["children"][0].get<int>()];
    const Eigen::Vector3f normal = axesOf(square).col(1);
    EXPECT_LT((normal - Eigen::Vector3f(1, 2, 0).normalized()).norm(), 1e-6f);
}

}  // namespace
}  // namespace demos::test
