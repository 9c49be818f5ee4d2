// A scene as keys and values: what counts as a change of it.
#include "demos/scene/scene_values.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "tests/demos/reading.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace demos::test {
namespace {

const std::string kCrate = R"(format = 1
[[material]]
name = "wood"
friction = 0.6
[[body]]
name = "crate"
at = [1, 2.5, -3]
shape = { box = [1, 1, 1] }
[[expect]]
what = "drift"
of = "crate"
below = 0.005
[[expect]]
what = "drift"
of = "crate"
below = 0.1
[[repeat]]
count = 3
body = { name = "ball{i}", at = ["i", 0, 0] }
)";

std::map<std::string, std::string> valuesIn(const std::string& text,
                                            const std::vector<std::string>& overrides = {}) {
    const SceneValues values = sceneValues(text, "crate.toml", overrides, std::nullopt);
    EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
    return {values.begin(), values.end()};
}

TEST(SceneValues, AreCalledByTheNamesOfTheirTables) {
    const auto values = valuesIn(kCrate);
    for (const auto& [key, value] :
         std::map<std::string, std::string>{{"material.wood.friction", "0.6"},
                                            {"body.crate", "[[body]]"},
                                            {"body.crate.at", "[1, 2.5, -3]"},
                                            {"body.crate.shape.box", "[1, 1, 1]"},
                                            {"expect.drift of crate.below", "0.005"},
                                            {"expect.drift of crate #2.below", "0.1"},
                                            {"repeat.ball{i}.body.at", "[i, 0, 0]"}}) {
        ASSERT_TRUE(values.count(key)) << key;
        EXPECT_EQ(values.at(key), value) << key;
    }
}

TEST(SceneValues, IgnoreCommentsOrderAndSpelling) {
    std::string other = kCrate;
    other.replace(other.find("name = \"wood\"\nfriction = 0.6"), 29,
                  "friction = 6.0e-1  # dry\nname = 'wood'\n");
    EXPECT_EQ(valuesIn(other), valuesIn(kCrate));
    EXPECT_NE(valuesIn(kCrate, {"body.crate.at=[1, 2, -3]"}), valuesIn(kCrate));
    EXPECT_EQ(valuesIn(kCrate, {"body.ball[1].mass=5"}).at("body.ball[1].mass"), "5");
}

TEST(SceneValues, HaveThoseOfIncludedFiles) {
    const support::TemporaryFolder folder;
    std::ofstream(folder / "part.toml") << "[[material]]\nname = 'steel'\nfriction = 0.4\n";
    const SceneValues values =
        sceneValues("format = 1\ninclude = ['part.toml']\n", "a.toml", {}, folder.path());
    EXPECT_EQ(std::count(values.begin(), values.end(),
                         std::pair<std::string, std::string>("material.steel.friction", "0.4")),
              1);
}

TEST(SceneValues, AreShortAndOnOneLine) {
    const std::string begin = "format = 1\ntitle = \"\"\"a\nb\"\"\"\npoints = [",
                      many = support::repeated("1, ", 300);
    const auto values = valuesIn(begin + many + "2]\n"), others = valuesIn(begin + many + "3]\n");
    EXPECT_EQ(values.at("title"), "a\\x0ab");
    EXPECT_LT(values.at("points").size(), 100u);
    EXPECT_NE(values.at("points"), others.at("points"));
}

}  // namespace
}  // namespace demos::test
