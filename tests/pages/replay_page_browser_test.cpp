// replay.html in a browser: bodies where the camera sees them, arrows, curves, keys, no requests.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "demos/export/replay_page.h"
#include "render/camera.h"
#include "tests/pages/driver.h"
#include "tests/support/planted_recording.h"

namespace {

using namespace demos;
using support::driver;
using support::Opened;
using support::Rect;
using support::told;

constexpr int kFrames = 61;  // two seconds

/// A red ball that moves from x = -3 to 3 (m), pushed to the left by a contact from the second
/// frame on, and a blue one that stays above it.
class ReplayInBrowser : public testing::Test {
protected:
    ReplayInBrowser() {
        recording_ = support::plantedRecording(2, kFrames, 1);
        recording_.bodies[0].name = "<img src=http://127.0.0.1:9/name.png>";
        recording_.bodies[1].color = {0.1f, 0.2f, 0.9f, 1.0f};
        recording_.grounds = {{true, {0, 1, 0}, -1.0f, 0}};
        recording_.sections = {{0.0, "first", "It starts", "", "", 1.0, false, false},
                               {1.0, "second", "Half way", "", "", 1.0, false, false}};
        for (int i = 0; i < kFrames; ++i) {
            RecordedFrame& frame = recording_.frames[i];
            frame.bodies[0] = {{placeAt(i), engine::Quat::Identity()}, {3, 0, 0}, {0, 0, 0}};
            frame.bodies[1] = {{{0, 3, 0}, engine::Quat::Identity()}, {0, 0, 0}, {0, 0, 0}};
            frame.camera.from = {0, 2, 14};
            frame.camera.lookAt = {0, 1, 0};
            for (engine::ContactState& contact : frame.contacts) {
                contact.position = placeAt(i);
                contact.normal = {-1, 0, 0};
                contact.impulse = 2.0;
                contact.friction.setZero();
            }
        }
    }

    static Vec3 placeAt(int frame) { return {-3.0 + 0.1 * frame, 0.0, 0.0}; }

    Opened open(const std::string& hash, const std::string& script = "",
                std::optional<support::Window> window = {}) const {
        return browser_.open(replayPage(recording_).html, hash, script, window);
    }

    /// Each animation frame takes window.frameTakes ms by the page's clock, at first 20.
    Opened openTimed(const std::string& script, std::optional<support::Window> window = {}) const {
        std::string page = replayPage(recording_).html;
        page.insert(page.rfind("<script>"), R"js(<script>
window.frameTakes = 20;
let now = 0;
const solids = WebGL2RenderingContext.prototype;
performance.now = () => now;
// A browser's own frames use up much of the time that it has in a test.
window.nextFrame = (go) => setTimeout(go, 5);
requestAnimationFrame = (draw) => setTimeout(() => draw(now += window.frameTakes), 5);
cancelAnimationFrame = clearTimeout;
window.mostCorners = 0;  // of a solid, since it was last set
const drawn = solids.drawArraysInstanced;
solids.drawArraysInstanced = function (...words) {
  window.mostCorners = Math.max(window.mostCorners, words[2]);
  return drawn.apply(this, words);
};
</script>)js");
        return browser_.open(page, "t=0", script, window);
    }

    /// The first frame's; in a picture narrower than the film, as wide as there.
    render::Camera cameraFor(double aspect) const {
        render::Camera camera = recording_.frames[0].camera;
        const double half = static_cast<double>(camera.fovDegrees) * std::numbers::pi / 360.0;
        const double wider = std::max(1.0, recording_.aspect / aspect) * std::tan(half);
        camera.fovDegrees = static_cast<float>(std::atan(wider) * 360.0 / std::numbers::pi);
        return camera;
    }

    /// The colour on the screen at a position (m) of the world.
    std::vector<int> colorOf(const Opened& opened, const Vec3& place) const {
        const Rect picture = support::toldRect(opened);
        const auto width = static_cast<int>(picture.width),
                   height = static_cast<int>(picture.height);
        const double aspect = picture.width / picture.height;
        const render::View view = render::makeView(cameraFor(aspect), static_cast<float>(aspect));
        const render::Projected at = render::project(view, place.cast<float>(), width, height);
        const std::uint8_t* pixel =
            opened.screenshot.at(static_cast<int>(picture.left + static_cast<double>(at.x)),
                                 static_cast<int>(picture.top + static_cast<double>(at.y)));
        return {pixel[0], pixel[1], pixel[2]};
    }

