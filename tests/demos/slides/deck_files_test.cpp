// Decks in files next to the scenes that they name, and decks made from scenes.

#include <gtest/gtest.h>

#include <fstream>

#include "demos/slides/deck_of_scenes.h"
#include "demos/slides/read_deck.h"
#include "tests/demos/reading.h"
#include "tests/support/temporary_folder.h"

namespace demos::test {
namespace {

using List = std::vector<std::string>;

class DeckFiles : public testing::Test {
protected:
    void write(const std::string& name, const std::string& text) {
        std::filesystem::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name, std::ios::binary) << "format = 1\n" << text;
    }
    std::string path(const std::string& name) { return (folder_ / name).string(); }
    std::string error(const std::string& name) {
        try {
            loadDeck(folder_ / name);
        } catch (const SceneError& error) {
            return error.lines().front();
        }
        return "";
    }

    support::TemporaryFolder folder_;
};

const std::string kFall =
    "title = 'fall: a ball'\npurpose = 'It *falls*'\nseconds = 3\n" + kFloor + kBall;
const std::string kSections =
    "[[section]]\nat = 0\nname = 'up'\ncaption = 'a * b * c $'\n"
    "[[section]]\nat = 1\nname = 'down'\ntitle = 'It _falls_'\ntext = 'at @{body.ball.speed}'\n"
    "formula = ['a', 'b']\nplot = 'energy'\ntable = 'expectations'\nslow = 0.5\npause = true\n"
    "loop = true\nposter = 'first'\nnotes = 'n'\n"
    "[[section]]\nat = 2\nname = 'end'\n";

const std::string kExpect = "[[expect]]\nwhat = 'speed'\nbelow = 100\nwhy = 'w'\n";

TEST_F(DeckFiles, NameScenesBesideThem) {
    write("parts/floor.toml", kFloor);
    write("parts/a.toml", "include = 'floor.toml'\n" + kBall);
    write("deck.toml", "title = 'T'\n[[slide]]\nscene = 'parts/a.toml'\n");
    const Deck read = loadDeck(folder_ / "deck.toml");
    EXPECT_EQ(read.slides[1].runs.scene, path("parts/a.toml"));
    EXPECT_EQ(read.files, (std::vector<std::filesystem::path>{
                              path("deck.toml"), path("parts/a.toml"), path("parts/floor.toml")}));
    write("parts/a.toml", "hz = 3\n" + kBall);
    EXPECT_EQ(error("deck.toml"), path("deck.toml") + ":4:9: the scene: " + path("parts/a.toml") +
                                      ":2:1: unknown key 'hz' in a scene; it is a key of "
                                      "[world] or a spring");
}

TEST_F(DeckFiles, AreDistinguishedFromScenes) {
    write("deck.toml", "title = 'T'\n[[slide]]\n");
    write("scene.toml", kFall);
    write("broken.toml", "[[slide\n");
    write("slides.toml", "title = 'T'\n[[slides]]\ntitle = 'x'\n");
    write("talk.toml", "title = 'T'\nsubtitle = 'S'\n[opening]\nscene = 'stack'\n");
    write("empty.toml", "");
    for (const char* name : {"deck.toml", "slides.toml", "talk.toml", "empty.toml"})
        EXPECT_TRUE(isDeckFile(path(name))) << name;
    EXPECT_EQ(error("slides.toml"), path("slides.toml") +
                                        ":1:1: the deck has no slide; write a "
                                        "[[slide]]");
    for (const std::string& name : {path("scene.toml"), path("broken.toml"), path("none.toml"),
                                    std::string("stack"), folder_.path().string()})
        EXPECT_FALSE(isDeckFile(name)) << name;
}

TEST_F(DeckFiles, TakeSectionsAndSayOtherwiseWhereTheyWish) {
    write("a.toml", kFall + kSections + kExpect);
    write("deck.toml",
          "title = 'T'\n[[slide]]\nscene = 'a.toml'\nsection = 'down'\n"
          "[[slide]]\nscene = 'a.toml'\nsection = 'down'\ntitle = 'Mine'\nslow = 2\nloop = false\n"
          "plot = []\ntable = []\nposter = 1.5\n"
          "[[slide]]\nscene = 'a.toml'\nsection = 'up'\n[[slide]]\nscene = 'a.toml'\n"
          "section = 'end'\n");
    const Deck read = loadDeck(folder_ / "deck.toml");
    const Slide& down = read.slides[1];
    EXPECT_EQ(down.title + "|" + down.text + "|" + down.notes + "|" + down.poster,
              "It _falls_|at @{body.ball.speed}|n|first");
    EXPECT_EQ(down.from, 1.0);
    EXPECT_EQ(down.until, 2.0);
    EXPECT_EQ(down.slow, 0.5);
    EXPECT_TRUE(down.pause && down.loop && down.expectations);
    EXPECT_EQ(down.plots, List{"energy"});
    EXPECT_EQ(down.formulas, (List{"a", "b"}));
    const Slide& mine = read.slides[2];
    EXPECT_EQ(mine.title + "|" + mine.text + "|" + mine.poster, "Mine|at @{body.ball.speed}|1.5");
    EXPECT_EQ(mine.slow, 2.0);
    EXPECT_FALSE(mine.loop || mine.expectations);
    EXPECT_TRUE(mine.plots.empty());
    EXPECT_EQ(read.slides[3].caption, "a \\* b \\* c \\$");
    EXPECT_EQ(read.slides[3].until, 1.0);
    EXPECT_FALSE(read.slides[4].until);
}

TEST_F(DeckFiles, CaptionsOfSectionsKeepTheirFormulas) {
    write("a.toml", kFall + "[[section]]\nname = 'up'\ncaption = 'so *much*: $v^2$ and $w_1 = 2$, \\$5'\n");
    write("deck.toml", "title = 'T'\n[[slide]]\nscene = 'a.toml'\nsection = 'up'\n");
    EXPECT_EQ(loadDeck(folder_ / "deck.toml").slides[1].caption, "so \\*much\\*: $v^2$ and $w_1 = 2$, \\$5");
}

TEST_F(DeckFiles, ShowNoTableOfNothing) {
    write("a.toml", kFall + kSections);
    write("deck.toml", "title = 'T'\n[[slide]]\nscene = 'a.toml'\ntable = ['expectations']\n");
    EXPECT_EQ(error("deck.toml"),
              path("deck.toml") + ":5:10: 'a' has no [[expect]]; leave out expectations");
    write("deck.toml", "title = 'T'\n[[slide]]\nscene = 'a.toml'\nsection = 'down'\n");
    EXPECT_FALSE(loadDeck(folder_ / "deck.toml").slides[1].expectations);
}

TEST_F(DeckFiles, TellOfASectionInTheFileOfItsScene) {
    write("a.toml", kFall + "[[section]]\nname = 'one'\nformula = ['a', 'b^c^d']\n");
    write("deck.toml", "title = 'T'\n[[slide]]\nscene = 'a.toml'\nsection = 'one'\n");
    EXPECT_EQ(error("deck.toml"), path("a.toml") + ":15:21: formula: Double superscript");
    Options options;
    options.scenes = {path("a.toml")};
    options.quiet = true;
    try {
        deckOfScenes(options);
        ADD_FAILURE() << "taken";
    } catch (const SceneError& found) {
        EXPECT_EQ(found.lines(), List{path("a.toml") + ":15:21: formula: Double superscript"});
    }
}

TEST_F(DeckFiles, MayBeMadeOfAScene) {
    write("a.toml", kFall + kSections + kExpect);
    Options options;
    options.scenes = {path("a.toml")};
    options.overrides = {"world.hz=120"};
    options.quiet = true;
    const Deck read = deckOfScenes(options);
    EXPECT_EQ(read.name, "a");
    EXPECT_EQ(read.title, "fall: a ball");
    EXPECT_EQ(read.files, std::vector<std::filesystem::path>{path("a.toml")});
    ASSERT_EQ(read.slides.size(), 4u);
    EXPECT_EQ(read.slides[0].title, "Fall: up");
    EXPECT_EQ(read.slides[0].id, "01-fall-up");
    EXPECT_EQ(read.slides[0].runs.settings, List{"world.hz=120"});
    EXPECT_EQ(read.slides[1].title, "It _falls_");
    EXPECT_EQ(read.slides[1].until, 2.0);
    EXPECT_EQ(read.slides[2].from, 2.0);
    const Slide& numbers = read.slides[3];
    EXPECT_EQ(numbers.title, "Fall in numbers");
    EXPECT_EQ(numbers.exhibit, Exhibit::none);
    EXPECT_TRUE(numbers.expectations);
    EXPECT_EQ(numbers.plots, (List{"energy", "penetration"}));
}

TEST_F(DeckFiles, MadeOfASceneEndWithIt) {
    write("a.toml", kFall + kSections);
    Options options;
    options.scenes = {path("a.toml")};
    options.seconds = 1.5;
    options.quiet = true;
    const Deck read = deckOfScenes(options);
    ASSERT_EQ(read.slides.size(), 3u);
    EXPECT_EQ(read.slides[0].until, 1.0);
    EXPECT_EQ(read.slides[1].title, "It _falls_");
    EXPECT_EQ(read.slides[1].until, 1.5);
    EXPECT_EQ(read.slides[2].until, 1.5);
    EXPECT_EQ(read.slides[1].runs.settings, List{});
}

TEST_F(DeckFiles, MadeOfSeveralScenesBeginWithWhatTheyAre) {
    write("a.toml", kFall);
    Options options;
    options.scenes = {path("a.toml"), "pendulum", "stack"};
    options.theme = "dark";
    options.quiet = true;
    const Deck read = deckOfScenes(options);
    EXPECT_EQ(read.title, "Fall, Pendulum and " + read.slides.back().title.substr(
                                                      0, read.slides.back().title.rfind(" in ")));
    EXPECT_EQ(read.theme, "dark");
    ASSERT_TRUE(read.slides[0].opening);
    EXPECT_TRUE(read.slides[0].text.starts_with(
        "- **Fall**: It \\*falls\\*\n- **Pendulum**: The period of a rod released from level, "
        "against the elliptic integral\n- **"))
        << read.slides[0].text;
    EXPECT_EQ(read.slides[1].title, "fall: a ball");
    EXPECT_EQ(read.slides[1].caption, "It \\*falls\\*");
    EXPECT_EQ(read.slides[1].exhibit, Exhibit::film);
}

TEST(Deck, OfEveryBuiltInSceneCanBeMade) {
    Options options;
    options.quiet = true;
    options.scenes = {"stack", "chain", "ferry", "ragdoll", "trampoline"};
    EXPECT_GE(deckOfScenes(options).slides.size(), 11u);
}

}  // namespace
}  // namespace demos::test
