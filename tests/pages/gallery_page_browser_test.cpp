// The gallery in a browser: its cards, the search, films under the pointer, copied commands, no
// network requests.
#include "demos/gallery/gallery_page.h"
#include "render/encode/ffmpeg.h"
#include "render/encode/video.h"
#include "tests/pages/driver.h"
#include "tests/support/planted_report.h"

namespace {

using namespace demos;
using support::driver;
using support::Opened;
using support::told;

constexpr int kCardWidth = 160, kCardHeight = 90;  // pixels

/// Two stacks and a pendulum; the pendulum's texts try to be markup.
class GalleryInBrowser : public testing::Test {
protected:
    GalleryInBrowser() {
        add("stack", "stacks", "Ten boxes", "They stay");
        add("wall", "stacks", "A wall", "A ball comes");
        add("it's mine", "", "<img src=http://127.0.0.1:9/title.png onerror=alert(1)>",
            "It swings");
        cards_.back().file = "it's mine.toml";
    }

    void add(const std::string& name, const std::string& group, const std::string& title,
             const std::string& purpose) {
        GalleryCard card;
        card.name = name;
        card.group = group;
        card.title = title;
        card.purpose = purpose;
        card.seconds = 2.0;
        card.bodies = 12;
        card.hz = 60;
        card.width = kCardWidth;
        card.height = kCardHeight;
        card.film = card.replay = true;
        cards_.push_back(card);
        support::saved(folder_ / (name + ".png"), support::flatImage(kCardWidth, kCardHeight, 200));
    }

    Opened open(const std::string& hash, const std::string& steps) const {
        return browser_.open(galleryPage(cards_, "llvmpipe", words_, links_), hash, driver(steps));
    }

    support::TemporaryFolder folder_;
    support::Browser browser_{folder_};
    std::vector<GalleryCard> cards_;
    GalleryWords words_;
    std::vector<GalleryLink> links_;
};

/// "[a b]": the cards that are not hidden.
const std::string kTellShown = R"js(
  const shown = () => tell([...document.querySelectorAll(".card")]
    .filter((card) => card.offsetParent !== null).map((card) => card.dataset.scene).join(" "));
)js";

TEST_F(GalleryInBrowser, ShowsACardForEachSceneByGroup) {
    const Opened opened = open("", kTellShown + R"js(
  shown();
  tell([...document.querySelectorAll("section > h2")].map((h) => h.firstChild.data).join(","));
  tell(document.querySelector("#scene-stack .facts").textContent);
  tell([...document.images].every((image) => image.complete && image.naturalWidth === 160));
  tell(document.querySelectorAll("video").length);
  tell([...document.querySelectorAll(".replay")].map((a) => a.getAttribute("href")).join());
  tell(byId("site").hidden);
)js");
    EXPECT_EQ(told(opened),
              "[stack wall it's mine][stacks,your scenes]"
              "[12 bodies2 s60 steps/sstep through it][true][0]"
              "[stack.html,wall.html,it's%20mine.html][true]");
    EXPECT_TRUE(opened.console.empty()) << opened.console.front();
    EXPECT_TRUE(opened.requests.empty()) << opened.requests.front();
}

TEST_F(GalleryInBrowser, SearchKeepsWhatHasEveryWord) {
    const Opened opened = open("q=ball", kTellShown + R"js(
  shown();
  await key("/");
  tell(document.activeElement.id);
  const ask = (text) => {
    byId("search").value = text;
    byId("search").dispatchEvent(new Event("input"));
    shown();
  };
  ask("stacks ten");
  ask("stacks swings");
  tell(byId("nothing").hidden);
  document.activeElement.dispatchEvent(
    new KeyboardEvent("keydown", { key: "Escape", bubbles: true }));
  shown();
)js");
    EXPECT_EQ(told(opened), "[wall][search][stack][][false][stack wall it's mine]");
}

TEST_F(GalleryInBrowser, CommandsAreWordsOfAShell) {
    const Opened opened = open("", R"js(
  for (const name of ["stack", "it's mine"])
    tell([...byId("scene-" + name).querySelectorAll("code")]
      .map((code) => code.textContent).join("|"));
  document.querySelector("#scene-wall .command").click();
  await comes(() => document.querySelector("#scene-wall .copied"));
  tell(byId("told").textContent);
)js");
    EXPECT_EQ(told(opened),
              "[impulse render stack -o stack.mp4|impulse list stack --print|"
              "impulse export stack -o stack.html]"
              "[impulse render 'it'\\''s mine.toml' -o 'it'\\''s mine.mp4'|"
              "impulse sim 'it'\\''s mine.toml'|"
              "impulse export 'it'\\''s mine.toml' -o 'it'\\''s mine.html']"
              "[Copied: impulse render wall -o wall.mp4]");
}

