// The report as text: nothing breaks out of its data; its size; which pictures and moments it
// holds.
#include "demos/regression/report_page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "demos/regression/report_views.h"
#include "tests/demos/page_data.h"
#include "tests/support/planted_report.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace {

using namespace demos;
using Json = nlohmann::json;
using Kind = PictureVerdict::Kind;
using State = SceneVerdict::State;
using support::count;
using test::dataOf;

TEST(ReportPage, NothingBreaksOutOfItsData) {
    const std::string hostile =
        "</script><script>alert(1)</script><!-- \xe2\x80\xa8 ]]> \" \\ \x01";
    TestVerdict verdict;
    verdict.scenes.push_back(support::plantedScene(hostile, State::failed));
    verdict.scenes[0].settings.push_back({hostile, hostile, hostile});
    verdict.scenes[0].pictures.push_back(
        support::plantedPicture(1, Kind::changed, hostile, hostile));
    verdict.orphans = {hostile};
    const std::string page = reportPage(verdict, {}, "output/test");
    const std::string harmless = reportPage({}, {}, "output/test");
    for (const char* word : {"<script", "</script", "<!--", "\xe2\x80\xa8"})
        EXPECT_EQ(count(page, word), count(harmless, word)) << word;
    EXPECT_EQ(count(harmless, "<script"), 2);
    EXPECT_EQ(dataOf(page)["scenes"][0]["title"], hostile);
    EXPECT_EQ(dataOf(page)["scenes"][0]["pictures"][0]["name"], hostile + "@1");
}

TEST(ReportPage, ANameThatIsNotUtf8IsShown) {
    TestVerdict verdict;
    verdict.scenes.push_back(support::plantedScene("a\xff", State::failed));
    verdict.scenes[0].pictures.push_back(support::plantedPicture(1, Kind::changed, "", ""));
    EXPECT_EQ(dataOf(reportPage(verdict, {}, "x"))["scenes"][0]["name"], "a\xef\xbf\xbd");
}

TEST(ReportPage, HasNoAddressAndForbidsAllButItsOwn) {
    const std::string page = reportPage({}, {}, "output/test");
    EXPECT_EQ(count(page, "http://") + count(page, "https://"), 0);
    EXPECT_EQ(count(page, "content=\"default-src 'none'; "), 1);
}

TEST(ReportPage, TellsTheResultsFolderWhereItIsNotTheUsualOne) {
    EXPECT_EQ(dataOf(reportPage({}, {}, "output/test"))["results"], "");
    EXPECT_EQ(dataOf(reportPage({}, {}, "output/./test/"))["results"], "");
    EXPECT_EQ(dataOf(reportPage({}, {}, "elsewhere/"))["results"], "elsewhere");
}

/// RFC 4648, section 10.
TEST(ReportPage, PicturesAreBase64) {
    const support::TemporaryFolder folder;
    const std::map<std::string, std::string> vectors{{"f", "Zg=="},         {"fo", "Zm8="},
                                                     {"foo", "Zm9v"},       {"foob", "Zm9vYg=="},
                                                     {"fooba", "Zm9vYmE="}, {"foobar", "Zm9vYmFy"}};
    for (const auto& [bytes, text] : vectors) {
        TestVerdict verdict;
        verdict.scenes.push_back(support::plantedScene("a", State::failed));
        verdict.scenes[0].pictures.push_back(
            support::plantedPicture(1, Kind::added, "", support::saved(folder / "a.png", bytes)));
        const Json data = dataOf(reportPage(verdict, {}, "x"));
        EXPECT_EQ(data["images"][0]["src"], "data:image/png;base64," + text);
        EXPECT_FALSE(data["images"][0]["linked"]);
    }
}

TEST(ReportPage, SamePicturesAreThereOnceAndMissingOnesNot) {
    const support::TemporaryFolder folder;
    const std::string a = support::saved(folder / "a.png", "one"),
                      b = support::saved(folder / "b.png", "one");
    TestVerdict verdict;
    verdict.scenes.push_back(support::plantedScene("a", State::passed));
    verdict.scenes[0].pictures = {
        support::plantedPicture(1, Kind::same, a, b),
        support::plantedPicture(2, Kind::changed, a, b),
        support::plantedPicture(3, Kind::changed, (folder / "none.png").string(), ""),
        support::plantedPicture(4, Kind::changed, folder.path().string(), a)};
    const Json data = dataOf(reportPage(verdict, {}, "x"));
    const auto places = [&](int picture) {
        const Json& json = data["scenes"][0]["pictures"][picture];
        return std::pair<int, int>(json["baseline_image"], json["actual_image"]);
    };
    EXPECT_EQ(data["images"].size(), 2u);
    EXPECT_EQ(places(0).first, places(0).second);
    EXPECT_NE(places(1).first, places(1).second);
    EXPECT_EQ(places(2), std::make_pair(-1, -1));
    EXPECT_EQ(places(3).first, -1);  // a folder is not a picture
    EXPECT_GE(places(3).second, 0);
}

