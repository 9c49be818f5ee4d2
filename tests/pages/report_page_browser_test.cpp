// The report in a browser: every mode, the keys, the command, the colours on the screen, no
// network requests.
#include <cmath>

#include "demos/regression/report_page.h"
#include "render/difference.h"
#include "tests/pages/driver.h"
#include "tests/support/planted_report.h"

namespace {

using namespace demos;
using support::Browser;
using support::driver;
using support::Opened;
using support::Rect;
using support::told;
using Kind = PictureVerdict::Kind;
using State = SceneVerdict::State;

constexpr int kPictureWidth = 320, kPictureHeight = 180;  // pixels
constexpr int kLeft = 200, kTop = 40, kSide = 40;         // of the square that differs
constexpr std::uint8_t kGround = 100, kSquare = 220;      // levels

/// Two scenes, "first" with two pictures that differ and physics, "second" without a baseline.
class ReportInBrowser : public testing::Test {
protected:
    ReportInBrowser() {
        render::Image before = support::flatImage(kPictureWidth, kPictureHeight, kGround);
        render::Image after = before;
        support::paintSquare(after, kLeft, kTop, kSide, kSquare);
        const std::string a = support::saved(folder_ / "a.png", before),
                          b = support::saved(folder_ / "b.png", after);
        SceneVerdict first = support::plantedScene("first", State::failed);
        first.title = "<img src=http://127.0.0.1:9/title.png onerror=alert(1)>";
        first.physics.kind = PhysicsVerdict::Kind::changed;
        first.physics.step = 30;
        first.physics.lines = {"step 30: body1 is too low"};
        for (const double time : {0.5, 1.0}) {
            first.pictures.push_back(support::plantedPicture(time, Kind::changed, a, b));
            first.pictures.back().difference = render::compare(before, after);
        }
        SceneVerdict second = support::plantedScene("it's new", State::failed);
        second.physics.kind = PhysicsVerdict::Kind::unknown;
        second.pictures = {support::plantedPicture(2.0, Kind::added, "", b)};
        verdict_.scenes = {first, second};
        trajectories_.resize(1);
        trajectories_[0].baseline = support::fallingBodies(3, 61, 1.0);
        trajectories_[0].actual = support::fallingBodies(3, 61, 1.2);
    }

    std::string page(long bytes = 9'500'000) const {
        return reportPage(verdict_, trajectories_, folder_.path(), bytes);
    }
    Opened open(const std::string& hash, const std::string& driver = "",
                std::optional<support::Window> window = {}) const {
        return browser_.open(page(), hash, driver, window);
    }