TEST_F(GalleryInBrowser, CommandsHaveTheOptionsOfTheGallery) {
    words_ = {{"--set", "world.gravity=[0, -5, 0]"}, {"--theme", "dark"}};
    const Opened opened = open("", R"js(
  tell([...byId("scene-stack").querySelectorAll("code")].map((code) => code.textContent).join("|"));
)js");
    EXPECT_EQ(told(opened),
              "[impulse render stack --set 'world.gravity=[0, -5, 0]' --theme dark -o stack.mp4|"
              "impulse list stack --print|"
              "impulse export stack --set 'world.gravity=[0, -5, 0]' -o stack.html]");
}

TEST_F(GalleryInBrowser, TextsStandOutFromWhatIsUnderThem) {
    EXPECT_EQ(told(open("", support::kTellFaintTexts)), "[][][true]");
}

TEST_F(GalleryInBrowser, InASiteItLeadsToTheOtherPages) {
    links_ = {{"Start", "../index.html"}, {"Recipes", "../recipes.html"}};
    cards_[0].replay = false;
    const Opened opened = open("", R"js(
  tell([...byId("site").children].map((a) => `${a.textContent} ${a.getAttribute("href")}`).join());
  tell(byId("site").hidden || byId("scene-stack").querySelector(".replay") !== null);
)js");
    EXPECT_EQ(told(opened), "[Start ../index.html,Recipes ../recipes.html][false]");
}

/// A scene may have the name of one of the page's own parts, and a link may contain anything.
TEST_F(GalleryInBrowser, NamesAndLinksAreOnlyThat) {
    for (const char* name : {"nothing", "told", "search", "top"}) add(name, "", "A title", "why");
    const Opened opened = open("q=100%", kTellShown + R"js(
  shown();
  tell(document.body.dataset.ready);
  byId("search").value = "told";
  byId("search").dispatchEvent(new Event("input"));
  shown();
  location.hash = "#%E0";
  await comes(() => location.hash === "#%E0");
  shown();
)js");
    EXPECT_EQ(told(opened), "[][1][told][told]");
    EXPECT_TRUE(opened.console.empty()) << opened.console.front();
}

TEST_F(GalleryInBrowser, SumsAreWrittenAsPeopleDo) {
    cards_.resize(2);
    cards_[0].seconds = 100.0;
    cards_[1].seconds = 19.6;
    EXPECT_NE(open("", "").dom.find("2 scenes \u00b7 24 bodies \u00b7 2 min 0 s of film"),
              std::string::npos);
    cards_.clear();
    const Opened none = open("", "");
    EXPECT_NE(none.dom.find("0 scenes \u00b7 0 bodies<"), std::string::npos);
    EXPECT_NE(none.dom.find("There are no scenes here."), std::string::npos);
}

/// Films play one at a time, from the first frame, and are loaded only when needed.
TEST_F(GalleryInBrowser, FilmsPlayUnderThePointerAndByTap) {
    if (!render::haveFfmpeg()) GTEST_SKIP() << "no ffmpeg";
    for (const char* name : {"stack.mp4", "wall.mp4"}) {
        render::VideoWriter film(folder_ / name, {kCardWidth, kCardHeight, 10, false});
        for (int frame = 0; frame < 20; ++frame)
            film.add(
                support::flatImage(kCardWidth, kCardHeight, static_cast<std::uint8_t>(10 * frame)));
        film.close();
    }
    const Opened opened = open("", R"js(
  const screen = (name) => document.querySelector(`#scene-${name} .screen`);
  const point = (name, what, pointerType = "mouse") =>
    screen(name).dispatchEvent(new PointerEvent(what, { pointerType }));
  const plays = (name) => screen(name).classList.contains("playing");
  point("stack", "pointerenter");
  tell(await comes(() => plays("stack")));
  point("stack", "pointerleave");
  tell(plays("stack") || screen("stack").querySelector("video").currentTime > 0);
  point("stack", "pointerenter");
  point("wall", "pointerenter");
  tell(await comes(() => plays("wall") && !plays("stack")));
  point("wall", "pointerleave");
  point("wall", "pointerenter", "touch");
  screen("wall").click();
  tell(await comes(() => plays("wall")));
  screen("wall").click();
  tell(plays("wall"));
  tell([...document.querySelectorAll("video")].every((film) => film.preload === "none"));
)js");
    EXPECT_EQ(told(opened), "[true][false][true][true][false][true]");
    EXPECT_TRUE(opened.console.empty()) << opened.console.front();
    EXPECT_TRUE(opened.requests.empty()) << opened.requests.front();
}

}  // namespace
