// solver.lanes = false is the same algorithm, slower and in double: contact by contact.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "demos/load/load_scene.h"
#include "demos/play/stage.h"

namespace demos {
namespace {

using ContactPlace = std::tuple<int, int, int>;  // bodies, feature
using ImpulsesOfContacts = std::map<ContactPlace, std::vector<engine::Vec3>>;

ImpulsesOfContacts impulsesOf(const Stage& stage) {
    ImpulsesOfContacts impulses;
    for (const engine::ContactState& c : stage.world.contacts())
        impulses[{c.a.index, c.b.index, c.feature}].push_back(c.impulse * c.normal + c.friction);
    return impulses;
}

class LanesAndRows : public testing::TestWithParam<const char*> {};

TEST_P(LanesAndRows, GiveTheSameImpulsesToEveryContact) {
    SceneDescription scene = loadScene(GetParam());
    scene.settings.sweeps = scene.settings.movingSweeps = 100;
    scene.settings.tolerance = 0.0;
    Stage lanes(scene);
    scene.settings.lanes = false;
    Stage rows(scene);
    ASSERT_TRUE(lanes.step() &&
                rows.step());  // later, rounding distributes loads differently between points
    const ImpulsesOfContacts a = impulsesOf(lanes), b = impulsesOf(rows);
    ASSERT_FALSE(a.empty());
    ASSERT_EQ(a.size(), b.size());
    double largest = 0.0, worst = 0.0;
    for (const auto& [key, points] : a) {
        ASSERT_TRUE(b.count(key));
        ASSERT_EQ(points.size(), b.at(key).size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            largest = std::max(largest, points[i].norm());
            worst = std::max(worst, (points[i] - b.at(key)[i]).norm());
        }
    }
    EXPECT_LT(worst, 1e-2 * largest);
}
INSTANTIATE_TEST_SUITE_P(Scenes, LanesAndRows,
                         testing::Values("arch", "card-house", "dominoes", "friction-cone",
                                         "friction-ramp", "heavy-on-light", "jenga", "pyramid",
                                         "stack", "wall"),
                         [](const auto& scene) {
                             std::string name = scene.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace demos
