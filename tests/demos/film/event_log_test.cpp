// The events of a run, as films and exports list them.

#include <gtest/gtest.h>

#include <string>

#include "demos/film/event_log.h"
#include "demos/play/stage.h"
#include "tests/demos/reading.h"

namespace demos::test {
namespace {

/// 72 kg hang from a weld that breaks at 2 kN; a ball that falls on them breaks it.
TEST(EventLog, ListsJointsThatBreak) {
    Stage stage(read("[[body]]\nname = 'ball'\nshape = { sphere = 0.2 }\nat = [1, 4, 0]\n"
                     "[[body]]\nname = 'box'\nshape = { box = [0.6, 0.3, 0.4] }\nat = [1, 2, 0]\n"
                     "[[joint]]\ntype = 'weld'\na = 'world'\nb = 'box'\nanchor = [1, 2.4, 0.1]\n"
                     "break_at = 2000\nname = 'hook'\n" +
                     kFloor));
    stage.world.watchTouches(true);
    EventLog log;
    int steps = 0;
    for (; log.events().breaks.empty() && steps < 120; ++steps) {
        ASSERT_TRUE(stage.step());
        log.look(stage);
    }
    ASSERT_EQ(log.events().breaks.size(), 1u);
    const JointBreak& event = log.events().breaks[0];
    EXPECT_EQ(event.step, steps);
    EXPECT_NEAR(event.time, steps / 60.0, 1e-12);
    EXPECT_GT(event.force.norm(), 2000.0);
    EXPECT_TRUE(stage.world.joint(stage.joints[0]).broken);
    // The ball touched first, in the same step; the break is listed after it.
    const std::string json = eventsJson(log.events(), stage);
    const std::size_t begin = json.find("{\"event\":\"begin\",\"step\":" + std::to_string(steps));
    const std::size_t broken = json.find("{\"event\":\"break\",\"step\":" + std::to_string(steps));
    ASSERT_NE(broken, std::string::npos) << json;
    EXPECT_LT(begin, broken) << json;
    EXPECT_NE(json.find(R"("joint":"hook","a":"world","b":"box","position":[)"), std::string::npos)
        << json;
}

}  // namespace
}  // namespace demos::test
