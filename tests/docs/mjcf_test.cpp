// demos/mjcf/README.md and the reader of MuJoCo's models name the same words and files.
#include <gtest/gtest.h>

#include "tests/docs/texts.h"

namespace {

using namespace docs;

const fs::path kMjcfFolder = demosFolder("mjcf");
const std::string kMjcfText = readmeOf(kMjcfFolder);
const std::string kVocabulary = textOf(kMjcfFolder / "vocabulary.cpp");

TEST(MjcfReadme, NamesEveryFileAndNoOther) {
    std::set<std::string> files, named;
    for (const fs::directory_entry& file : fs::directory_iterator(kMjcfFolder))
        if (file.path().extension() == ".h") files.insert(file.path().stem().string());
    const std::string table = kMjcfText.substr(kMjcfText.find("| file | what it does |"));
    for (const std::string& row : matches(table, R"(\n\| (`[^|]*) \|)"))
        for (const std::string& name : matches(row, R"(`([a-z_]+)`)")) named.insert(name);
    EXPECT_EQ(named, files);
}

TEST(MjcfReadme, NamesEveryElementThatIsReadOrNoted) {
    const std::string kinds = R"re(Kind\{"[^"]*", "([a-z]+)", Fate::(?:read|lacking))re";
    const std::set<std::string> elements = matches(kVocabulary, kinds);
    EXPECT_GT(elements.size(), 40u);
    for (const std::string& element : elements)
        EXPECT_FALSE(matches(kMjcfText, "\\b(" + element + ")s?\\b").empty()) << element;
}

TEST(MjcfReadme, NamesOnlyWordsOfTheReader) {
    const std::string table = kMjcfText.substr(0, kMjcfText.find("\nLimits: "));
    std::set<std::string> words;
    for (const std::string& cell : matches(table, R"(\n\| ([^|]*`[^|]*) \|)"))
        for (const std::string& code : matches(cell, "`([^`]+)`"))
            for (const std::string& word : matches(code, "([a-z]+)")) words.insert(word);
    EXPECT_GT(words.size(), 60u);
    words.erase("include");  // carried out before words are checked (xml_tree.cpp)
    for (const std::string& word : words)
        EXPECT_FALSE(matches(kVocabulary, "[\" ](" + word + ")[\" =]").empty()) << word;
}

}  // namespace
