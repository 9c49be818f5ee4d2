// A talk in a browser: keys, films frame by frame, the speaker's window, print; no requests.
#include <algorithm>
#include <cstdlib>

#include "demos/slides/deck_files.h"
#include "render/encode/ffmpeg.h"
#include "tests/pages/driver.h"
#include "tests/support/planted_deck.h"

namespace {

using namespace demos;
using support::driver;
using support::Opened;
using support::told;

/// Helpers for drivers: which slide is shown, and a film's frame by its grey level. A film says that
/// it has moved before its picture has: `frame` waits, but not for ever, for the frame of its time.
const std::string kEyes = R"js(
  const at = () => document.querySelector(".leaf.seen .number").textContent.split(" ")[0];
  const film = () => document.querySelector(".leaf.seen video");
  const until = (target, event) => new Promise((go) => target.addEventListener(event, go, { once: true }));
  const loaded = async (video) => { while (video.readyState < 2 || video.seeking) await breath(); };
  const grey = async () => {
    await loaded(film());
    const canvas = document.createElement("canvas");
    canvas.width = 64; canvas.height = 36;
    const context = canvas.getContext("2d");
    context.drawImage(film(), 0, 0, 64, 36);
    return context.getImageData(32, 18, 1, 1).data[0];
  };
  const frame = async () => {
    const shown = async () => Math.round((await grey() - 30) / 8);
    const { fps, frames } = film().dataset;
    const due = () => Math.min(Math.floor(film().currentTime * fps + 1e-4), frames - 1);
    for (let i = 0; i < 2000 && await shown() !== due(); ++i) await breath();
    return shown();
  };
)js";

class SlidesInBrowser : public testing::Test {
protected:
    void SetUp() override {
        if (!render::haveFfmpeg()) GTEST_SKIP() << "no ffmpeg to make a film: install ffmpeg";
        ASSERT_TRUE(support::writePlantedFilm(folder_ / "film.mp4"));
        deck_ = support::plantedDeck(folder_ / "film.mp4");
    }
    Opened open(const std::string& hash, const std::string& steps) const {
        return browser_.open(slidesPage(deck_), hash, driver(kEyes + steps));
    }
    static void expectQuiet(const Opened& opened) {
        EXPECT_TRUE(opened.console.empty()) << opened.console.front();
        EXPECT_TRUE(opened.requests.empty()) << opened.requests.front();
    }

    support::TemporaryFolder folder_;
    support::Browser browser_{folder_};
    MadeDeck deck_;
};

TEST_F(SlidesInBrowser, GoesBySlidesByEveryKey) {
    const Opened opened = open("", R"js(
  for (const name of ["ArrowRight", "ArrowDown", "End", "ArrowRight", "ArrowLeft", "ArrowUp",
                      "PageUp", "Home", "PageUp", "3", "Enter", "9", "Enter"]) {
    await key(name);
    tell(at());
  }
  tell(location.hash);
  await link("2"); tell(at());
  await link("x"); tell(at());
)js");
    EXPECT_EQ(told(opened), "[2][3][4][4][3][2][1][1][1][1][3][3][4][#4][2][1]");
    expectQuiet(opened);
}

TEST_F(SlidesInBrowser, ItemsAppearOneAfterTheOther) {
    deck_.slides[3].slide.text = "First:\n\n- one\n- two\n";
    deck_.slides[3].slide.reveal = true;
    const Opened opened = open("3", R"js(
  const items = () => [...document.querySelectorAll(".leaf.seen li")]
    .filter((item) => getComputedStyle(item).visibility === "visible").length;
  const where = () => tell(`${at()} ${items()}`);
  await key("ArrowRight"); where();
  for (const name of ["PageDown", " ", "ArrowRight", "ArrowLeft", "ArrowUp", "PageUp"]) {
    await key(name); where();
  }
  await key("End"); where();
  await key("o"); where();
)js");
    EXPECT_EQ(told(opened), "[4 0][4 1][4 2][4 2][4 1][4 0][3 2][4 0][4 2]");
    expectQuiet(opened);
}

