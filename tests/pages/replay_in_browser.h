/// replay.html of a planted run in a browser, for tests of its parts.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "demos/export/replay_page.h"
#include "render/camera.h"
#include "tests/pages/driver.h"
#include "tests/support/planted_recording.h"

namespace support {

using namespace demos;

inline constexpr int kReplayFrames = 61;  // two seconds

/// A red ball that moves from x = -3 to 3 (m), pushed to the left by a contact from the second
/// frame on, and a blue one that stays above it.
class ReplayInBrowser : public testing::Test {
protected:
    ReplayInBrowser() {
        recording_ = plantedRecording(2, kReplayFrames, 1);
        recording_.bodies[0].name = "<img src=http://127.0.0.1:9/name.png>";
        recording_.bodies[1].color = {0.1f, 0.2f, 0.9f, 1.0f};
        recording_.grounds = {{true, {0, 1, 0}, -1.0f, 0}};
        recording_.sections = {{0.0, "first", "It starts", "", "", 1.0, false, false},
                               {1.0, "second", "Half way", "", "", 1.0, false, false}};
        for (int i = 0; i < kReplayFrames; ++i) {
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
                std::optional<Window> window = {}) const {
        return browser_.open(replayPage(recording_).html, hash, script, window);
    }

    /// Each animation frame takes window.frameTakes ms by the page's clock, at first 20.
    Opened openTimed(const std::string& script, std::optional<Window> window = {}) const {
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
        const Rect picture = toldRect(opened);
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

    TemporaryFolder folder_;
    Browser browser_{folder_, true};
    Recording recording_;
};

/// The browser makes its window higher for the screenshot, after the driver has run, so the page
/// gets a height that does not depend on the window's, nor on what the driver reports.
inline std::string still(const std::string& steps = "") {
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

inline bool isRed(const std::vector<int>& color) { return color[0] > 100 && color[0] > 3 * color[2]; }
inline bool isBlue(const std::vector<int>& color) { return color[2] > 100 && color[2] > 3 * color[0]; }

/// The number of pixels of one unlit colour.
inline int countOf(const Opened& opened, int r, int g, int b) {
    int found = 0;
    for (int y = 0; y < opened.screenshot.height; ++y)
        for (int x = 0; x < opened.screenshot.width; ++x) {
            const std::uint8_t* pixel = opened.screenshot.at(x, y);
            found += std::abs(pixel[0] - r) < 3 && std::abs(pixel[1] - g) < 3 &&
                     std::abs(pixel[2] - b) < 3;
        }
    return found;
}

}  // namespace support
