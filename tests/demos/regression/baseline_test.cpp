// NAME.snapshots: written, read back, refused if it was changed, accepted in parts.
#include "demos/regression/baseline.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>

#include "demos/processes/process_pool.h"
#include "demos/regression/accept.h"
#include "demos/regression/judge.h"
#include "demos/regression/pass_cache.h"
#include "demos/regression/run_settings.h"
#include "demos/regression/scene_inputs.h"
#include "demos/regression/verdict_text.h"
#include "demos/text/json_limits.h"
#include "demos/text/json_whole.h"
#include "demos/text/stop.h"
#include "demos/text/text_hash.h"
#include "render/encode/png.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace demos::test {
namespace {

namespace fs = std::filesystem;
using support::TemporaryFolder;

render::Image grayPicture(std::uint8_t level) {
    return {8, 4, std::vector<std::uint8_t>(8 * 4 * 4, level)};
}

/// A result with two pictures; `y`: of its only body in the last of three steps.
Actual actualWith(std::uint8_t level, double y) {
    Actual actual;
    Baseline& baseline = actual.baseline;
    baseline.scene = "ball";
    baseline.version = "0.1.0";
    baseline.renderer = "llvmpipe";
    baseline.pixels = "fma";
    baseline.width = 8;
    baseline.height = 4;
    baseline.settings = {{"world.hz", "60"}, {"seconds", "0.05"}};
    baseline.home = "..";
    baseline.inputs = {{"body.ball", "[[body]]"}, {"body.ball.at", "[0, 1, 0]"}};
    Trajectory& trajectory = baseline.trajectory;
    trajectory.bodies = {"ball"};
    trajectory.extents = {Vec3(1, 1, 1)};
    for (int step = 0; step <= 3; ++step) {
        trajectory.hashes.push_back(
            static_cast<std::uint32_t>(step * (y != 1.0 && step == 3 ? 9 : 1)));
        engine::Pose pose;
        pose.position.y() = step == 3 ? y : 1.0;
        trajectory.moments.push_back({step, {pose}, 5.0, 0.0, 0.0, {}});
    }
    for (const double time : {0.0, 0.05}) {
        const auto& png = actual.png.emplace_back(render::encodePng(grayPicture(level)));
        baseline.pictures.push_back({time, time > 0 && y != 1.0 ? 22u : 11u, hashOf(png)});
    }
    return actual;
}

std::string textOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The complaint about a baseline whose JSON has `from` replaced by `to`.
std::string complaintAbout(const std::string& from, const std::string& to) {
    std::string text = jsonOf(actualWith(1, 1.0).baseline, {});
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    try {
        baselineFrom(text, "b.json");
    } catch (const BaselineError& error) {
        return error.what();
    }
    return "nothing";
}

TEST(Baselines, ComeBackAsTheyWere) {
    const Baseline baseline = actualWith(1, 1.0).baseline;
    const std::string text = jsonOf(baseline, {});
    const Baseline back = baselineFrom(text, "b.json");
    EXPECT_EQ(back.scene, "ball");
    EXPECT_EQ(back.settings, baseline.settings);
    EXPECT_EQ(back.home, "..");
    EXPECT_EQ(back.inputs, baseline.inputs);
    ASSERT_EQ(back.pictures.size(), 2u);
    EXPECT_EQ(back.pictures[1].time, 0.05);
    EXPECT_EQ(back.pictures[1].png, baseline.pictures[1].png);
    EXPECT_EQ(back.trajectory.hashes, baseline.trajectory.hashes);
    EXPECT_EQ(jsonOf(back, {}), text);  // nothing is rounded twice
}

TEST(Baselines, KeepIncidentsAndNothingOfThemWithoutOne) {
    Baseline baseline = actualWith(1, 1.0).baseline;
    EXPECT_EQ(jsonOf(baseline, {}).find("incident"), std::string::npos);
    baseline.incidents = {{31, "ball", "too fast"}, {40, "", "energy jump"}};
    const Baseline back = baselineFrom(jsonOf(baseline, {}), "b.json");
    ASSERT_EQ(back.incidents.size(), 2u);
    EXPECT_EQ(back.incidents[0].step, 31);
    EXPECT_EQ(back.incidents[0].body, "ball");
    EXPECT_EQ(back.incidents[0].trouble, "too fast");
    EXPECT_EQ(back.incidents[1].body, "");
}

TEST(Baselines, SayWhenTheyWereEdited) {
    EXPECT_NE(complaintAbout("\"world.hz\": \"60\"", "\"world.hz\": \"61\"").find("was edited"),
              std::string::npos);
    EXPECT_NE(complaintAbout("llvmpipe", "softpipe").find("was edited"), std::string::npos);
    EXPECT_NE(complaintAbout("\"seal\"", "\"sale\"").find("is damaged"), std::string::npos);
    EXPECT_NE(complaintAbout("\"format\": 2", "\"format\": 3").find("newer impulse"),
              std::string::npos);
    EXPECT_NE(complaintAbout("{", "[").find("is damaged"), std::string::npos);
    // Brackets in strings do not count; others may be nested at most 64 deep.
    const std::string many(100'000, '[');
    const auto trouble = [](const std::string& json) { return jsonTrouble(json, kRunJson); };
    EXPECT_EQ(trouble("[\"\\\"" + many + "\"]"), "");
    EXPECT_EQ(trouble(many.substr(0, kMostJsonDepth)), "");
    EXPECT_EQ(trouble(many.substr(0, kMostJsonDepth + 1)), "is nested deeper than 64");
    const std::string member = "\"a\":[],", value = "[],";
    EXPECT_EQ(trouble("{" + support::repeated(member, 16'384) + "}"), "");
    EXPECT_EQ(trouble("{" + support::repeated(member, 16'385) + "}"),
              "has an object with more members than 16384");
    EXPECT_EQ(trouble("[" + support::repeated(value, 2'000'000) + "[]]"),
              "has more values than 4000000");
    const std::string large = "{" + support::repeated(member, 16'383) + "\"b\":0},";
    EXPECT_EQ(trouble("[" + large + "0]"), "");
    EXPECT_EQ(trouble("[" + large + large + "0]"), "has too many objects with thousands of members");
    // Each reader has limits of its own.
    const std::string some = "[" + support::repeated(value, 60'000) + "[]]";
    EXPECT_EQ(jsonTrouble(some, kRunJson), "");
    EXPECT_EQ(jsonTrouble(some, kBaselineJson), "has more values than 100000");
    EXPECT_EQ(jsonTrouble(std::string(2u << 20, ' '), kPassedJson),
              "has more bytes than 1048576");
    EXPECT_NE(complaintAbout("{", "{\"a\":" + many + std::string(many.size(), ']') + ",")
                  .find("is damaged"),
              std::string::npos);
}

// A number that is no int was converted to one, which is undefined.
TEST(JsonWhole, IsInTheRangeOfItsType) {
    using Json = nlohmann::json;
    EXPECT_EQ(wholeIn<int>(Json::parse("-2147483648")), -2147483647 - 1);
    EXPECT_EQ(wholeIn<int>(Json::parse("2147483647")), 2147483647);
    EXPECT_EQ(wholeIn<long long>(Json::parse("-9223372036854775807")), -9223372036854775807LL);
    for (const char* bad : {"2147483648", "-2147483649", "1e20", "92233720368547758070", "1.5", "\"1\"", "null"})
        EXPECT_THROW(wholeIn<int>(Json::parse(bad)), std::invalid_argument) << bad;
    EXPECT_THROW(wholeIn<long long>(Json::parse("9223372036854775808")), std::invalid_argument);
}

TEST(Baselines, KnowTheirPictures) {
    const TemporaryFolder folder;
    const Actual actual = actualWith(1, 1.0);
    writeBaseline(actual, {}, folder.path());
    const std::optional<Baseline> baseline = readBaseline(folder.path());
    ASSERT_TRUE(baseline.has_value());
    EXPECT_EQ(readPicture(folder.path(), baseline->pictures[0]), actual.png[0]);
    fs::resize_file(folder / "t0.png", 30);
    EXPECT_THROW(readPicture(folder.path(), baseline->pictures[0]), BaselineError);
    fs::remove(folder / "t0.png");
    EXPECT_THROW(readPicture(folder.path(), baseline->pictures[0]), BaselineError);
}

TEST(Baselines, KnowWhatIsNotTheirs) {
    const TemporaryFolder folder;
    writeBaseline(actualWith(1, 1.0), {}, folder.path());
    std::ofstream(folder / "t9.png") << "x";
    std::ofstream(folder / "notes.txt") << "x";
    EXPECT_EQ(orphansOf(folder.path(), {0.0, 0.05}), std::vector<std::string>{"t9.png"});
    EXPECT_FALSE(readBaseline(folder / "none").has_value());
}

class Accepting : public testing::Test {
protected:
    Accepting() {
        writeBaseline(actualWith(1, 1.0), {}, kept);
        writeBaseline(actualWith(2, 1.5), {}, now);
    }
    Baseline baseline() const { return readBaseline(kept).value(); }
    double lastY() const { return baseline().trajectory.moments.back().poses[0].position.y(); }

    TemporaryFolder folder;
    fs::path kept = folder / "kept", now = folder / "now";
};

TEST_F(Accepting, AllCopiesTheFiles) {
    acceptAll(now, kept);
    for (const char* file : {"t0.png", "t0.05.png", "baseline.json"})
        EXPECT_EQ(textOf(kept / file), textOf(now / file)) << file;
}

TEST_F(Accepting, OnePictureLeavesTheOtherAndThePhysics) {
    acceptPicture(now, kept, 0.05);
    EXPECT_EQ(textOf(kept / "t0.05.png"), textOf(now / "t0.05.png"));
    EXPECT_NE(textOf(kept / "t0.png"), textOf(now / "t0.png"));
    const Baseline after = baseline();
    EXPECT_NO_THROW(readPicture(kept, after.pictures[0]));
    EXPECT_NO_THROW(readPicture(kept, after.pictures[1]));
    EXPECT_EQ(after.pictures[1].state, 22u);
    EXPECT_NEAR(lastY(), 1.0, 1e-5);
    EXPECT_THROW(acceptPicture(now, kept, 7.0), BaselineError);
}

TEST_F(Accepting, PhysicsLeavesThePictures) {
    const std::string before = textOf(kept / "t0.png");
    acceptPhysics(now, kept);
    EXPECT_NEAR(lastY(), 1.5, 1e-5);
    EXPECT_EQ(textOf(kept / "t0.png"), before);
    EXPECT_NO_THROW(readPicture(kept, baseline().pictures[0]));
    EXPECT_EQ(baseline().pictures[1].state, 22u);
}

TEST_F(Accepting, RefusesWhatWasChangedAfterTheTest) {
    const std::string json = textOf(kept / "baseline.json"), png = textOf(kept / "t0.png");
    std::ofstream(now / "t0.05.png") << "another picture";
    EXPECT_THROW(acceptAll(now, kept), BaselineError);
    EXPECT_THROW(acceptPicture(now, kept, 0.05), BaselineError);
    EXPECT_THROW(acceptAll(folder / "none", kept), BaselineError);
    EXPECT_EQ(textOf(kept / "baseline.json"), json);
    EXPECT_EQ(textOf(kept / "t0.png"), png);
}

TEST(JudgePicture, HasItsThreeAnswers) {
    const render::Image image = grayPicture(100);
    const std::vector<std::uint8_t> png = render::encodePng(image);
    PictureVerdict verdict;
    judgePicture(image, png, png, {}, verdict);
    EXPECT_EQ(verdict.kind, PictureVerdict::Kind::same);
    judgePicture(image, png, render::encodePng(grayPicture(102)), {}, verdict);
    EXPECT_EQ(verdict.kind, PictureVerdict::Kind::within);
    judgePicture(image, png, render::encodePng(grayPicture(110)), {}, verdict);
    EXPECT_EQ(verdict.kind, PictureVerdict::Kind::changed);
    const render::Image larger{8, 5, std::vector<std::uint8_t>(8 * 5 * 4, 100)};
    EXPECT_THROW(judgePicture(image, png, render::encodePng(larger), {}, verdict), BaselineError);
    std::vector<std::uint8_t> torn = png;
    torn.pop_back();
    EXPECT_THROW(judgePicture(image, png, torn, {}, verdict), BaselineError);
}

TEST(RunSettings, AreComparedKeyByKey) {
    const auto changes = changesOf({{"a", "1"}, {"b", "2"}, {"c", "3"}}, {{"a", "1"}, {"c", "4"}, {"d", "5"}});
    ASSERT_EQ(changes.size(), 3u);
    EXPECT_EQ(changes[0].key, "c");
    EXPECT_EQ(changes[0].baseline, "3");
    EXPECT_EQ(changes[0].actual, "4");
    EXPECT_EQ(changes[1].key, "d");
    EXPECT_EQ(changes[2].key, "b");
    EXPECT_EQ(changes[2].actual, "");
}

/// "key baseline -> actual" of each change.
std::vector<std::string> changedTexts(const Settings& baseline, const Settings& actual) {
    std::vector<std::string> texts;
    for (const SettingChange& change : changedInputs(baseline, actual))
        texts.push_back(settingText(change));
    return texts;
}

TEST(SceneInputs, AreComparedValueByValue) {
    const Settings before = {{"body.box", "[[body]]"},     {"body.box.at", "[1, 2, 0]"},
                             {"body.box.mass", "5"},       {"expect.drift of box", "[[expect]]"},
                             {"expect.drift of box.below", "0.1"}, {"material.wood.friction", "0.6"},
                             {"snapshot.times", "[0, 1, 2]"}};
    EXPECT_TRUE(changedTexts(before, before).empty());
    const Settings after = {{"body.ball", "[[body]]"},
                            {"body.ball.at", "[0, 0, 0]"},
                            {"body.box", "[[body]]"},
                            {"body.box.at", "[1.002, 2, 0]"},
                            {"material.wood.friction", "0.55"},
                            {"snapshot.times", "[0, 2]"}};
    EXPECT_EQ(changedTexts(before, after),
              (std::vector<std::string>{"body.ball is new", "body.box.at[0] 1 -> 1.002",
                                        "body.box.mass 5 -> -", "expect.drift of box is gone",
                                        "material.wood.friction 0.6 -> 0.55",
                                        "snapshot.times [0, 1, 2] -> [0, 2]"}));
}

TEST(SceneInputs, ListAtMostAHundred) {
    Settings before, after;
    for (int i = 100; i < 350; ++i) before.emplace_back("values.v" + std::to_string(i), "1");
    after = before;
    for (auto& [key, value] : after) value = "2";
    const std::vector<std::string> texts = changedTexts(before, after);
    ASSERT_EQ(texts.size(), 101u);
    EXPECT_EQ(texts.back(), "150 more values");
}

TEST(SceneInputs, AreRefusedIfTheyAreNone) {
    const Settings inputs = {{"title", "a ball"}, {"values.v", ""}};
    EXPECT_EQ(inflatedInputs(deflatedInputs(inputs)), inputs);
    for (const char* bad : {"", "!", "AAAA"})
        EXPECT_THROW(inflatedInputs(bad), std::invalid_argument) << bad;
}

TEST(SceneInputs, OfAnOldBaselineAreNotCompared) {
    Baseline old = actualWith(1, 1.0).baseline, now = old;
    old.settings.emplace_back("scene file", "0123456789abcdef");
    old.inputs.clear();
    const std::vector<SettingChange> changes = changesBetween(old, now);
    ASSERT_EQ(changes.size(), 1u);
    EXPECT_NE(settingText(changes[0]).find("impulse test --update all renews it"),
              std::string::npos);
}

TEST(SceneInputs, ThatAreSettingsTooAreListedOnce) {
    Baseline was = actualWith(1, 1.0).baseline, is;
    was.settings = {{"look.theme", "paper"}, {"world.gravity", "0 -9.81 0"}};
    was.inputs = {{"look.theme", "'paper'"}, {"title", "'a'"}, {"world.gravity", "[0, -9.81, 0]"}};
    is = was;
    is.settings = {{"look.theme", "dusk"}, {"world.gravity", "0 -1.62 0"}};
    is.inputs = {{"look.theme", "'dusk'"}, {"title", "'b'"}, {"world.gravity", "[0, -1.62, 0]"}};
    std::vector<std::string> keys;
    for (const SettingChange& change : changesBetween(was, is)) keys.push_back(change.key);
    EXPECT_EQ(keys, (std::vector<std::string>{"look.theme", "world.gravity", "title"}));
}

TEST(PassCaches, KeepWhatPassed) {
    const TemporaryFolder folder;
    PassCache cache(folder / "passed.json");
    EXPECT_FALSE(cache.has("stack", 7));
    cache.add("stack", 0xfedcba9876543210ull);
    cache.add("wall", 2);
    cache.remove("wall");
    cache.write();
    const PassCache again(folder / "passed.json");
    EXPECT_TRUE(again.has("stack", 0xfedcba9876543210ull));
    EXPECT_FALSE(again.has("stack", 7));
    EXPECT_FALSE(again.has("wall", 2));
    std::ofstream(folder / "passed.json") << R"({"stack": 3, "wall": "zz"})";
    EXPECT_FALSE(PassCache(folder / "passed.json").has("stack", 3));
}

TEST(ProcessPools, GiveEveryAnswerInOrder) {
    std::vector<std::string> answers;
    runInProcesses(
        7, 3, [](int i) { return std::string(static_cast<std::size_t>(100'000 * (7 - i)), 'a'); },
        [&](int i, const PoolResult& result) {
            EXPECT_TRUE(result.ended);
            EXPECT_EQ(i, static_cast<int>(answers.size()));
            answers.push_back(result.text);
        });
    ASSERT_EQ(answers.size(), 7u);
    EXPECT_EQ(answers[6].size(), 100'000u);
}

/// The first process ends only after the end of the second one has been reported.
TEST(ProcessPools, TellOfAnEndAtOnce) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    std::vector<int> finished, taken;
    runInProcesses(
        2, 2,
        [&](int i) -> std::string {
            char byte = 0;
            return i == 0 && ::read(ends[0], &byte, 1) != 1 ? "not told" : "good";
        },
        [&](int i, const PoolResult& result) {
            EXPECT_EQ(result.text, "good");
            taken.push_back(i);
        },
        [&](int i, const PoolResult&) {
            finished.push_back(i);
            if (i == 0) return;
            EXPECT_EQ(::write(ends[1], "x", 1), 1);
        });
    close(ends[0]);
    close(ends[1]);
    EXPECT_EQ(finished, (std::vector{1, 0}));
    EXPECT_EQ(taken, (std::vector{0, 1}));
}

TEST(ProcessPools, OutliveWhatCrashes) {
    std::vector<PoolResult> results;
    runInProcesses(
        3, 2,
        [](int i) -> std::string {
            if (i == 1) raise(SIGKILL);
            return "good";
        },
        [&](int, const PoolResult& result) { results.push_back(result); });
    ASSERT_EQ(results.size(), 3u);
    EXPECT_TRUE(results[0].ended);
    EXPECT_FALSE(results[1].ended);
    EXPECT_EQ(results[1].text.find("was killed by signal 9"), 0u) << results[1].text;
    EXPECT_TRUE(results[2].ended);
}

}  // namespace
}  // namespace demos::test