TEST_F(SlidesInBrowser, AFilmThatWaitsPlaysWhenAskedAndThenTheTalkGoesOn) {
    const Opened opened = open("2", R"js(
  const waits = () => document.querySelector(".leaf.seen .waits") !== null;
  tell(`${await frame()} ${waits()} ${film().paused}`);
  await key("PageDown");
  tell(`${at()} ${waits()} ${film().paused}`);
  await key("PageDown");
  tell(at());
  await key("ArrowLeft");
  tell(`${await frame()} ${waits()}`);
  await key(" ");
  tell(`${at()} ${film().paused}`);
  await key(" ");
  tell(`${at()} ${film().paused}`);
)js");
    EXPECT_EQ(told(opened), "[0 true true][2 false false][3][0 true][2 false][2 true]");
    expectQuiet(opened);
}

TEST_F(SlidesInBrowser, OthersPlayAtOnceAndLoopAsTheSectionSays) {
    deck_.slides[1].slide.pause = false;
    const Opened opened = open("2", R"js(
  tell(`${film().paused} ${film().loop}`);
  await key("ArrowRight");
  tell(`${film().paused} ${film().loop}`);
  tell(document.querySelectorAll("video")[0].paused);
)js");
    EXPECT_EQ(told(opened), "[false false][false true][true]");
    expectQuiet(opened);
}

/// Every frame forward and back, and the run's time, which passes at a third of the film's speed.
TEST_F(SlidesInBrowser, StepsFrameByFrameExactly) {
    const Opened opened = open("2", R"js(
  await frame();
  const says = () => byId("says").textContent;
  const seen = [];
  const step = async (name) => { await key(name); seen.push(await frame()); };
  for (let i = 0; i < 25; ++i) await step(".");
  tell(seen.join(" "));
  tell(says());
  seen.length = 0;
  for (let i = 0; i < 25; ++i) await step(",");
  tell(seen.join(" "));
  await step("."); await step(".");
  tell(says());
  await step("0");
  tell(`${seen.at(-1)} ${says()} ${film().paused}`);
)js");
    EXPECT_EQ(told(opened),
              "[1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 23 23]"
              "[frame 24 of 24, t = 2.230 s]"
              "[22 21 20 19 18 17 16 15 14 13 12 11 10 9 8 7 6 5 4 3 2 1 0 0 0]"
              "[frame 3 of 24, t = 2.020 s][0 frame 1 of 24, t = 2.000 s true]");
    expectQuiet(opened);
}

/// Virtual time runs ahead of a film, so the film is moved near its end.
TEST_F(SlidesInBrowser, HoldsItsLastFrameAndTheSpaceBarGoesOn) {
    const Opened opened = open("2", R"js(
  await frame();
  film().currentTime = film().duration;
  tell(await frame());
  await key(" ");
  tell(at());
)js");
    EXPECT_EQ(told(opened), "[23][3]");
}

TEST_F(SlidesInBrowser, SpeedNotesBlackOverviewAndHelp) {
    const Opened opened = open("3", R"js(
  await key("["); await key("["); tell(film().playbackRate);
  await key("]"); await key("]"); await key("]"); tell(film().playbackRate);
  await link("1");
  await key("n"); tell(byId("notes").textContent.trim());
  await link("3"); tell(byId("notes").textContent.trim());
  await key("n"); tell(byId("notes").hidden);
  await key("b"); tell(byId("black").hidden); await key("b"); tell(byId("black").hidden);
  await key("o"); tell(document.body.classList.contains("overview"));
  await key("ArrowLeft"); await key("Enter");
  tell(`${at()} ${document.body.classList.contains("overview")}`);
  await key("?"); tell(`${byId("help").open} ${byId("help").querySelectorAll("dt").length}`);
)js");
    EXPECT_EQ(told(opened),
              "[0.25][1.5][Be calm.][no notes][true][false][true][true][2 false][true 15]");
    expectQuiet(opened);
}