    support::TemporaryFolder folder_;
    support::Browser browser_{folder_};
    Recording recording_;
};

/// The browser makes its window higher for the screenshot, after the driver has run, so the page
/// gets a height that does not depend on the window's, nor on what the driver reports.
std::string still(const std::string& steps = "") {
    return driver(steps + R"js(
  const style = document.createElement("style");
  style.textContent = "#told { position: fixed; bottom: 0; }";
  document.head.append(style);
  document.documentElement.style.height = document.body.style.height = "800px";
  await rest();
  const r = byId("picture").getBoundingClientRect();
  tell(`${r.left} ${r.top} ${r.width} ${r.height}`);
)js");
}

bool isRed(const std::vector<int>& color) { return color[0] > 100 && color[0] > 3 * color[2]; }
bool isBlue(const std::vector<int>& color) { return color[2] > 100 && color[2] > 3 * color[0]; }

/// The number of pixels of one unlit colour.
int countOf(const Opened& opened, int r, int g, int b) {
    int found = 0;
    for (int y = 0; y < opened.screenshot.height; ++y)
        for (int x = 0; x < opened.screenshot.width; ++x) {
            const std::uint8_t* pixel = opened.screenshot.at(x, y);
            found += std::abs(pixel[0] - r) < 3 && std::abs(pixel[1] - g) < 3 &&
                     std::abs(pixel[2] - b) < 3;
        }
    return found;
}

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

TEST_F(ReplayInBrowser, OrbitsPansAndZooms) {
    const Opened opened = open("t=1", driver(R"js(
  const camera = async () => {
    await new Promise((go) => setTimeout(go, 300));
    return new URLSearchParams(location.hash.slice(1)).get("camera").split(",").map(Number);
  };
  const away = (c) => Math.hypot(c[0] - c[3], c[1] - c[4], c[2] - c[5]);
  await key("d"); await key("w");
  const orbited = await camera();
  tell(orbited[0] > 0.5 && orbited[1] > 2.5 && Math.abs(away(orbited) - Math.hypot(14, 1)) < 0.01);
  await key("D", true);
  const panned = await camera();
  tell(panned[3] > 0.1 && Math.abs(away(panned) - away(orbited)) < 0.01);
  byId("picture").dispatchEvent(new WheelEvent("wheel", { deltaY: -300, cancelable: true }));
  tell(away(await camera()) < 0.7 * away(panned));
  await key("?");
  tell(byId("help").open);
)js"));
    EXPECT_EQ(told(opened), "[true][true][true][true]");
}

/// The shape of a phone: as much is seen to the sides as in the film, where the ball is near the
/// edge.
TEST_F(ReplayInBrowser, ANarrowPictureIsNotCutAtItsSides) {
    for (RecordedFrame& frame : recording_.frames) frame.bodies[0].pose.position.x() = -6.5;
    const Opened opened = open("t=0&curves=0", still(), support::Window{390, 844});
    ASSERT_EQ(opened.screenshot.width, 390);
    EXPECT_LT(support::toldRect(opened).width, support::toldRect(opened).height);
    EXPECT_TRUE(isRed(colorOf(opened, {-6.5, 0, 0})));
    EXPECT_TRUE(isBlue(colorOf(opened, {0, 3, 0})));
}

/// Plays a number of frames, and collects what the page says of them.
const std::string kPlay = R"js(
  const seen = new Set(), picture = byId("picture"), note = byId("left-out");
  const play = async (frames, ms = window.frameTakes) => {
    await key(" ");
    window.frameTakes = ms;
    for (let i = 0; i < frames; ++i) {
      seen.add(`${(picture.width / picture.clientWidth).toFixed(2)} ${note.textContent}`);
      await new Promise((go) => window.nextFrame(go));
    }
    window.frameTakes = 20;
    await key(" ");
  };
)js";

/// Quick frames keep the picture; slow ones make it coarser, take its shadows, then its sides.
TEST_F(ReplayInBrowser, SlowFramesMakeThePictureCoarserAndThenTakeItsShadows) {
    const std::string play = kPlay + "await play(18, 200);", all = "tell([...seen].join());";
    EXPECT_EQ(told(openTimed(driver(kPlay + "await play(18, 40);" + all))), "[1.00 ]");
    const Opened slow = openTimed(driver(play + all));
    EXPECT_EQ(told(slow),
              "[1.00 ,0.50 half resolution, to keep up,"
              "0.50 half resolution and no shadows, to keep up,"
              "0.33 a third of the resolution, fewer sides and no shadows, to keep up]");
    EXPECT_TRUE(slow.console.empty()) << slow.console.front();
    const Opened opened = openTimed(still(play + "await link('t=0');"));
    EXPECT_NEAR(colorOf(opened, {-3.6, -1, -0.67})[0], colorOf(opened, {-2.0, -1, 0.9})[0], 12);
}

/// Fewer sides at the last, and again as many where frames are quick; a picture that was too fine
/// once is tried later the next time.
TEST_F(ReplayInBrowser, QuickFramesMakeThePictureFinerAgain) {
    const Opened opened = openTimed(driver(kPlay + R"js(
  const corners = async () => {
    window.mostCorners = 0;
    await play(1);
    return window.mostCorners;
  };
  const fine = await corners();
  await play(12, 200);
  tell(await corners() < fine / 10);
  await play(48, 24);
  tell(await corners() === fine);
  tell(byId("left-out").textContent);
  await play(9, 200);
  seen.clear();
  await play(48, 24);
  tell([...seen].join());
)js"),
                                    support::Window{300, 400});
    EXPECT_EQ(told(opened),
              "[true][true][half resolution and no shadows, to keep up]"
              "[0.33 a third of the resolution, fewer sides and no shadows, to keep up]");
}

/// Many round solids have fewer sides from the beginning.
TEST_F(ReplayInBrowser, ManyBallsHaveFewerSides) {
    const auto corners = [this] {
        return std::stoi(told(openTimed(driver("tell(window.mostCorners);"))).substr(1));
    };
    const int few = corners();
    recording_ = support::plantedRecording(400, 2, 1);
    const int many = corners();
    EXPECT_GT(few, 2 * many);
    EXPECT_GT(many, 100);
}

/// A camera below its body's height, which falls: it stops above the ground, and is as far below the
/// body as before when that has risen again.
TEST_F(ReplayInBrowser, ACameraThatFollowsStaysAboveTheGround) {
    for (int i = 0; i < kFrames; ++i)
        recording_.frames[i].bodies[1].pose.position.y() = 4.0 - 4.5 * std::sin(0.0523599 * i);
    const Opened opened = open("t=0&body=ball1&follow=1&camera=0,2,9,0,4,0,35", driver(R"js(
  const camera = async (time) => {
    byId("time").value = time;
    byId("time").dispatchEvent(new Event("input"));
    await new Promise((go) => setTimeout(go, 300));
    return new URLSearchParams(location.hash.slice(1)).get("camera").split(",").map(Number);
  };
  const low = await camera(30);
  tell(low[1] > -1 && low[1] < -0.5);
  tell(Math.abs(low[4] + 0.5) < 0.01);
  tell(Math.abs((await camera(60))[1] - 2) < 0.01);
)js"));
    EXPECT_EQ(told(opened), "[true][true][true]");
}

/// The ground is at -1 m. Down and down again, by keys and by zooming out with a view upwards.
TEST_F(ReplayInBrowser, TheCameraStaysAboveTheGround) {
    const std::string camera = R"js(
  const camera = async () => {
    await new Promise((go) => setTimeout(go, 300));
    return new URLSearchParams(location.hash.slice(1)).get("camera").split(",").map(Number);
  };
  const away = (c) => Math.hypot(c[0] - c[3], c[1] - c[4], c[2] - c[5]);
)js";
    const Opened opened = open("t=1", driver(camera + R"js(
  for (let i = 0; i < 40; ++i) await key("s");
  const low = await camera();
  tell(low[1] > -1 && low[1] < 1);
  tell(Math.abs(away(low) - Math.hypot(14, 1)) < 0.01);
  await key("d");
  tell((await camera())[0] - low[0] > 0.5);
  for (let i = 0; i < 40; ++i) await key("-");
  tell((await camera())[1] > -1);
  for (let i = 0; i < 40; ++i) await key("S", true);
  tell((await camera())[1] > -1);
)js"));
    EXPECT_EQ(told(opened), "[true][true][true][true][true]");
    // Below a ground from the beginning, it is free.
    const Opened below = open("t=1&camera=0,-5,9,0,0,0,35",
                              driver(camera + "await key('s'); tell((await camera())[1] < -5);"));
    EXPECT_EQ(told(below), "[true]");
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
