// demos/scene/bodies-and-joints.md lists exactly what the reader accepts.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "demos/scene/joint_kinds.h"
#include "demos/scene/reader.h"
#include "tests/support/temporary_folder.h"

namespace demos::test {
namespace {

std::string document() {
    std::ifstream file(IMPULSE_SOURCE_DIR "/demos/scene/bodies-and-joints.md");
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

/// The words in ` or ** of a cell; "anchor" and "ends" stand for the keys that place a joint.
std::set<std::string> keysIn(const std::string& cell) {
    const std::regex word(R"((?:`|\*\*)([a-z0-9_]+)(?:`|\*\*))");
    std::set<std::string> keys;
    for (std::sregex_iterator i(cell.begin(), cell.end(), word), end; i != end; ++i) {
        const std::string key = (*i)[1];
        if (key == "anchor" || key == "ends") keys.insert({"anchor_a", "anchor_b"});
        if (key != "ends") keys.insert(key);
    }
    return keys;
}

TEST(BodiesAndJoints, TheTableHasTheKeysOfEveryJoint) {
    const std::string text = document();
    for (const JointKind& kind : jointKinds()) {
        const std::size_t row = text.find("\n| `" + kind.name + "` | ");
        ASSERT_NE(row, std::string::npos) << kind.name;
        const std::string line = text.substr(row + 1, text.find('\n', row + 1) - row - 1);
        const std::string cell = line.substr(line.rfind('|', line.size() - 2));
        std::set<std::string> expected(kind.needs.begin(), kind.needs.end());
        expected.insert(kind.takes.begin(), kind.takes.end());
        EXPECT_EQ(keysIn(cell), expected) << kind.name;
        for (const std::string& key : kind.needs)
            EXPECT_NE(cell.find("**" + key + "**"), std::string::npos) << kind.name << " " << key;
    }
}

TEST(BodiesAndJoints, TheExamplesCanBeRead) {
    const support::TemporaryFolder folder;
    std::ofstream(folder / "claw.obj") << "v 0 0 0\nv 90 0 0\nv 0 40 0\nv 0 0 30\n";
    std::string scene = "format = 1\n";
    for (const char* name : {"chassis", "front_left", "barrier"})
        scene += std::string("[[body]]\nname = '") + name + "'\nshape = { sphere = 0.3 }\n";
    const std::string text = document();
    int blocks = 0;
    for (std::size_t at = text.find("```toml\n"); at != std::string::npos;
         at = text.find("```toml\n", at + 1), ++blocks)
        scene += text.substr(at + 8, text.find("```\n", at + 8) - at - 8);
    EXPECT_EQ(blocks, 2);
    const SceneDescription read = readScene(scene, "a.toml", "a", {}, folder.path());
    EXPECT_EQ(read.bodies.size(), 4u);
    EXPECT_EQ(read.joints.size(), 2u);
}

}  // namespace
}  // namespace demos::test
