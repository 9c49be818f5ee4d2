// replay.html as text: its numbers, read as the page's script reads them, are the run's; nothing
// breaks out of its data; a large run is thinned, which is reported.
#include "demos/export/replay_page.h"
#include "demos/load/load_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>
#include <span>

#include "demos/export/replay_codec.h"
#include "demos/text/base64.h"
#include "demos/text/deflate.h"
#include "demos/text/rounded.h"
#include "tests/demos/page_data.h"
#include "tests/demos/recorded.h"
#include "tests/support/planted_recording.h"
#include "tests/support/text.h"

namespace {

using namespace demos;
using Json = nlohmann::json;
using support::count;
using support::plantedPose;
using support::plantedRecording;
using test::dataOf;

double degreesBetween(const engine::Quat& a, const engine::Quat& b) {
    return a.normalized().angularDistance(b.normalized()) * 180.0 / std::numbers::pi;
}

TEST(ReplayCodec, ARangeIsOffByHalfAWordAtMost) {
    const WordRange range{-15.0, 30.0};
    for (int i = 0; i <= 100'000; ++i) {
        const double value = -15.0 + 30.0 * i / 100'000.0;
        EXPECT_LE(std::abs(range.valueOf(range.wordOf(value)) - value), 30.0 / 131070.0 + 1e-12);
    }
    EXPECT_EQ((WordRange{2.5, 0.0}.valueOf(WordRange{2.5, 0.0}.wordOf(2.5))), 2.5);
}

/// Half turns, whose numbers are 0 or equal, and many rotations between.
TEST(ReplayCodec, ARotationIsOffByAHundredthOfADegreeAtMost) {
    double worst = 0.0;
    for (int x = -4; x <= 4; ++x)
        for (int y = -4; y <= 4; ++y)
            for (int z = -4; z <= 4; ++z)
                for (int w = -4; w <= 4; ++w) {
                    if (x == 0 && y == 0 && z == 0 && w == 0) continue;
                    const engine::Quat q = engine::Quat(w, x + 0.013, y, z - 0.021).normalized();
                    worst = std::max(worst, degreesBetween(rotationOf(wordsOf(q)), q));
                }
    EXPECT_LT(worst, 0.01);
    EXPECT_GT(worst, 0.0);
}

TEST(ReplayCodec, ADirectionIsOffByADegreeAtMost) {
    double least = 1.0;
    for (int i = 0; i < 2000; ++i) {
        const double y = 1.0 - (i + 0.5) / 1000.0, angle = 2.39996 * i, r = std::sqrt(1.0 - y * y);
        const engine::Vec3 d(r * std::cos(angle), y, r * std::sin(angle));
        least = std::min(least, d.dot(directionOf(directionWord(d))));
    }
    EXPECT_GT(least, std::cos(std::numbers::pi / 180.0));
}

/// Decodes a text of columns as page/decode.js does.
std::vector<std::uint16_t> wordsIn(const std::string& text, std::size_t length) {
    const std::string packedText = fromBase64(text).value();
    const std::vector<std::uint8_t> bytes =
        inflated({reinterpret_cast<const std::uint8_t*>(packedText.data()), packedText.size()},
                 100'000'000)
            .value();
    std::vector<std::uint16_t> words(bytes.size() / 2);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const int before = i % length == 0 ? 0 : words[i - 1];
        words[i] = static_cast<std::uint16_t>(before + bytes[i] + 256 * bytes[words.size() + i]);
    }
    return words;
}

WordRange rangeIn(const Json& range) { return {range[0], range[1]}; }

/// The largest errors of a page's numbers.
struct Off {
    double meters = 0.0, degrees = 0.0, speed = 0.0;  // m/s

    void see(double position, double turn, double metersASecond) {
        meters = std::max(meters, position);
        degrees = std::max(degrees, turn);
        speed = std::max(speed, metersASecond);
    }
};

constexpr std::size_t kColumns = 7;  // of a body that moves: place, speed, rotation

/// `words`: of one body.
void compare(const Json& ranges, std::span<const std::uint16_t> words, const Recording& recording,
             std::size_t body, Off& off) {
    const std::size_t frames = recording.frames.size();
    for (std::size_t frame = 0; frame < frames; ++frame) {
        const auto word = [&](std::size_t column) { return words[column * frames + frame]; };
        const auto value = [&](std::size_t column) {
            return rangeIn(ranges[column]).valueOf(word(column));
        };
        const BodyMotion& motion = recording.frames[frame].bodies[body];
        off.see((engine::Vec3(value(0), value(1), value(2)) - motion.pose.position).norm(),
                degreesBetween(rotationOf({word(4), word(5), word(6)}), motion.pose.rotation),
                std::abs(value(3) - motion.velocity.norm()));
    }
}