TEST(ReportPage, WhatDiffersComesFirstAndTheRestIsLinked) {
    const support::TemporaryFolder folder;
    const std::string large(30'000, 'x');
    std::filesystem::create_directories(folder / "base line");
    const std::string same = support::saved(folder / "base line/a&b.png", large),
                      before = support::saved(folder / "before.png", large),
                      after = support::saved(folder / "after.png", large);
    TestVerdict verdict;
    verdict.scenes = {support::plantedScene("passed", State::passed),
                      support::plantedScene("failed", State::failed)};
    verdict.scenes[0].pictures = {support::plantedPicture(1, Kind::same, same, same)};
    verdict.scenes[1].pictures = {support::plantedPicture(1, Kind::changed, before, after)};
    const long fixed = static_cast<long>(reportPage(verdict, {}, folder / "out", 0).size());
    const std::string page = reportPage(verdict, {}, folder / "out", fixed + 81'000);
    EXPECT_LE(page.size(), static_cast<std::size_t>(fixed + 81'000));
    const Json data = dataOf(page);
    const auto image = [&](int scene, const char* which) {
        return data["images"][data["scenes"][scene]["pictures"][0][which].get<int>()];
    };
    EXPECT_FALSE(image(1, "baseline_image")["linked"]);
    EXPECT_FALSE(image(1, "actual_image")["linked"]);
    EXPECT_TRUE(image(0, "baseline_image")["linked"]);
    EXPECT_EQ(image(0, "baseline_image")["src"], "../base%20line/a%26b.png");
}

TEST(ReportPage, ThirtyScenesStayBelowTenMegabytes) {
    const support::TemporaryFolder folder;
    const std::string large(95'000, 'x');  // bytes of a picture of 640x360
    TestVerdict verdict;
    std::vector<ReportTrajectories> trajectories(30);
    for (int i = 0; i < 30; ++i) {
        verdict.scenes.push_back(support::plantedScene("scene" + std::to_string(i), State::failed));
        verdict.scenes.back().physics.kind = PhysicsVerdict::Kind::changed;
        for (const int time : {1, 2, 3}) {
            const std::string name = std::to_string(i) + "_" + std::to_string(time);
            verdict.scenes.back().pictures.push_back(support::plantedPicture(
                time, Kind::changed, support::saved(folder / (name + "a.png"), large),
                support::saved(folder / (name + "b.png"), large)));
        }
        trajectories[static_cast<std::size_t>(i)].baseline = support::fallingBodies(60, 200, 1.0);
        trajectories[static_cast<std::size_t>(i)].actual = support::fallingBodies(60, 200, 1.1);
    }
    const std::string page = reportPage(verdict, trajectories, folder.path());
    EXPECT_LE(page.size(), 9'500'000u);
    EXPECT_GT(page.size(), 9'300'000u);  // the limit is used
}

long numbersIn(const Json& json) {
    if (!json.is_structured()) return json.is_number() ? 1 : 0;
    long sum = 0;
    for (const Json& part : json) sum += numbersIn(part);
    return sum;
}

Json filmOfBodies(int bodies, PhysicsVerdict::Kind kind) {
    TestVerdict verdict;
    verdict.scenes.push_back(support::plantedScene("a", State::failed));
    verdict.scenes[0].physics.kind = kind;
    verdict.scenes[0].physics.step = 77;
    verdict.scenes[0].physics.body = "body1";
    ReportTrajectories trajectories;
    trajectories.baseline = support::fallingBodies(bodies, 600, 1.0);
    trajectories.actual = support::fallingBodies(bodies, 600, 1.5);
    trajectories.camera.follow = "body2";
    trajectories.camera.orbitDegreesPerSecond = 3.0;
    trajectories.baseline.moments[301].penetration =
        0.004;  // only in one moment between two that are kept
    return dataOf(reportPage(verdict, {trajectories}, "x"))["scenes"][0]["film"];
}

std::set<std::string> bodiesIn(const Json& trajectory) {
    std::set<std::string> names;
    for (const Json& body : trajectory["bodies"]) names.insert(body["name"]);
    return names;
}

TEST(ReportFilm, KeepsItsNumbersTheStepAndTheBodyThatMatter) {
    for (const int bodies : {3, 40, 500}) {
        const Json film = filmOfBodies(bodies, PhysicsVerdict::Kind::changed);
        EXPECT_LE(numbersIn(film), 15'500) << bodies;  // 15,000, about
        for (const char* run : {"baseline", "actual"}) {
            const auto steps = film[run]["pose_steps"].get<std::vector<int>>();
            EXPECT_GE(steps.size(), 24u);
            EXPECT_LE(steps.size(), 121u);
            EXPECT_TRUE(std::binary_search(steps.begin(), steps.end(), 77));
            EXPECT_EQ(steps.back(), 599);
            EXPECT_TRUE(bodiesIn(film[run]).contains("body1"));
        }
        EXPECT_EQ(bodiesIn(film["baseline"]), bodiesIn(film["actual"]));
    }
    const Json large = filmOfBodies(500, PhysicsVerdict::Kind::changed);
    EXPECT_TRUE(bodiesIn(large["actual"]).contains("body499"));  // moves farthest
    EXPECT_TRUE(bodiesIn(large["actual"]).contains("body2"));    // the camera follows it
    EXPECT_FALSE(bodiesIn(large["actual"]).contains("body3"));
}

TEST(ReportFilm, IsWhatTheRunWasToItsUnit) {
    const Json film = filmOfBodies(3, PhysicsVerdict::Kind::changed);
    const double unit = film["unit"];
    EXPECT_LE(unit, 15.0 * 2 / 32767.0);  // body2 falls by 1.5 * 2 m/s * 10 s
    for (const Json& body : film["actual"]["bodies"]) {
        const int number = body["name"].get<std::string>().back() - '0';
        ASSERT_EQ(body["poses"].size(), number == 0 ? 6u : 6 * film["actual"]["pose_steps"].size());
        EXPECT_NEAR(unit * body["poses"][0].get<int>(), number, unit);
        const double fallen = 1.5 * number * 599 / 60.0;  // m
        EXPECT_NEAR(unit * body["poses"][body["poses"].size() - 5].get<int>(), 2.0 - fallen, unit);
    }
}

TEST(ReportFilm, IsSeenAsTheCameraGoes) {
    CameraDescription camera;
    camera.from = {0, 2, 10};
    EXPECT_EQ(viewsJson(camera, 2.0).dump(), "[[0.0,0,0.0,2.0,10.0,0.0,2.0,0.0,35.0]]");
    camera.keys = {{1.0, {0, 2, 20}, {0, 2, 0}, 35.0, Ease::linear},
                   {1.503, {9, 9, 9}, {1, 2, 3}, 50.0, Ease::cut},
                   {9.0, {0, 0, 1}, {0, 0, 0}, 50.0, Ease::smooth}};
    const Json rows = viewsJson(camera, 1.6);
    double before = -1.0;
    for (const Json& row : rows) {
        const double time = row[0];
        EXPECT_GT(time, before);
        before = time;
        EXPECT_EQ(row[1], time < 1.503 ? 0 : 1) << time;  // a take
        EXPECT_NEAR(row[4], time < 1.503 ? 10.0 + 10.0 * std::min(time, 1.0) : 9.0, 0.01) << time;
    }
    EXPECT_EQ(before, 1.6);
    const auto cut = std::find_if(rows.begin(), rows.end(), [](auto& row) { return row[1] == 1; });
    EXPECT_EQ(cut->dump(), "[1.503,1,9.0,9.0,9.0,1.0,2.0,3.0,50.0]");
}

TEST(ReportFilm, IsSeenFromTheCamerasOrbit) {
    CameraDescription camera;
    camera.from = {0, 2, 10};
    camera.orbitDegreesPerSecond = 45.0;
    const Json last = viewsJson(camera, 2.0).back();
    EXPECT_NEAR(last[2], 10.0, 1e-9);
    EXPECT_NEAR(last[4], 0.0, 1e-9);
}

TEST(ReportFilm, KeepsAPeakBetweenTwoMoments) {
    const Json film = filmOfBodies(3, PhysicsVerdict::Kind::changed);
    const auto curve = film["baseline"]["penetration"].get<std::vector<double>>();
    EXPECT_DOUBLE_EQ(*std::max_element(curve.begin(), curve.end()), 0.004);
    EXPECT_EQ(film["baseline"]["energy"].front(), 100.0);
}

TEST(ReportFilm, TwoRunsThatAreOneAreKeptOnce) {
    const Json film = filmOfBodies(3, PhysicsVerdict::Kind::same);
    EXPECT_TRUE(film["same"]);
    EXPECT_TRUE(film["baseline"].is_null());
    EXPECT_FALSE(film["actual"].is_null());
}

TEST(ReportFilm, IsNotThereWithoutARunOrWithNumbersThatAreNone) {
    TestVerdict verdict;
    verdict.scenes.push_back(support::plantedScene("a", State::failed));
    EXPECT_TRUE(dataOf(reportPage(verdict, {{}}, "x"))["scenes"][0]["film"].is_null());
    ReportTrajectories trajectories;
    trajectories.actual = support::fallingBodies(2, 5, 1.0);
    trajectories.actual.moments[2].poses[1].position.x() = std::nan("");
    trajectories.actual.moments[2].energy = std::nan("");
    const Json film = dataOf(reportPage(verdict, {trajectories}, "x"))["scenes"][0]["film"];
    EXPECT_TRUE(film["baseline"].is_null());
    EXPECT_TRUE(film["actual"]["energy"][2].is_null());
}

}  // namespace