TEST_F(SlidesInBrowser, ClicksGoBackOnTheLeftAndOnElsewhere) {
    const Opened opened = open("3", R"js(
  const click = async (x) => {
    byId("room").dispatchEvent(new MouseEvent("click", { clientX: x, clientY: 20, bubbles: true }));
    await rest();
  };
  await click(innerWidth - 10); tell(at());
  await click(10); tell(at());
  await click(10); tell(at());
)js");
    EXPECT_EQ(told(opened), "[4][3][2]");
}

/// The driver runs in both windows. Each file is its own origin: they can only post messages.
TEST_F(SlidesInBrowser, TheSpeakersWindowFollowsAndLeads) {
    const Opened opened = open("1", R"js(
  if (location.hash === "#speaker") {
    const heard = async (slide) => {
      while (document.body.dataset.heard !== slide) await until(window, "message");
    };
    const press = (name) =>
      document.body.dispatchEvent(new KeyboardEvent("keydown", { key: name, bubbles: true }));
    await heard("1");
    const next = byId("next").textContent.includes("It waits");
    const words = `${next} ${byId("notes").textContent.trim()} ${byId("elapsed").textContent}`;
    window.opener.postMessage({ told: words }, "*");
    press("ArrowRight");
    await heard("2");
    press("ArrowRight");
    await heard("3");
    window.opener.postMessage({ told: `${at()} done` }, "*");
    return;
  }
  const letters = [];
  window.addEventListener("message", (event) => { if (event.data.told) letters.push(event.data.told); });
  await key("s");
  await comes(() => letters.length === 2);
  tell(letters.join("; "));
  tell(at());
)js");
    EXPECT_EQ(told(opened), "[true Be calm. 0:00; 3 done][3]");
    expectQuiet(opened);
}

TEST_F(SlidesInBrowser, SomebodyElsesLettersAreNotRead) {
    const Opened opened = open("1", R"js(
  window.postMessage({ impulse: "speaker", key: "End" }, "*");
  await rest(); await rest();
  tell(at());
)js");
    EXPECT_EQ(told(opened), "[1]");
}

TEST_F(SlidesInBrowser, WordsAreFittedIntoTheirSlide) {
    std::string& text = deck_.slides[3].slide.text;
    for (int i = 0; i < 90; ++i) text += " and so many words more";
    deck_.slides[2].slide.formulas = {
        "J = \\begin{bmatrix} -n^T & -(r_1 \\times n)^T & n^T & (r_2 \\times n)^T & a & b & c "
        "\\end{bmatrix}"};
    const Opened opened = open("4", R"js(
  const inside = (slide) => [...slide.querySelectorAll("math, pre, table, p")].every((part) => {
    const own = part.getBoundingClientRect(), all = slide.getBoundingClientRect();
    return own.left >= all.left && own.right <= all.right + 1 && own.bottom <= all.bottom + 1;
  });
  const slides = [...document.querySelectorAll("#stage .slide")];
  tell(slides.map(inside).join());
  tell(slides[3].style.getPropertyValue("--size") < 0.8);
  tell(slides[2].classList.contains("wide"));
)js");
    EXPECT_EQ(told(opened), "[true,true,true,true][true][true]");
}

TEST_F(SlidesInBrowser, WordsThatFitAtNoSizeBeginBelowTheTitleAndSaySo) {
    for (int i = 0; i < 60; ++i) deck_.slides[2].slide.text += "\n\nAnother paragraph.";
    const Opened opened = open("3", R"js(
  const slides = [...document.querySelectorAll("#stage .slide")];
  tell(slides.map((slide) => slide.classList.contains("overfull")).join());
  const box = (name) => slides[2].querySelector(name).getBoundingClientRect();
  tell(box(".text").top >= box("h2").bottom);
  tell(getComputedStyle(slides[2], "::after").content);
)js");
    EXPECT_EQ(told(opened), "[false,false,true,false][true][\"too much for one slide\"]");
    ASSERT_EQ(opened.console.size(), 1u);
    EXPECT_NE(opened.console.front().find("too much for one slide: 3: It loops"),
              std::string::npos);
}

