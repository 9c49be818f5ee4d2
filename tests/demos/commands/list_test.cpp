// impulse list: groups, one scene.
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/demos/program.h"

namespace demos::test {
namespace {

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::vector<nlohmann::json> listedScenes() {
    const TemporaryFolder folder;
    std::vector<nlohmann::json> scenes;
    for (const std::string& line : linesOf(run(folder.path(), {"list", "--json"}).out))
        scenes.push_back(nlohmann::json::parse(line));
    return scenes;
}

TEST(List, EverySceneHasAGroupAndAPurposeOfOneLine) {
    const std::vector<nlohmann::json> scenes = listedScenes();
    EXPECT_GE(scenes.size(), 14u);
    for (const nlohmann::json& scene : scenes) {
        EXPECT_FALSE(scene["group"].get<std::string>().empty()) << scene["scene"];
        const std::string purpose = scene["purpose"];
        EXPECT_GE(purpose.size(), 10u) << scene["scene"];
        EXPECT_LE(purpose.size(), 80u) << scene["scene"];
        EXPECT_EQ(purpose.find('\n'), std::string::npos) << scene["scene"];
    }
}

TEST(List, ShowsEveryGroupOnceWithItsScenesBelow) {
    const TemporaryFolder folder;
    const std::vector<std::string> lines = linesOf(run(folder.path(), {"list"}).out);
    for (const nlohmann::json& scene : listedScenes()) {
        const std::string group = scene["group"], name = scene["scene"];
        EXPECT_EQ(std::count(lines.begin(), lines.end(), group), 1) << group;
        auto line = std::find(lines.begin(), lines.end(), group);
        while (line != lines.end() && !line->starts_with("  " + name + " ") && !line->empty()) ++line;
        ASSERT_TRUE(line != lines.end() && !line->empty()) << name << " is not under " << group;
        EXPECT_TRUE(line->ends_with(scene["purpose"].get<std::string>())) << name;
    }
}

TEST(List, ExplainsAKey) {
    const TemporaryFolder folder;
    const Ended ended = run(folder.path(), {"list", "--explain", "body.ball.mass"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(linesOf(ended.out).size(), 5u);
    EXPECT_TRUE(ended.out.starts_with("body.mass: The mass, ")) << ended.out;
}

TEST(List, SaysWhatIsWrong) {
    const TemporaryFolder folder;
    const auto errorOf = [&](const std::vector<std::string>& arguments) {
        const Ended ended = run(folder.path(), arguments);
        EXPECT_EQ(ended.code, 2);
        EXPECT_EQ(ended.errorLines(), 1) << ended.err;
        return ended.err;
    };
    EXPECT_NE(errorOf({"list", "stack", "wall"}).find("list describes one"), std::string::npos);
    EXPECT_NE(errorOf({"list", "--print"}).find("--print needs a scene"), std::string::npos);
}

}  // namespace
}  // namespace demos::test
