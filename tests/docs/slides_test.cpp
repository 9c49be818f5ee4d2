// demos/slides/README.md agrees with the reader of decks.
#include <gtest/gtest.h>

#include "demos/measures/summary.h"
#include "demos/slides/numbers.h"
#include "demos/slides/read_deck.h"
#include "tests/docs/texts.h"

namespace {

using namespace docs;

const fs::path kSlidesFolder = demosFolder("slides");
const std::string kSlidesText = readmeOf(kSlidesFolder);

/// The keys that the reader looks up in a table; `table` is its name in error messages.
std::set<std::string> asked(const std::string& table) {
    const demos::Catalog catalog =
        demos::catalogDeck("format = 1\ntitle = 't'\n[opening]\n[[slide]]\nscene = 'stack'\n");
    std::set<std::string> names;
    for (const demos::AskedTable& one : catalog.tables())
        if (one.name == table)
            for (const demos::AskedKey& key : one.keys) names.insert(key.name);
    return names;
}

TEST(SlidesReadme, NamesEveryKeyOfADeckAndNoOther) {
    EXPECT_EQ(firstCells(sectionOf(kSlidesText, "The deck")), asked("a deck"));
    EXPECT_EQ(asked("a deck").size(), 10u);
}

TEST(SlidesReadme, NamesEveryKeyOfASlideAndNoOther) {
    EXPECT_EQ(firstCells(sectionOf(kSlidesText, "A slide")), asked("a [[slide]]"));
    EXPECT_EQ(asked("a [[slide]]").size(), 27u);
    std::set<std::string> opening = asked("a [[slide]]");
    opening.erase("title");
    EXPECT_EQ(asked("[opening]"), opening);
}

TEST(SlidesReadme, ItsDeckIsRead) {
    const std::size_t begin = kSlidesText.find("```toml\n") + 8;
    const demos::Deck deck = demos::readDeck(
        kSlidesText.substr(begin, kSlidesText.find("```", begin) - begin), "deck.toml");
    EXPECT_EQ(deck.slides.size(), 4u);
}

TEST(SlidesReadme, ItsNumbersAreRead) {
    const std::set<std::string> numbers = firstCells(sectionOf(kSlidesText, "Words"));
    EXPECT_EQ(numbers.size(), 7u);
    for (const std::string& number : numbers)
        EXPECT_EQ(demos::numberedText(number).numbers.size(), 1u) << number;
    for (const demos::Measure& measure : demos::measures())
        EXPECT_NE(sectionOf(kSlidesText, "Words").find("`" + std::string(measure.name) + "`"),
                  std::string::npos)
            << measure.name;
    for (const auto& [group, thing] : {std::pair("body.x.", "body"),
                                       {"joint.x.", "joint"},
                                       {"contacts.", "contacts"},
                                       {"run.", "run"}}) {
        const std::set<std::string> row =
            matches(sectionOf(kSlidesText, "Words"),
                    "\\| `@\\{" + std::string(thing) + "\\.[^|]* \\| ([^|]+) \\|");
        ASSERT_EQ(row.size(), 1u) << thing;
        for (const std::string& field : matches(*row.begin(), "`([a-z]+)`"))
            EXPECT_NO_THROW(demos::numberedText("@{" + std::string(group) + field + "}"));
    }
}

std::set<std::string> headersOf(const fs::path& folder) {
    std::set<std::string> files;
    for (const fs::directory_entry& file : fs::directory_iterator(folder))
        if (file.path().extension() == ".h") files.insert(file.path().stem().string());
    return files;
}

/// Every header of the folder once.
TEST(SlidesReadme, NamesEveryFileAndNoOther) {
    EXPECT_EQ(firstCells(sectionOf(kSlidesText, "Files")), headersOf(kSlidesFolder));
}

TEST(FormulasReadme, NamesEveryFileAndNoOther) {
    const fs::path folder = fs::path(IMPULSE_SOURCE_DIR) / "demos/formulas";
    EXPECT_EQ(firstCells(sectionOf(textOf(folder / "README.md"), "Files")), headersOf(folder));
}

/// The keys in backquotes in the first column; "click" is not a key.
TEST(SlidesReadme, NamesEveryKeyOfThePageAndNoOther) {
    const std::string keys = textOf(kSlidesFolder / "page" / "keys.js");
    std::set<std::string> listed{"?"};
    for (const std::string& row : matches(keys, R"(\n  \[\[(".*")\], ")"))
        listed.merge(matches(row, R"re("([^"]+)")re"));
    listed.erase("click");
    const std::string all = sectionOf(kSlidesText, "What is written");
    const std::size_t begin = all.find("| keys |");
    const std::string table = all.substr(begin, all.find("\n\n", begin) - begin);
    std::set<std::string> named;
    for (const std::string& cell : matches(table, R"(\n\| (`[^|]+) \|)"))
        named.merge(matches(cell, "`([^`]+)`"));
    EXPECT_EQ(named, listed);
    EXPECT_GE(listed.size(), 20u);
}

TEST(SlidesReadme, ItsCommandsAndTheirOptionsExist) {
    const std::string help = outputOf("slides --help");
    const std::set<std::string> lines =
        matches(sectionOf(kSlidesText, "What is written"), R"(\nimpulse slides ([^\n]*))");
    EXPECT_EQ(lines.size(), 4u);
    for (const std::string& line : lines)
        for (const std::string& option : matches(line, R"( (--?[a-z-]+))"))
            EXPECT_NE(help.find(option), std::string::npos) << line;
}

}  // namespace
