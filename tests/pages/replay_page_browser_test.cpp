// replay.html in a browser: bodies where the camera sees them, arrows, curves, keys, no requests.
#include "tests/pages/replay_in_browser.h"

namespace {

using namespace demos;
using support::countOf;
using support::driver;
using support::isBlue;
using support::isRed;
using support::Opened;
using support::ReplayInBrowser;
using support::still;
using support::told;

TEST_F(ReplayInBrowser, DrawsBodiesWhereTheCameraHasThem) {
    for (const int frame : {0, 30, 60}) {
        const Opened opened = open("t=" + std::to_string(frame / 30.0), still());
        for (const int other : {0, 30, 60})
            EXPECT_EQ(isRed(colorOf(opened, placeAt(other))), other == frame) << frame << other;
        EXPECT_TRUE(isBlue(colorOf(opened, {0, 3, 0})));
        EXPECT_TRUE(isBlue(colorOf(opened, {0.4, 3, 0})));
        EXPECT_FALSE(isBlue(colorOf(opened, {0.6, 3, 0})));
        EXPECT_TRUE(opened.console.empty()) << opened.console.front();
        EXPECT_TRUE(opened.requests.empty()) << opened.requests.front();
    }
}

/// Here the page's height is not fixed: the window becomes higher after the last picture.
TEST_F(ReplayInBrowser, ABallStaysRoundInAWindowThatChanges) {
    const render::Image shot = open("t=1&curves=0").screenshot;
    int left = shot.width, right = 0, top = shot.height, bottom = 0;
    for (int y = 0; y < shot.height / 2; ++y)  // below are blue buttons
        for (int x = 0; x < shot.width; ++x) {
            const std::uint8_t* pixel = shot.at(x, y);
            if (!isBlue({pixel[0], pixel[1], pixel[2]})) continue;
            left = std::min(left, x), right = std::max(right, x);
            top = std::min(top, y), bottom = std::max(bottom, y);
        }
    ASSERT_GT(right - left, 30);
    EXPECT_NEAR(bottom - top, right - left, 0.08 * (right - left));  // it is off the middle
}

/// Grey, and darker where the sun does not reach it: half a metre above the ground, in the sun's
/// way from (0.45, 0.75, 0.5), the ball's shadow is 0.6 m to the left and 2/3 m behind it.
TEST_F(ReplayInBrowser, BodiesThrowShadows) {
    const Opened opened = open("t=0", still());
    const std::vector<int> shade = colorOf(opened, {-3.6, -1, -0.67}),
                           light = colorOf(opened, {-2.0, -1, 0.9});
    EXPECT_LT(shade[0] + 30, light[0]);
    EXPECT_LT(std::abs(light[0] - light[2]), 25);
}

/// A strong line is 5 m to the right of the point that the camera looks at.
TEST_F(ReplayInBrowser, TheGridFadesAwayFromTheSubject) {
    const Vec3 onLine(5, -1, -2);
    const int dark = colorOf(open("t=0", still()), onLine)[0];
    recording_.look.gridReach = 0.5f;
    EXPECT_GT(colorOf(open("t=0", still()), onLine)[0], dark + 10);
}

TEST_F(ReplayInBrowser, ArrowsAndDotsComeByLinkAndByKey) {
    const Opened without = open("t=1&show=", still());
    const Opened with = open("t=1&show=contacts,impulses", still());
    const Opened pressed = open("t=1&show=", still("await key('i'); await key('c');"));
    const Opened before = open("t=0&show=contacts,impulses", still());
    // The arrow's red and the dot's pink; the legend contains both too.
    for (const Opened* opened : {&with, &pressed}) {
        EXPECT_GT(countOf(*opened, 0xd6, 0x27, 0x28), countOf(before, 0xd6, 0x27, 0x28) + 100);
        EXPECT_GT(countOf(*opened, 0xe0, 0x21, 0x8a), 30);
        EXPECT_NE(opened->dom.find("impulse 1 N s"), std::string::npos);
    }
    EXPECT_LT(countOf(without, 0xd6, 0x27, 0x28), 20);  // the ball's edge
    EXPECT_EQ(countOf(without, 0xe0, 0x21, 0x8a), 0);
    EXPECT_NE(before.dom.find("0 contacts that push"), std::string::npos);
}

TEST_F(ReplayInBrowser, DrawsItsCurves) {
    const Opened opened = open("t=1", still());
    EXPECT_GT(countOf(opened, 0xb3, 0x55, 0x05), 500);  // kinetic energy, penetration
    EXPECT_GT(countOf(opened, 0x2b, 0x6f, 0xb8), 200);  // potential energy
    const Opened hidden = open("t=1&curves=0", still());
    EXPECT_LT(countOf(hidden, 0x2b, 0x6f, 0xb8), 20);
}

TEST_F(ReplayInBrowser, StepsScrubsAndPlays) {
    const Opened opened = open("t=1", driver(R"js(
  const now = () => tell(byId("now").textContent);
  now();
  await key("ArrowRight"); now();
  await key("ArrowLeft", true); now();
  tell(byId("caption").textContent);
  await key("PageDown"); now();
  tell(byId("caption").textContent);
  await key("End"); now();
  byId("time").value = 15;
  byId("time").dispatchEvent(new Event("input"));
  await rest(); now();
  await key(" ");
  while (byId("now").textContent === "0.500 s") await rest();
  await key(" ");
  const paused = byId("now").textContent;
  await new Promise((go) => setTimeout(go, 500));
  tell(byId("now").textContent === paused);
  await link("t=1.5"); now();
  tell(document.querySelectorAll("#marks button").length);
)js"));
    EXPECT_EQ(told(opened),
              "[1.000 s][1.033 s][0.700 s][It starts][1.000 s][Half way][2.000 s][0.500 s][true]"
              "[1.500 s][2]");
    EXPECT_TRUE(opened.console.empty()) << opened.console.front();
}

TEST_F(ReplayInBrowser, NamesMeasuresAndFollowsTheBodyUnderThePointer) {
    const Opened opened = open("t=1", driver(R"js(
  const picture = byId("picture"), r = picture.getBoundingClientRect();
  const point = (type, x, y) => picture.dispatchEvent(new PointerEvent(type, {
    clientX: r.left + x, clientY: r.top + y, pointerId: 1, pointerType: "mouse", bubbles: true }));
  picture.setPointerCapture = () => {};
  const tall = r.height / 2 / Math.tan(35 * Math.PI / 360) / Math.hypot(14, 1);  // pixels a metre
  const blue = [r.width / 2, r.height / 2 - 2 * tall];
  point("pointermove", ...blue); tell(byId("hover").textContent);
  point("pointermove", 5, 5); tell(byId("hover").hidden);
  point("pointerdown", ...blue); point("pointerup", ...blue);
  await rest();
  tell(byId("info").textContent);
  await key("f");
  await new Promise((go) => setTimeout(go, 300));
  const asked = new URLSearchParams(location.hash.slice(1));
  tell(asked.get("body") + asked.get("follow"));
  tell(asked.get("camera").split(",").slice(3, 6).join());
  await key("r");
  await new Promise((go) => setTimeout(go, 300));
  tell(location.hash.includes("camera"));
  const hostile = "<img src=http://127.0.0.1:9/name.png>";
  await link("t=1&show=names&body=" + encodeURIComponent(hostile));
  tell(byId("info").querySelector("h2").textContent.slice(0, 8));
  tell(byId("labels").children.length);
)js"));
    EXPECT_EQ(told(opened),
              "[ball1][true][ball1position0.000, 3.000, 0.000 mspeed0.000 m/smass2 kg][ball11]"
              "[0,3,0][false][&lt;img src][2]");
    EXPECT_TRUE(opened.console.empty()) << opened.console.front();
    EXPECT_TRUE(opened.requests.empty()) << opened.requests.front();
}

TEST_F(ReplayInBrowser, TextsStandOutFromWhatIsUnderThem) {
    EXPECT_EQ(told(open("t=1&show=contacts", driver(support::kTellFaintTexts))), "[][][true]");
}

/// A narrow window, as on a phone.
TEST_F(ReplayInBrowser, AllControlsAreWithinANarrowPage) {
    const Opened opened = open("t=1", driver(R"js(
  const controls = [...document.querySelectorAll("#bar button, #bar select, #bar input, #curves")];
  tell(controls.filter((one) => one.getBoundingClientRect().right > 320).length);
  tell(controls.length > 12);
)js"),
                               support::Window{320, 700});
    EXPECT_EQ(told(opened), "[0][true]");
}

/// More values than a function can take as arguments.
TEST_F(ReplayInBrowser, ALongRunIsShown) {
    const RecordedFrame last = recording_.frames.back();
    recording_.frames.resize(45'000, last);
    const Opened opened = open("t=1400", driver("tell(byId('now').textContent);"));
    EXPECT_EQ(told(opened), "[1400.000 s]");
    EXPECT_TRUE(opened.console.empty()) << opened.console.front();
}

TEST_F(ReplayInBrowser, ACameraThatSeesNothingIsNotTaken) {
    const Opened opened = open("t=1&camera=0,0,0,0,0,0,0", still());
    EXPECT_TRUE(isRed(colorOf(opened, placeAt(30))));
}

TEST_F(ReplayInBrowser, HasTheScenesTitleAndNoMinusZero) {
    recording_.title = "Two balls";
    EXPECT_NE(open("t=1").dom.find("<h1 id=\"title\">Two balls</h1>"), std::string::npos);
    for (RecordedFrame& frame : recording_.frames) frame.bodies[1].pose.position.x() = -1e-5;
    const Opened opened =
        open("t=1&body=ball1",
             driver("tell(document.querySelector('#info dd').textContent); tell(document.title);"));
    EXPECT_EQ(told(opened), "[0.000, 3.000, 0.000 m][Two balls \u2013 impulse replay]");
}

/// With contacts the two charts have half of the width each; without, the energy has all of it.
TEST_F(ReplayInBrowser, ARunWithoutContactsHasNoChartOfThem) {
    const std::string click = R"js(
  const chart = byId("curves"), r = chart.getBoundingClientRect();
  chart.setPointerCapture = () => {};
  chart.dispatchEvent(new PointerEvent("pointerdown", {
    clientX: r.left + r.width - 13, clientY: r.top + 40, buttons: 1, pointerId: 1 }));
  await rest();
  tell(byId("now").textContent);
  chart.dispatchEvent(new PointerEvent("pointerdown", {
    clientX: r.left + r.width / 2 + 47, clientY: r.top + 40, buttons: 1, pointerId: 1 }));
  await rest();
  tell(byId("now").textContent);
)js";
    EXPECT_EQ(told(open("t=1", driver(click))), "[2.000 s][0.000 s]");
    for (RecordedFrame& frame : recording_.frames) {
        frame.contacts.clear();
        frame.measures.penetration = 0.0;
    }
    EXPECT_EQ(told(open("t=1", driver(click))).substr(0, 12), "[2.000 s][1.");
}

TEST_F(ReplayInBrowser, SaysWhyItShowsNothing) {
    const std::string page = replayPage(recording_).html;
    const std::string without = "HTMLCanvasElement.prototype.getContext = () => null;";
    std::string blind = page;
    blind.insert(blind.rfind("<script>"), "<script>" + without + "</script>");
    const Opened opened = browser_.open(blind, "", "");
    EXPECT_NE(opened.dom.find("has no WebGL 2"), std::string::npos);
    EXPECT_TRUE(opened.console.empty()) << opened.console.front();
}

}  // namespace