    support::TemporaryFolder folder_;
    Browser browser_{folder_, true};
    TestVerdict verdict_;
    std::vector<ReportTrajectories> trajectories_;
};

TEST_F(ReportInBrowser, DrawsEveryModeByLinkAndByKey) {
    const Opened opened = open("", driver(R"js(
  for (let mode = 1; mode <= 9; ++mode) {
    await link(`scene=first&t=1&mode=${mode}`);
    tell(document.body.dataset.drawn);
  }
  await link("scene=first&t=0.5");
  for (const mode of "987654321") await key(mode);
  tell(document.querySelector("#modes .on").textContent + " " + location.hash.includes("mode=1"));
)js"));
    std::string expected;
    for (int mode = 1; mode <= 9; ++mode) expected += "[" + std::to_string(mode) + " first@1]";
    EXPECT_EQ(told(opened), expected + "[1 Side by side true]");
    EXPECT_TRUE(opened.console.empty()) << opened.console.front();
    EXPECT_TRUE(opened.requests.empty()) << opened.requests.front();
}

TEST_F(ReportInBrowser, SaysPhysicsInWordsAndListsByState) {
    const Opened opened = open("", driver(R"js(
  tell([...document.querySelectorAll("#list details")].map((d) => d.dataset.group).join());
  tell(byId("physics").textContent.slice(0, 25));
  tell(document.querySelector("#head .title").textContent.slice(0, 9));
  const words = byId("verdict"), pictures = byId("pictures");
  tell(Boolean(words.compareDocumentPosition(pictures) & Node.DOCUMENT_POSITION_FOLLOWING));
)js"));
    EXPECT_EQ(told(opened), "[Changed,New][step 30: body1 is too low][&lt;img src=][true]");
    EXPECT_TRUE(opened.console.empty()) << opened.console.front();
}

TEST_F(ReportInBrowser, TheCommandGrowsAsOneAccepts) {
    const Opened opened = open("scene=first&t=0.5", driver(R"js(
  const say = () => tell(byId("command").textContent.replace(/--results \S+/, "--results DIR"));
  await key("a"); say();
  await key("p"); say();
  await key("j"); await key("a"); say();
  await key("n"); await key("A", true); say();
  await key("a"); say();
  tell(new URLSearchParams(location.hash.slice(1)).getAll("accept").join());
)js"));
    const std::string command = "[impulse approve --results DIR ";
    EXPECT_EQ(told(opened), command + "first@0.5]" + command + "first@physics first@0.5]" +
                                command + "first]" + command + "first 'it'\\''s new']" + command +
                                "first][first]");
}

TEST_F(ReportInBrowser, ABrokenContractCannotBeAccepted) {
    verdict_.scenes[0].expectations.push_back({"drift below 1 m", 2.0, "m", false, "it stands"});
    verdict_.scenes[1].settings.push_back({"world.hz", "60", "120"});
    const Opened opened = open("scene=first&t=0.5", driver(R"js(
  await key("a"); await key("p"); await key("A", true);
  tell(byId("command").textContent.startsWith("impulse"));
  tell(byId("expectations").open);
  await key("n"); await key("a");  // without a baseline only the whole scene
  tell(byId("command").textContent.replace(/--results \S+/, "--results DIR"));
)js"));
    EXPECT_EQ(told(opened), "[false][true][impulse approve --results DIR 'it'\\''s new']");
}

TEST_F(ReportInBrowser, BlinksByHandAndDrawsBothRuns) {
    const Opened opened = open("scene=first&t=1&mode=3", driver(R"js(
  const middle = () => {
    const canvas = byId("canvas"), zoom = canvas.height / 180;
    const x = canvas.width / 2 + (220 - 160) * zoom, y = 60 * zoom;
    return canvas.getContext("2d").getImageData(Math.round(x), Math.round(y), 1, 1).data[0];
  };
  await key("b");
  const once = middle();
  await key("b");
  tell([once, middle()].sort().join());
  const drawn = byId("film-canvas"), bytes = drawn.getContext("2d")
    .getImageData(0, 0, drawn.width, drawn.height).data;
  let blue = 0, orange = 0;
  for (let i = 0; i < bytes.length; i += 4) {
    if (bytes[i + 3] > 200 && bytes[i] > bytes[i + 2] + 80) ++orange;
    if (bytes[i + 3] > 200 && bytes[i + 2] > bytes[i] + 80) ++blue;
  }
  tell(`${blue > 50} ${orange > 50}`);
)js"));
    EXPECT_EQ(told(opened), "[100,220][true true]");
}

/// "first" has two pictures and physics, "it's new" a picture that only comes with its scene.
TEST_F(ReportInBrowser, CountsThePicturesAndPhysicsThatAreAccepted) {
    const Opened opened = open("scene=first&t=0.5", driver(R"js(
  const say = () => tell(byId("accepted").textContent);
  say();
  await key("a"); say();
  await key("p"); say();
  await key("n"); await key("A", true); say();
  await key("A", true); say();
)js"));
    EXPECT_EQ(told(opened),
              "[0 of 3 pictures and 0 of 1 physics accepted]"
              "[1 of 3 pictures and 0 of 1 physics accepted]"
              "[1 of 3 pictures and 1 of 1 physics accepted]"
              "[2 of 3 pictures and 1 of 1 physics accepted]"
              "[1 of 3 pictures and 1 of 1 physics accepted]");
}

/// The tabs of WAI-ARIA: one of them is in the order of Tab, arrows choose the next and go around.
TEST_F(ReportInBrowser, ModesAreTabs) {
    const Opened opened = open("scene=first&t=1&mode=1", driver(R"js(
  const list = document.querySelector("[role=tablist]");
  const panel = document.querySelector("[role=tabpanel]");
  tell([...list.children].every((one) => one.getAttribute("role") === "tab" &&
    one.getAttribute("aria-controls") === panel.id) && list.children.length);
  const say = () => {
    const chosen = [...list.children].filter((one) => one.getAttribute("aria-selected") === "true");
    const inOrder = [...list.children].filter((one) => one.tabIndex === 0);
    const same = chosen.length === 1 && inOrder.length === 1 && chosen[0] === inOrder[0] &&
      chosen[0] === document.activeElement;
    const named = panel.getAttribute("aria-labelledby") === chosen[0].id;
    tell(same && named ? chosen[0].lastChild.data : "not one");
  };
  list.firstChild.focus();
  const right = "ArrowRight", left = "ArrowLeft";
  for (const key of [right, right, left, "End", right, left, "Home"]) {
    document.activeElement.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
    await rest(); say();
  }
)js"));
    EXPECT_EQ(told(opened),
              "[9][Slider][Blink][Slider][Actual][Side by side][Actual][Side by side]");
}

TEST_F(ReportInBrowser, ThePictureIsSeenWithoutScrolling) {
    for (int i = 0; i < 5; ++i)
        verdict_.scenes[0].expectations.push_back(
            {"drift below 1 m", 2.0, "m", i > 0, "it stands"});
    verdict_.scenes[0].settings.push_back({"world.gravity", "0 -9.81 0", "0 -9.7 0"});
    verdict_.scenes[0].physics.lines = {"step 3", "the bits differ", "largest"};
    const Opened opened = open("scene=first", driver(R"js(
  document.head.append(Object.assign(document.createElement("style"), {
    textContent: "#told { position: fixed; }" }));  // no row of the page
  await comes(() => byId("pictures").querySelector("img").complete);
  tell(byId("scene").scrollTop);
  tell(byId("stage").getBoundingClientRect().bottom <= byId("bar").getBoundingClientRect().top);
  tell(byId("stage").clientHeight >= 300);
  tell(byId("verdict").textContent.includes("1 of 5 expectations failed"));
)js"),
                               support::Window{1400, 900});
    EXPECT_EQ(told(opened), "[0][true][true][true]");
}

TEST_F(ReportInBrowser, ANarrowPageHasOneColumn) {
    const std::string columns = driver(R"js(
  const [list, scene] = ["list", "scene"].map((id) => byId(id).getBoundingClientRect());
  const all = list.width === innerWidth && scene.width === innerWidth;
  tell(scene.bottom <= list.top && all);  // the picture first
  const over = [...document.querySelectorAll("#top, #head, button, .card, #viewer, #film, #bar")]
    .filter((one) => one.checkVisibility() && !one.closest("#pictures"));
  tell(over.filter((one) => one.getBoundingClientRect().right > innerWidth).length);
  tell(over.length > 15 && document.documentElement.scrollWidth <= innerWidth);
)js");
    EXPECT_EQ(told(open("scene=first", columns, support::Window{390, 844})), "[true][0][true]");
    EXPECT_EQ(told(open("scene=first", columns, support::Window{690, 900})), "[true][0][true]");
    EXPECT_EQ(told(open("scene=first", columns, support::Window{710, 900})).substr(0, 7),
              "[false]");
}

TEST_F(ReportInBrowser, TextsStandOutFromWhatIsUnderThem) {
    verdict_.scenes[0].expectations = {{"drift below 1 m", 0.5, "m", true, "it stands"},
                                       {"drift below 1 m", 2.0, "m", false, "it stands"}};
    verdict_.scenes[0].settings.push_back({"world.gravity", "0 -9.81 0", "0 -9.7 0"});
    verdict_.scenes.push_back(support::plantedScene("good", State::passed));
    verdict_.scenes.push_back(support::plantedScene("young", State::added));
    EXPECT_EQ(told(open("scene=first", driver(support::kTellFaintTexts))), "[][][true]");
    EXPECT_EQ(told(open("scene=it%27s+new&accept=it%27s+new", driver(support::kTellFaintTexts))),
              "[][][true]");
    EXPECT_EQ(told(open("scene=young", driver(support::kTellFaintTexts))), "[][][true]");
}

/// Half way the camera turns away from the bodies.
TEST_F(ReportInBrowser, TheFilmIsSeenAsTheCameraGoes) {
    trajectories_[0].camera.keys = {{0.5, {8, 5, 14}, {16, 8, 28}, 35.0, Ease::cut}};
    const Opened opened = open("scene=first", driver(R"js(
  const drawn = () => {
    const canvas = byId("film-canvas");
    const bytes = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
    return bytes.some((byte, i) => i % 4 === 3 && byte > 0);
  };
  const seekTo = (time) => {
    byId("film-time").value = time;
    byId("film-time").dispatchEvent(new Event("input"));
    tell(drawn());
  };
  seekTo(0.4); seekTo(0.6); seekTo(0.4);
)js"));
    EXPECT_EQ(told(opened), "[true][false][true]");
}

TEST_F(ReportInBrowser, GoesToTheWorstWindowTheFirstStepAndThePixel) {
    const Opened opened = open("scene=first&t=1&mode=8&at=210,50", driver(R"js(
  tell([...document.querySelectorAll("#readout code")].map((c) => c.textContent.trim()).join());
  tell(byId("loupe").hidden);
  await key("w");
  tell(location.hash.includes("w=1") + " " + byId("readout").textContent.endsWith("800 %"));
  await key("d");
  tell(byId("film-now").textContent);
  await key(".");
  tell(byId("film-now").textContent);
  await key("?");
  tell(byId("help").open);
)js"));
    EXPECT_EQ(told(opened),
              "[210, 50,100 100 100,220 220 220,+120 +120 +120]"
              "[false][true true][0.500 s, step 30][0.517 s, step 31][true]")
        << told(opened);
}

/// The browser makes its window higher for the screenshot, after the driver has run, so the stage
/// gets a height and a place that do not depend on the window's.
const std::string kStage = driver(R"js(
  byId("stage").style.height = "300px";
  byId("scene").scrollTop = 0;
  await rest();
  const r = byId("canvas").getBoundingClientRect();
  tell(`${r.left} ${r.top} ${r.width} ${r.height}`);
)js");

/// The screen's pixel where a pixel of the picture is shown, with the picture fitted to the stage.
const std::uint8_t* screenAt(const Opened& opened, double x, double y) {
    const Rect stage = support::toldRect(opened);
    const double zoom = std::min(stage.width / kPictureWidth, stage.height / kPictureHeight);
    return opened.screenshot.at(
        static_cast<int>(stage.left + stage.width / 2 + (x - 0.5 * kPictureWidth) * zoom),
        static_cast<int>(stage.top + stage.height / 2 + (y - 0.5 * kPictureHeight) * zoom));
}

constexpr double kInX = kLeft + 0.5 * kSide, kInY = kTop + 0.5 * kSide;  // of the square
constexpr double kOutX = 60, kOutY = 150;

std::vector<int> colorAt(const Opened& opened, double x, double y) {
    const std::uint8_t* pixel = screenAt(opened, x, y);
    return {pixel[0], pixel[1], pixel[2]};
}

TEST_F(ReportInBrowser, TheHeatMapIsBrightWhereTheSquareIs) {
    const Opened opened = open("scene=first&t=1&mode=7", kStage);
    ASSERT_EQ(opened.screenshot.width, 1400);
    // 100 and 220 are L* 42.37 and 87.77; green to blue is 203.3: (45.40 / 203.3)^0.7 = 0.350,
    // which the knee makes 0.350 * 0.95 / 0.4 = 0.831, on the map {254, 202, 143}.
    const std::vector<int> inside = colorAt(opened, kInX, kInY);
    EXPECT_NEAR(inside[0], 254, 2);
    EXPECT_NEAR(inside[1], 202, 2);
    EXPECT_NEAR(inside[2], 143, 2);
    EXPECT_EQ(colorAt(opened, kOutX, kOutY), (std::vector<int>{0, 0, 4}));
    // Its first column is blurred to L* 77.96, 0.701 on the scale, and Sobel's gradient is 0.234:
    // 0.701^(1 - sqrt(0.234 / sqrt 2)) = 0.810, a green of 195; without the edge it would be 143.
    EXPECT_NEAR(colorAt(opened, kLeft + 0.5, kInY)[1], 195, 4);
}

TEST_F(ReportInBrowser, DifferenceAndSignShowTheSquareAlone) {
    const Opened red = open("scene=first&t=1&mode=5", kStage);
    EXPECT_EQ(colorAt(red, kInX, kInY), (std::vector<int>{214, 32, 32}));
    EXPECT_EQ(colorAt(red, kOutX, kOutY), (std::vector<int>{215, 215, 215}));
    const Opened sign = open("scene=first&t=1&mode=6", kStage);
    EXPECT_EQ(colorAt(sign, kInX, kInY), (std::vector<int>{255, 255, 255}));
    EXPECT_EQ(colorAt(sign, kOutX, kOutY), (std::vector<int>{128, 128, 128}));
}

TEST_F(ReportInBrowser, TheSliderHasTheActualOnItsRight) {
    const Opened opened = open("scene=first&t=1&mode=2", kStage);
    EXPECT_EQ(colorAt(opened, kInX, kInY)[0], kSquare);
    const Opened moved = open("scene=first&t=1&mode=2", kStage + R"js(
for (let i = 0; i < 9; ++i)
  document.body.dispatchEvent(new KeyboardEvent("keydown", { key: "]", bubbles: true }));
)js");
    EXPECT_EQ(colorAt(moved, kInX, kInY)[0], kGround);
}

TEST_F(ReportInBrowser, ShowsLinkedPicturesAndSaysSo) {
    const Opened opened = browser_.open(page(0), "scene=first&t=1&mode=9", kStage);
    EXPECT_EQ(colorAt(opened, kInX, kInY)[0], kSquare);
    EXPECT_NE(opened.dom.find("2 pictures are linked, not embedded"), std::string::npos);
    const Opened heat = browser_.open(page(0), "scene=first&t=1&mode=7",
                                      driver("tell(document.body.dataset.drawn);"
                                             "tell(byId('note').hidden);"));
    EXPECT_EQ(told(heat), "[9 first@1][false]");
}

TEST_F(ReportInBrowser, SaysWhatIsMissing) {
    std::filesystem::remove(folder_ / "a.png");
    const Opened opened = open("scene=first&t=1&mode=7", driver("tell(byId('note').textContent);"));
    EXPECT_EQ(told(opened), "[no baseline: nothing to compare with]");
    EXPECT_TRUE(opened.console.empty()) << opened.console.front();
}

const std::string kAsks = "new Image().src = 'http://127.0.0.1:9/asked.png';";

TEST_F(ReportInBrowser, NothingCanBeAskedForAndItWouldBeSeen) {
    const Opened refused = open("", kAsks);
    ASSERT_FALSE(refused.console.empty());
    EXPECT_NE(refused.console.front().find("Content Security Policy"), std::string::npos);
    EXPECT_TRUE(refused.requests.empty()) << refused.requests.front();
    std::string without = page();
    const std::size_t policy = without.find("Content-Security-Policy");
    without.replace(policy, 3, "Non");
    EXPECT_FALSE(browser_.open(without, "", kAsks).requests.empty());
}

}  // namespace
