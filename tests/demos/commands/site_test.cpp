// impulse site: every link leads somewhere, the same command twice gives the same bytes.
#include <map>
#include <regex>

#include "tests/demos/small_film.h"

namespace demos::test {
namespace {

class Site : public testing::Test {
protected:
    Site() { write(folder / "ball.toml", kBall); }

    Ended site(std::vector<std::string> more) const {
        std::vector<std::string> words{"site",      "ball.toml", "--size",    "96x54",
                                       "--fps",     "10",        "--samples", "1",
                                       "--seconds", "0.5",       "--no-films"};
        words.insert(words.end(), more.begin(), more.end());
        return run(folder.path(), words);
    }
    fs::path root() const { return folder / "output/site"; }

    std::map<fs::path, std::string> files() const {
        std::map<fs::path, std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(root()))
            if (entry.is_regular_file())
                all[entry.path().lexically_relative(root())] = contentOf(entry.path());
        return all;
    }

    TemporaryFolder folder;
};

std::vector<std::string> linksIn(const std::string& page) {
    static const std::regex link("(?:href|src)=\"([^\"]*)\"");
    std::vector<std::string> links;
    for (std::sregex_iterator i(page.begin(), page.end(), link), end; i != end; ++i)
        links.push_back((*i)[1]);
    return links;
}

/// Whether the page has this place; a card of the gallery is made by its script.
bool hasPlace(const std::string& page, const std::string& id) {
    if (page.find("id=\"" + id + "\"") != std::string::npos) return true;
    return id.starts_with("scene-") &&
           page.find("\"name\":\"" + id.substr(6) + "\"") != std::string::npos;
}

TEST_F(Site, EveryLinkLeadsSomewhere) {
    const Ended ended = site({});
    ASSERT_EQ(ended.code, 0) << ended.err;
    const std::map<fs::path, std::string> all = files();
    EXPECT_TRUE(all.contains("index.html") && all.contains("gallery/ball.html"));
    int pages = 0, looked = 0;
    for (const auto& [name, text] : all) {
        if (name.extension() != ".html" || name == "gallery/ball.html") continue;
        ++pages;
        for (const std::string& link : linksIn(text)) {
            if (link.starts_with("http") || link.starts_with("mailto:")) continue;
            const std::size_t hash = std::min(link.find('#'), link.size());
            const fs::path target =
                hash == 0 ? name : (name.parent_path() / link.substr(0, hash)).lexically_normal();
            const auto found = all.find(target);
            ASSERT_NE(found, all.end()) << name << ": " << link;
            if (hash < link.size()) {
                EXPECT_TRUE(hasPlace(found->second, link.substr(hash + 1))) << name << ": " << link;
            }
            ++looked;
        }
    }
    EXPECT_GE(pages, 20);
    EXPECT_GT(looked, 900);
}

/// Only the reader goes to the web, by links of the texts; the pages load nothing from it.
TEST_F(Site, LoadsNothingFromTheWebAndIsSearched) {
    ASSERT_EQ(site({}).code, 0);
    const std::map<fs::path, std::string> all = files();
    static const std::regex loaded("(?:src|srcset)=\"[a-z]+:|url\\((?!data:)|@import|<link");
    for (const auto& [name, text] : all)
        EXPECT_TRUE(name.extension() != ".html" || !std::regex_search(text, loaded)) << name;
    const std::string& index = all.at("search.js");
    for (const char* row :
         {R"(["keys.html#solver.sweeps","Every key","solver.sweeps",)",
          R"(["gallery/index.html#scene-ball","Gallery",)",
          R"(["recipes.html#a-see-saw","Recipes","A see-saw",)", "something explodes"})
        EXPECT_NE(index.find(row), std::string::npos) << row;
}

TEST_F(Site, TheSameCommandTwiceGivesTheSameBytes) {
    const Ended first = site({});
    ASSERT_EQ(first.code, 0) << first.err;
    const std::map<fs::path, std::string> before = files();
    const Ended again = site({});
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.out.find("0 drawn, 1 kept"), std::string::npos) << again.out;
    EXPECT_TRUE(files() == before);
}

TEST_F(Site, ReplacesNothingThatIsNotItsOwn) {
    for (const char* name : {"index.html", "recipes.html", "search.js"}) {
        fs::remove_all(folder / "output");
        fs::create_directories(root());
        write(root() / name, "a stranger's");
        const Ended ended = site({});
        EXPECT_EQ(ended.code, 5) << ended.err;
        EXPECT_EQ(ended.errorLines(), 1) << ended.err;
        EXPECT_EQ(contentOf(root() / name), "a stranger's");
        EXPECT_FALSE(fs::exists(root() / "gallery")) << "refused before anything is drawn";
    }
    EXPECT_EQ(site({"--overwrite"}).code, 0);
    EXPECT_EQ(site({"-o", "site.html"}).code, 2);
}

}  // namespace
}  // namespace demos::test
