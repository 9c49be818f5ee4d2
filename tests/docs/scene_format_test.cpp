// demos/scene/README.md agrees with the reader; the schema has every key of the reader's source.
#include <gtest/gtest.h>

#include "demos/look/theme.h"
#include "demos/scene/every_key.h"
#include "tests/docs/texts.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace docs;

const fs::path kSceneFolder = demosFolder("scene");
const std::string kSceneText = readmeOf(kSceneFolder);

/// Writes the README's scene to a file.
class SceneReadme : public testing::Test {
protected:
    void SetUp() override {
        const std::size_t begin = kSceneText.find("```toml\n") + 8;
        std::ofstream(folder_ / "a.toml")
            << kSceneText.substr(begin, kSceneText.find("```", begin) - begin);
    }

    std::string sim(const std::string& options) {
        return outputOf("sim '" + (folder_ / "a.toml").string() + "' " + options);
    }

    support::TemporaryFolder folder_;
};

TEST_F(SceneReadme, ItsSceneKeepsItsContract) {
    const std::string out = sim("--hash");
    EXPECT_NE(out.find("ok      largest drift of ball below 2 m"), std::string::npos) << out;
    EXPECT_EQ(out.find("impulse: "), std::string::npos) << out;
}

TEST_F(SceneReadme, ItsOptionsAreTaken) {
    const std::set<std::string> options = matches(kSceneText, R"(`(--set [^`K]+)`)");
    EXPECT_GE(options.size(), 6u);
    for (const std::string& option : options) {
        const std::string out = sim("--no-expect --seconds 0.1 --hash " + option);
        EXPECT_EQ(out.find("impulse: "), std::string::npos) << option << "\n" << out;
        EXPECT_NE(out.find("state"), std::string::npos) << option << "\n" << out;
    }
}

TEST_F(SceneReadme, NamesEveryFunctionAndNoOther) {
    const std::size_t row = kSceneText.find("| functions | `") + 15;
    const std::string list = kSceneText.substr(row, kSceneText.find('`', row) - row);
    const std::string source = textOf(kSceneFolder / "expression.cpp");
    EXPECT_EQ(matches(list, "([a-z0-9]+)"), matches(source, R"(DefineFun\("([a-z0-9]+)\")"));
    EXPECT_GE(matches(list, "([a-z0-9]+)").size(), 15u);
}

TEST_F(SceneReadme, NamesEveryLookAndNoOther) {
    const std::size_t begin = kSceneText.find("| look |"), end = kSceneText.find("\n\n", begin);
    const std::vector<std::string>& names = demos::materialNames();
    EXPECT_EQ(matches(kSceneText.substr(begin, end - begin), "`([a-z]+)`"),
              std::set<std::string>(names.begin(), names.end()));
}

TEST_F(SceneReadme, NamesFilesThatAreThere) {
    for (const std::string& file : matches(kSceneText, R"(`([a-z_]+\.cpp)`)"))
        EXPECT_TRUE(fs::exists(kSceneFolder / file)) << file;
}

TEST(SceneSchema, KnowsEveryKeyThatTheReaderAsksFor) {
    const std::string schema = outputOf("list --schema");
    std::set<std::string> keys;
    for (const fs::directory_entry& file : fs::directory_iterator(kSceneFolder))
        if (file.path().extension() == ".cpp")
            keys.merge(matches(textOf(file.path()),
                               R"((?:any|number|whole|large|truth|text|vector|texts|numbers)"
                               R"(|vectors|word|color|tables|required)\("([a-z_]+)\")"));
    EXPECT_GE(keys.size(), 90u);
    for (const std::string& key : keys)
        EXPECT_NE(schema.find("\"" + key + "\": "), std::string::npos)
            << key << ": give it in demos/scene/every_key_*.cpp";
}

/// Every key of these tables of the format; "*" is none.
std::set<std::string> keysOf(const std::set<std::string>& tables) {
    std::set<std::string> keys;
    for (const demos::TableTexts& texts : demos::everyText())
        if (tables.contains(texts.table))
            for (const demos::KeyText& text : texts.keys)
                if (text.key != std::string("*")) keys.insert(text.key);
    return keys;
}

/// The pages in words have every key of the sentences, and no other in their tables of keys.
TEST(ScenePages, HaveEveryKeyAndNoOther) {
    struct Page {
        fs::path file;
        std::string begin, end;
        std::set<std::string> tables;
    };
    const Page pages[] = {
        {kSceneFolder / "bodies-and-joints.md", "## Joints", "\n```toml",
         {"a [[joint]]", "a motor", "a spring", "a coordinate"}},
        {kSceneFolder / "bodies-and-joints.md", "## Shapes", "\n**The origin.**",
         {"a shape", "a part", "a mesh", "a height_field", "a capsule"}},
        {demosFolder(""), "## The camera", "\n## ", {"[camera]", "a key of the camera"}},
    };
    for (const Page& page : pages) {
        const std::string all =
            textOf(fs::is_directory(page.file) ? page.file / "README.md" : page.file);
        const std::size_t begin = all.find(page.begin);
        ASSERT_NE(begin, std::string::npos) << page.begin;
        const std::string text = all.substr(begin, all.find(page.end, begin) - begin);
        const std::set<std::string> keys = keysOf(page.tables);
        for (const std::string& key : keys)
            EXPECT_TRUE(std::regex_search(text, std::regex("\\b" + key + "\\b"))) << key;
        std::set<std::string> listed;
        for (std::size_t at = text.find("| key |"); at != std::string::npos;
             at = text.find("| key |", at + 1))
            listed.merge(firstCells(text.substr(at, text.find("\n\n", at) - at)));
        EXPECT_GE(listed.size(), 8u) << page.begin;
        for (const std::string& key : listed)
            EXPECT_TRUE(keys.contains(key)) << key << " in " << page.begin;
    }
}

}  // namespace