Off worstOf(const Recording& recording) {
    const Json data = dataOf(replayPage(recording).html);
    const std::size_t size = kColumns * recording.frames.size();
    const std::vector<std::uint16_t> words = wordsIn(data["tracks"], recording.frames.size());
    Off off;
    std::size_t moving = 0;
    for (std::size_t body = 0; body < recording.bodies.size(); ++body) {
        if (!data["bodies"][body].contains("ranges")) continue;
        compare(data["bodies"][body]["ranges"], std::span(words).subspan(size * moving++, size),
                recording, body, off);
    }
    EXPECT_EQ(words.size(), size * moving);
    return off;
}

TEST(ReplayPage, HoldsWhereBodiesAreToHalfAMillimetreAndAHundredthOfADegree) {
    const Off off = worstOf(plantedRecording(3, 90, 0));
    EXPECT_LT(off.meters, 5e-4);  // of 30 m
    EXPECT_LT(off.degrees, 0.01);
    EXPECT_LT(off.speed, 1e-4);
}

/// As demos/export/README.md says.
TEST(ReplayPage, HoldsRagdollToATwentiethOfAMillimetre) {
    const SceneDescription scene = loadScene("ragdoll", {});
    const Off off = worstOf(test::Recorded(scene, std::lround(scene.seconds * scene.hz), 2).run);
    std::printf("ragdoll: %.2g mm and %.2g deg at worst\n", 1e3 * off.meters, off.degrees);
    EXPECT_LT(off.meters, 0.055e-3);
    EXPECT_GT(off.meters, 0.0);
    EXPECT_LT(off.degrees, 0.0065);
}

TEST(ReplayPage, HoldsTheContactsOfEveryFrame) {
    const Recording recording = plantedRecording(2, 20, 5);
    const Json contacts = dataOf(replayPage(recording).html)["contacts"];
    EXPECT_EQ(contacts["counts"][0], 0);
    EXPECT_EQ(contacts["counts"][19], 5);
    const std::size_t total = 19 * 5;
    const std::vector<std::uint16_t> words = wordsIn(contacts["words"], total);
    ASSERT_EQ(words.size(), 7 * total);
    const engine::ContactState& last = recording.frames[19].contacts[4];
    const auto word = [&](std::size_t column) { return words[(column + 1) * total - 1]; };
    const auto value = [&](std::size_t column) {
        return rangeIn(contacts["ranges"][column]).valueOf(word(column));
    };
    EXPECT_LT((engine::Vec3(value(0), value(1), value(2)) - last.position).norm(), 1e-4);
    EXPECT_NEAR(value(3), last.impulse, 1e-4);
    EXPECT_LT((value(4) * directionOf(word(6)) - last.friction).norm(), 0.005);
    EXPECT_LT((directionOf(word(5)) - last.normal).norm(), 0.02);
}

TEST(ReplayPage, ABodyThatStaysIsWrittenOnce) {
    Recording recording = plantedRecording(2, 50, 0);
    for (RecordedFrame& frame : recording.frames) frame.bodies[1].pose = plantedPose(1, 0.0);
    const Json data = dataOf(replayPage(recording).html);
    EXPECT_TRUE(data["bodies"][0].contains("ranges"));
    EXPECT_FALSE(data["bodies"][1].contains("ranges"));
    EXPECT_NEAR(data["bodies"][1]["at"][0].get<double>(), plantedPose(1, 0.0).position.x(), 1e-4);
    EXPECT_EQ(wordsIn(data["tracks"], 50).size(), 7u * 50u);
}

TEST(ReplayPage, NothingBreaksOutOfItsData) {
    const std::string hostile =
        "</script><script>alert(1)</script><!-- \xe2\x80\xa8 ]]> \" \\ \x01";
    Recording recording = plantedRecording(1, 2, 1);
    const std::string harmless = replayPage(recording).html;
    recording.name = recording.title = recording.bodies[0].name = hostile;
    recording.sections = {{0.0, hostile, hostile, hostile, hostile, 1.0, false, false}};
    recording.joints.push_back({hostile, 0, -1, {0, 0, 0}, {0, 0, 0}, 2});
    const ReplayPage page = replayPage(recording);
    for (const char* word : {"<script", "</script", "<!--", "\xe2\x80\xa8"})
        EXPECT_EQ(count(page.html, word), count(harmless, word)) << word;
    EXPECT_EQ(count(harmless, "<script"), 2);
    EXPECT_EQ(dataOf(page.html)["bodies"][0]["name"], hostile);
}

