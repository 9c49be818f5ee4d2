// What each mutant does to a scene, and to which of its bodies. self_test_test.cpp draws them and
// tests that they are caught.
#include "demos/regression/mutants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "demos/snapshot/snapshot.h"
#include "render/surface_map.h"
#include "tests/demos/reading.h"

namespace demos {
namespace {

/// Body 0 has one solid, body 1 has two; z is to the right of the picture.
Specimen specimen() {
    Specimen one;
    for (const int id : {0, 1, 1}) {
        render::Solid solid;
        solid.id = id;
        solid.color = {0.5f, 0.5f, 0.5f, 1.0f};
        one.now.frame.solids.push_back(solid);
    }
    one.now.poses = {{Vec3(1, 2, 3), Quat::Identity()}, {Vec3(4, 5, 6), Quat::Identity()}};
    one.late = one.now;
    one.late.poses[0].position.y() = 1.9;
    one.body = 1;
    one.across = Vec3::UnitZ();
    return one;
}

Sight damaged(const std::string& name, const Specimen& one = specimen()) {
    for (const Mutant& mutant : mutants())
        if (mutant.name == name) return mutant.damaged(one);
    ADD_FAILURE() << "no mutant is called " << name;
    return {};
}

TEST(Mutants, HaveNamesOfTheirOwn) {
    std::set<std::string> names;
    for (const Mutant& mutant : mutants()) EXPECT_TRUE(names.insert(mutant.name).second);
    EXPECT_GE(names.size(), 7u);
}

TEST(Mutants, MoveAllPartsOfOneBodyAndItsPose) {
    for (const auto& [name, distance] : {std::pair{"1 mm", 0.001}, {"1 cm", 0.01}}) {
        const Sight sight = damaged(name);
        EXPECT_EQ(sight.poses[0].position, Vec3(1, 2, 3)) << name;
        EXPECT_NEAR((sight.poses[1].position - Vec3(4, 5, 6 + distance)).norm(), 0, 1e-15) << name;
        for (int i = 0; i < 3; ++i)
            EXPECT_FLOAT_EQ(sight.frame.solids[i].position.z(),
                            i == 0 ? 0.0f : static_cast<float>(distance))
                << name << ", solid " << i;
    }
}

TEST(Mutants, HideOneBodyButNotFromTheState) {
    const Sight sight = damaged("hidden");
    ASSERT_EQ(sight.frame.solids.size(), 1u);
    EXPECT_EQ(sight.frame.solids[0].id, 0);
    EXPECT_EQ(sight.poses[1].position, Vec3(4, 5, 6));
}

TEST(Mutants, ColorOneBody) {
    const Sight sight = damaged("color");
    EXPECT_FLOAT_EQ(sight.frame.solids[0].color.r, 0.5f);
    for (const int part : {1, 2}) {
        EXPECT_FLOAT_EQ(sight.frame.solids[part].color.r, 0.55f);
        EXPECT_FLOAT_EQ(sight.frame.solids[part].color.b, 0.45f);
    }
}

TEST(Mutants, TurnTheSunByFiveDegrees) {
    const render::Vec3 before = render::Look{}.sunDirection;
    const render::Vec3 after = damaged("light").frame.look.sunDirection;
    const float cosine = before.normalized().dot(after.normalized());
    EXPECT_NEAR(std::acos(cosine) * 180.0f / 3.14159265f, 5.0f, 0.01f);
}

TEST(Mutants, OfThePictureAloneLeaveTheState) {
    EXPECT_FALSE(damaged("no shadow").frame.look.shadows);
    EXPECT_DOUBLE_EQ(damaged("gamma").gamma, 1.05);
    for (const char* name : {"hidden", "color", "light", "no shadow", "gamma"})
        EXPECT_EQ(damaged(name).poses[0].position, Vec3(1, 2, 3)) << name;
    EXPECT_EQ(damaged("late").poses[0].position, Vec3(1, 1.9, 3));
}

TEST(Mutants, ChangeNothingWhereNothingMoves) {
    Specimen still = specimen();
    still.body = -1;
    for (const char* name : {"1 mm", "hidden", "color"}) {
        const Sight sight = damaged(name, still);
        EXPECT_EQ(sight.frame.solids.size(), 3u) << name;
        EXPECT_EQ(sight.poses[1].position, Vec3(4, 5, 6)) << name;
    }
}

/// The picture shows surface 0 once, surface 1 twice, surface 2 three times, and sky.
render::SurfaceMap map() {
    render::SurfaceMap map{4, 2, {}};
    for (const int surface : {0, 1, 1, 2, 2, 2})
        map.packed.push_back(render::packedSurface(surface, 3));
    map.packed.resize(8, render::kNoSurface);
    return map;
}

std::string balls(const char* kindOfThird) {
    std::string text;
    for (const char* name : {"a", "b", "c"})
        text += std::string("[[body]]\nname = '") + name + "'\nshape = { sphere = 0.5 }\n" +
                (*name == 'c' ? kindOfThird : "");
    return text;
}

TEST(MostSeenBody, IsTheMovingOneWithTheMostPixels) {
    const auto seenOf = [](const SceneDescription& scene, const render::SurfaceMap& map) {
        const Stage stage(scene);
        return mostSeenBody(stage, snapshot(stage, {}, 0.0), map);
    };
    EXPECT_EQ(seenOf(test::read(balls("")), map()), 2);
    EXPECT_EQ(seenOf(test::read(balls("fixed = true\n")), map()), 1);
    render::SurfaceMap sky = map();
    std::fill(sky.packed.begin(), sky.packed.end(), render::kNoSurface);
    EXPECT_EQ(seenOf(test::read(balls("")), sky), 0);  // none is visible: the state can notice
    EXPECT_EQ(seenOf(test::read(test::kFloor), sky), -1);
}

TEST(MutantSummaries, CountTimesAndKeepTheLargest) {
    std::vector<MutantVerdict> verdicts(3);
    for (MutantVerdict& verdict : verdicts) verdict.mutant = &mutants()[1];
    verdicts[0].unchanged = true;
    verdicts[1].state = true;
    verdicts[1].difference.worstWindow = 30;
    verdicts[2].picture = verdicts[2].state = true;
    verdicts[2].difference.worstSsim = 0.5;
    const std::vector<MutantSummary> all = summaries(verdicts);
    ASSERT_EQ(all.size(), mutants().size());
    const MutantSummary& one = all[1];
    EXPECT_EQ(one.times, 3);
    EXPECT_EQ(one.state, 2);
    EXPECT_EQ(one.picture, 1);
    EXPECT_EQ(one.window, 30);
    EXPECT_DOUBLE_EQ(one.ssim, 0.5);
    EXPECT_TRUE(one.caught());
    EXPECT_FALSE(one.unchanged);
}

TEST(MutantSummaries, MissedIsWhatChangesSomethingAndIsNotNoticed) {
    MutantSummary summary;
    EXPECT_FALSE(summary.missed());
    summary.unchanged = false;
    EXPECT_TRUE(summary.missed());
    summary.picture = 1;
    EXPECT_FALSE(summary.missed());
}

TEST(PictureGates, OfScenesAreTheRenderersUnlessTheySayOtherwise) {
    const PictureGate ofScenes;
    const render::Gate ofRenderer;
    EXPECT_EQ(ofScenes.levels, ofRenderer.levels);
    EXPECT_EQ(ofScenes.windowPixels, ofRenderer.windowPixels);
    EXPECT_EQ(ofScenes.ssim, ofRenderer.ssim);
}

}  // namespace
}  // namespace demos
