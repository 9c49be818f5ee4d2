// The view of replay.html in a browser: the viewer's camera, narrow pictures, slow machines.
#include "tests/pages/replay_in_browser.h"

namespace {

using namespace demos;
using support::driver;
using support::isBlue;
using support::isRed;
using support::Opened;
using support::ReplayInBrowser;
using support::still;
using support::told;

/// Many pictures are drawn by the processor: small ones where the size does not matter.
constexpr support::Window kSmall{300, 400};

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
    EXPECT_EQ(told(openTimed(driver(kPlay + "await play(18, 40);" + all), kSmall)), "[1.00 ]");
    const Opened slow = openTimed(driver(play + all), kSmall);
    EXPECT_EQ(told(slow),
              "[1.00 ,0.50 half resolution, to keep up,"
              "0.50 half resolution and no shadows, to keep up,"
              "0.33 a third of the resolution, fewer sides and no shadows, to keep up]");
    EXPECT_TRUE(slow.console.empty()) << slow.console.front();
    const Opened opened = openTimed(still(play + "await link('t=0');"), support::Window{390, 844});
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
                                    kSmall);
    EXPECT_EQ(told(opened),
              "[true][true][half resolution and no shadows, to keep up]"
              "[0.33 a third of the resolution, fewer sides and no shadows, to keep up]");
}

/// Many round solids have fewer sides from the beginning.
TEST_F(ReplayInBrowser, ManyBallsHaveFewerSides) {
    const auto corners = [this] {
        return std::stoi(told(openTimed(driver("tell(window.mostCorners);"), kSmall)).substr(1));
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
    for (int i = 0; i < support::kReplayFrames; ++i)
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
)js"),
                               kSmall);
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
)js"),
                               kSmall);
    EXPECT_EQ(told(opened), "[true][true][true][true][true]");
    // Below a ground from the beginning, it is free.
    const Opened below = open("t=1&camera=0,-5,9,0,0,0,35",
                              driver(camera + "await key('s'); tell((await camera())[1] < -5);"),
                              kSmall);
    EXPECT_EQ(told(below), "[true]");
}

}  // namespace