TEST_F(SlidesInBrowser, LongLinesOfCodeAreSetSmallerAndThenBroken) {
    const std::string longLine(90, 'x');
    deck_.slides[3].slide.code = longLine;
    deck_.slides[2].slide.text = "```\nif (a)\n  " + longLine + longLine + "\n```";
    const Opened opened = open("3", R"js(
  const blocks = [...document.querySelectorAll("#stage pre")];
  tell(blocks.map((pre) => pre.scrollWidth <= pre.clientWidth).join());
  tell(blocks.map((pre) => pre.querySelectorAll(".line").length).join());
  tell(blocks[1].style.getPropertyValue("--tight") < 1);
  tell(blocks[0].querySelector("code").innerText.trim().split("\n").length);
  tell(getComputedStyle(blocks[0].querySelector("code")).backgroundColor);
)js");
    EXPECT_EQ(told(opened), "[true,true][2,0][true][2][rgba(0, 0, 0, 0)]");
    expectQuiet(opened);
}

TEST_F(SlidesInBrowser, NineteenPicturesAreAllSeenAndTheLastRowStandsInTheMiddle) {
    while (deck_.slides[2].pictures.size() < 18)
        deck_.slides[2].pictures.push_back(support::plantedDeckPicture(64, 36, 200));
    const Opened opened = open("3", R"js(
  const slide = document.querySelectorAll("#stage .slide")[2].getBoundingClientRect();
  const boxes = [...document.querySelectorAll("#stage .seen .frame")].map((frame) => frame.getBoundingClientRect());
  tell(boxes.length);
  tell(boxes.every((box) => box.width > 0.05 * slide.width && box.left >= slide.left &&
    box.right <= slide.right && box.top >= slide.top && box.bottom <= slide.bottom));
  const middle = (some) => (Math.min(...some.map((box) => box.left)) + Math.max(...some.map((box) => box.right))) / 2;
  const last = boxes.filter((box) => box.bottom > boxes.at(-1).bottom - 2);
  tell(last.length < 7 && Math.abs(middle(last) - middle(boxes)) < 2);
)js");
    EXPECT_EQ(told(opened), "[19][true][true]");
    expectQuiet(opened);
}

TEST_F(SlidesInBrowser, AFolderPlaysItsFilmsToo) {
    writeSlidesFolder(deck_, folder_ / "talk");
    // The page is opened next to media/, like index.html.
    std::filesystem::rename(folder_ / "talk/media", folder_ / "media");
    const Opened opened =
        browser_.open(support::contentOf(folder_ / "talk/index.html"), "2", driver(kEyes + R"js(
  await loaded(film());
  tell(`${film().readyState >= 2} ${film().duration.toFixed(1)}`);
  tell([...document.images].every((image) => image.naturalWidth > 0));
)js"));
    EXPECT_EQ(told(opened), "[true 0.8][true]");
    expectQuiet(opened);
}

std::string pageSizes(const std::string& pdf) {
    std::string sizes;
    for (std::size_t at = pdf.find("/MediaBox ["); at != pdf.npos;
         at = pdf.find("/MediaBox [", at + 1))
        sizes += pdf.substr(at + 10, pdf.find(']', at) - at - 9);
    return sizes;
}

TEST_F(SlidesInBrowser, PrintsAPosterASlide) {
    writeSlidesPdf(deck_, folder_ / "deep/talk.pdf", render::Existing::kept);
    const std::string pdf = support::contentOf(folder_ / "deep/talk.pdf");
    EXPECT_EQ(pageSizes(pdf), "[0 0 960 540][0 0 960 540][0 0 960 540][0 0 960 540]");  // pt
}

}  // namespace