TEST(Rounded, ToDigitsWhateverItsSize) {
    EXPECT_EQ(rounded(1.23456789, 4), 1.235);
    EXPECT_EQ(rounded(-1.23456789e-310, 3), -1.23e-310);  // subnormal
    EXPECT_EQ(rounded(98765.4, 2), 99000.0);
    EXPECT_EQ(rounded(0.0, 6), 0.0);
    EXPECT_TRUE(std::isinf(rounded(HUGE_VAL, 6)));
}

TEST(ReplayPage, HasNoAddressAndForbidsAllButItsOwn) {
    const std::string html = replayPage(plantedRecording(1, 2, 0)).html;
    EXPECT_EQ(count(html, "http:"), 0);
    EXPECT_EQ(count(html, "https:"), 0);
    EXPECT_EQ(count(html, " src="), 0);
    EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
}

TEST(ReplayPage, TenBodiesAndThreeHundredFramesTakeAMegabyteAtMost) {
    const ReplayPage page = replayPage(plantedRecording(10, 300, 40));
    EXPECT_LE(page.html.size(), 1'000'000u);
    EXPECT_EQ(page.left, "");
}

/// The strongest contacts stay.
TEST(ReplayPage, ALargeRunIsThinnedAndSaysSo) {
    const Recording recording = plantedRecording(10, 120, 400);
    const std::size_t whole = replayPage(recording).html.size();
    const ReplayPage fewer = replayPage(recording, whole * 3 / 4);
    EXPECT_LE(fewer.html.size(), whole * 3 / 4);
    const Json data = dataOf(fewer.html);
    EXPECT_EQ(data["frames"], 120);
    const Json& contacts = data["contacts"];
    const auto kept = contacts["counts"][60].get<std::size_t>();
    EXPECT_EQ(fewer.left,
              "large run: the " + std::to_string(kept) + " strongest contacts of a frame only");
    EXPECT_EQ(data["left"], fewer.left);
    std::vector<double> impulses;
    for (const engine::ContactState& contact : recording.frames[60].contacts)
        impulses.push_back(contact.impulse);
    std::sort(impulses.rbegin(), impulses.rend());
    ASSERT_LT(kept, impulses.size());
    EXPECT_NEAR(rangeIn(contacts["ranges"][3]).low, impulses[kept], 0.02);
}

/// In a symmetric scene many contacts have equal impulses.
TEST(ReplayPage, OfEqualContactsAsManyStayAsAreCounted) {
    Recording recording = plantedRecording(10, 120, 400);
    for (RecordedFrame& frame : recording.frames)
        for (engine::ContactState& contact : frame.contacts) contact.impulse = 2.0;
    recording.frames[60].contacts[399].impulse = 3.0;
    const std::size_t whole = replayPage(recording).html.size();
    const ReplayPage fewer = replayPage(recording, whole * 3 / 4);
    const Json contacts = dataOf(fewer.html)["contacts"];
    const auto kept = contacts["counts"][60].get<std::size_t>();
    EXPECT_EQ(fewer.left,
              "large run: the " + std::to_string(kept) + " strongest contacts of a frame only");
    EXPECT_EQ(contacts["counts"][61], kept);
    EXPECT_EQ(rangeIn(contacts["ranges"][3]).low, 2.0);
    EXPECT_EQ(rangeIn(contacts["ranges"][3]).size, 1.0);  // the strongest of all is there
}

TEST(ReplayPage, HasTheLookOfTheRun) {
    Recording recording = plantedRecording(1, 2, 0);
    recording.look.ground = {0.25f, 0.5f, 0.75f, 1.0f};
    recording.look.gridReach = 2.5f;
    const Json data = dataOf(replayPage(recording).html);
    EXPECT_EQ(data["look"]["ground"], (Json{0.25, 0.5, 0.75, 1.0}));
    EXPECT_EQ(data["gridReach"], 2.5);
}

TEST(ReplayPage, NothingIsThinnedBelowTwoFrames) {
    const ReplayPage page = replayPage(plantedRecording(10, 120, 400), 1);
    const Json data = dataOf(page.html);
    EXPECT_EQ(data["frames"], 2);
    EXPECT_NEAR(data["fps"].get<double>(), 30.0 / 64, 1e-5);
    EXPECT_EQ(page.left, "large run: the 64 strongest contacts of a frame, every 64th frame only");
}

}  // namespace
