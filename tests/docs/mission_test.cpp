// tests/README.md lists the tests for each item of the mission: every item has some, and all exist.
#include <gtest/gtest.h>

#include <numeric>

#include "tests/docs/texts.h"

namespace {

using namespace docs;

constexpr int kItems = 35;

/// A name in the table; `later` if "(not yet)" follows it.
struct Named {
    std::string name;
    bool later;
};
struct Row {
    int item;
    std::vector<Named> tests;
};

std::vector<Named> namesIn(const std::string& cell) {
    std::vector<Named> names;
    const std::regex quoted(R"(`([^`]+)`( \(not yet\))?)");
    for (std::sregex_iterator i(cell.begin(), cell.end(), quoted), end; i != end; ++i)
        names.push_back({(*i)[1], (*i)[2].matched});
    return names;
}

/// The rows `| item | truth | tests |`.
std::vector<Row> tableIn(const std::string& text) {
    std::vector<Row> rows;
    const std::regex row(R"(^\| (\d+) \| .+ \| ([^|]*) \|$)");
    std::istringstream lines(text);
    std::smatch match;
    for (std::string line; std::getline(lines, line);)
        if (std::regex_match(line, match, row))
            rows.push_back({std::stoi(match[1]), namesIn(match[2])});
    return rows;
}

std::vector<int> itemsOf(const std::vector<Row>& rows) {
    std::vector<int> items;
    for (const Row& row : rows) items.push_back(row.item);
    return items;
}

std::vector<int> allItems() {
    std::vector<int> items(kItems);
    std::iota(items.begin(), items.end(), 1);
    return items;
}

/// `Suite.Name` of every test in the sources, `Suite.*` of every suite, and the plain names that
/// the build files give to programs.
std::set<std::string> testsThatExist() {
    std::set<std::string> names;
    const std::regex test(R"(\b(?:TYPED_)?TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\))");
    const std::regex program(R"((?:add_executable|add_test)\(\s*(?:NAME\s+)?(\w+))");
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(IMPULSE_SOURCE_DIR) / "tests")) {
        const bool build = entry.path().filename() == "CMakeLists.txt";
        if (!build && entry.path().extension() != ".cpp") continue;
        const std::string text = textOf(entry.path());
        const std::regex& pattern = build ? program : test;
        for (std::sregex_iterator i(text.begin(), text.end(), pattern), end; i != end; ++i) {
            const std::string first = (*i)[1];
            names.insert(build ? first : first + "." + (*i)[2].str());
            if (!build) names.insert(first + ".*");
        }
    }
    return names;
}

const std::string kTestsText = readmeOf(fs::path(IMPULSE_SOURCE_DIR) / "tests");

TEST(Mission, EveryItemHasItsRow) { EXPECT_EQ(itemsOf(tableIn(kTestsText)), allItems()); }

TEST(Mission, EveryRowNamesATest) {
    for (const Row& row : tableIn(kTestsText))
        EXPECT_FALSE(row.tests.empty()) << "item " << row.item;
}

TEST(Mission, EveryTestInTheTableExists) {
    const std::set<std::string> existing = testsThatExist();
    ASSERT_GT(existing.size(), 100u);
    for (const Row& row : tableIn(kTestsText))
        for (const Named& test : row.tests)
            EXPECT_TRUE(test.later || existing.count(test.name))
                << "item " << row.item << ": " << test.name;
}

// Only tests that are known to be missing are marked; once such a test exists, its mark must go.
TEST(Mission, OnlyWhatIsKnownToBeMissingIsNotYetThere) {
    const std::set<std::string> known{"(with its joints)", "Pgs.*",            "Direct.*",
                                      "solver_benchmark",  "SoftConstraint.*", "PointBlock.*"};
    const std::set<std::string> existing = testsThatExist();
    for (const Row& row : tableIn(kTestsText))
        for (const Named& test : row.tests) {
            if (!test.later) continue;
            EXPECT_TRUE(known.count(test.name)) << "item " << row.item << ": " << test.name;
            EXPECT_FALSE(existing.count(test.name)) << test.name << " exists: remove '(not yet)'";
        }
}

// Tests the check itself: it notices a missing row, wherever the row was.
TEST(Mission, ARowTakenAwayIsMissed) {
    for (int item = 1; item <= kItems; ++item) {
        const std::regex row("\\n\\| " + std::to_string(item) + " \\|[^\\n]*");
        const std::string without = std::regex_replace(kTestsText, row, "");
        EXPECT_EQ(itemsOf(tableIn(without)).size(), kItems - 1u) << item;
        EXPECT_NE(itemsOf(tableIn(without)), allItems()) << item;
    }
}

}  // namespace
