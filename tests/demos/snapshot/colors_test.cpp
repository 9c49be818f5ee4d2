#include "demos/snapshot/colors.h"

#include <gtest/gtest.h>

#include "demos/snapshot/player.h"
#include "tests/demos/reading.h"

namespace demos {
namespace {

using test::sceneFrom;

/// A floor, two stacked boxes, a separate box, and a ball that flies at 3 m/s.
const std::string kFiveBodies = R"(format = 1
[[material]]
name = "ice"
friction = 0.1
[[body]]
name = "floor"
shape = { plane = [0, 1, 0] }
fixed = true
[[body]]
name = "box1"
shape = { box = [1, 1, 1] }
at = [0, 0.5, 0]
[[body]]
name = "box2"
shape = { box = [1, 1, 1] }
at = [0, 1.5, 0]
[[body]]
name = "box3"
shape = { box = [1, 1, 1] }
at = [5, 0.5, 0]
material = "ice"
[[body]]
name = "ball"
shape = { sphere = 0.5 }
at = [0, 9, 0]
velocity = [3, 0, 0]
colour = "#102030"
)";

bool same(const render::Color& a, const render::Color& b) {
    return a.r == b.r && a.g == b.g && a.b == b.b;
}

TEST(Colors, TheScaleEndsInVioletAndYellowAndGetsLighterAllTheWay) {
    const render::Color low = scaleColor(0.0), high = scaleColor(1.0);
    EXPECT_NEAR(low.r, 0x44 / 255.0, 1e-6);
    EXPECT_NEAR(high.r, 0xfd / 255.0, 1e-6);
    EXPECT_TRUE(same(scaleColor(-3.0), low));
    EXPECT_TRUE(same(scaleColor(7.0), high));
    float before = -1.0f;
    for (int i = 0; i <= 64; ++i) {
        const render::Color c = scaleColor(i / 64.0);
        const float luma = 0.299f * c.r + 0.587f * c.g + 0.114f * c.b;
        EXPECT_GT(luma, before) << i;
        before = luma;
    }
}

TEST(Colors, IslandsAreWhatTouchesAndTheFloorJoinsNobody) {
    Player player(sceneFrom(kFiveBodies), {});
    player.step(5);
    EXPECT_EQ(islandsOf(player.stage()), (std::vector<int>{-1, 1, 1, 3, 4}));
}

TEST(Colors, SpeedIsInMetresPerSecondAndFixedBodiesAreGrey) {
    const Stage stage(sceneFrom(kFiveBodies));
    EXPECT_EQ(colorValues(stage, "speed"), (std::vector<double>{-1, 0, 0, 0, 3}));
    Overlays overlays;
    overlays.colorBy = "speed";
    overlays.colorMax = 6.0;
    const std::vector<render::Color> colors = bodyColors(stage, overlays, {});
    EXPECT_TRUE(same(colors[1], scaleColor(0.0)));
    EXPECT_TRUE(same(colors[4], scaleColor(0.5)));
    EXPECT_FALSE(same(colors[0], scaleColor(0.0)));
}

TEST(Colors, ImpulseIsWhatABodyCarriesAndWhatItRestsOn) {
    Player player(sceneFrom(kFiveBodies), {});
    player.step(30);
    const std::vector<double> values = colorValues(player.stage(), "impulse");
    const double weight = 1000.0 * 9.81 / 60.0;  // N s in a step, of a cube of water's density
    EXPECT_NEAR(values[3], weight, 0.02 * weight);
    EXPECT_NEAR(values[2], weight, 0.02 * weight);
    EXPECT_NEAR(values[1], 3.0 * weight, 0.02 * weight);  // one above, two below
    EXPECT_EQ(values[4], 0.0);
}

TEST(Colors, TheScaleReachesTheLargestSoFarAndNeverShrinks) {
    Overlays overlays;
    overlays.colorBy = "speed";
    History history;
    history.largestValue = 3.0;
    EXPECT_EQ(scaleEnd(overlays, history), 5.0);
    Player player(sceneFrom(kFiveBodies), overlays);
    const auto endOf = [&] {
        for (const render::Plate& plate : player.frame(0.0).plates)
            for (const render::PlateRow& row : plate.rows)
                if (!row.ramp.empty()) return row.value;
        return std::string("no scale");
    };
    EXPECT_EQ(endOf(), "5");
    player.step(60);  // it has fallen 5 m and has a speed of 10 m/s
    EXPECT_EQ(endOf(), "20");
    player.step(240);
    EXPECT_EQ(endOf(), "20");
    overlays.colorMax = 7.5;
    EXPECT_EQ(scaleEnd(overlays, history), 7.5);
}

TEST(Colors, GroupsAndMaterialsAndOwnColours) {
    const Stage stage(sceneFrom(kFiveBodies));
    const auto colored = [&](const char* by) {
        Overlays overlays;
        overlays.colorBy = by;
        return bodyColors(stage, overlays, {});
    };
    const auto group = colored("group"), material = colored("material"), body = colored("body");
    EXPECT_TRUE(same(group[1], group[3]));
    EXPECT_FALSE(same(group[1], group[4]));
    EXPECT_TRUE(same(material[1], material[2]));
    EXPECT_FALSE(same(material[1], material[3]));
    EXPECT_NEAR(body[4].r, 0x10 / 255.0, 1e-6);
    for (const std::string& name : colorings()) EXPECT_EQ(colored(name.c_str()).size(), 5u) << name;
}

TEST(Colors, OfGroupsAndMaterialsAreNamed) {
    const Stage stage(sceneFrom(kFiveBodies));
    const auto groups = colorMeanings(stage, "group");  // not the floor, which is fixed
    ASSERT_EQ(groups.size(), 2u);
    EXPECT_EQ(groups[0].name, "box");
    EXPECT_EQ(groups[1].name, "ball");
    const auto colors = bodyColors(stage, {.colorBy = "group"}, {});
    EXPECT_TRUE(same(groups[0].color, colors[1]));
    EXPECT_TRUE(same(groups[1].color, colors[4]));
    const auto materials = colorMeanings(stage, "material");
    ASSERT_EQ(materials.size(), 2u);
    EXPECT_TRUE(materials[1].name.starts_with("friction 0.1, ")) << materials[1].name;
    for (const char* by : {"body", "island", "id", "speed"})
        EXPECT_TRUE(colorMeanings(stage, by).empty()) << by;
}

}  // namespace
}  // namespace demos
