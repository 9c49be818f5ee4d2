// junit.xml, read back: what CI servers count and show.
#include "demos/regression/junit.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <utility>

namespace demos::test {
namespace {

TestVerdict verdictOf(std::vector<SceneVerdict> scenes) {
    TestVerdict verdict;
    verdict.scenes = std::move(scenes);
    return verdict;
}

/// The document of a verdict; fails if it cannot be read.
class TomlPosition {
public:
    explicit TomlPosition(const TestVerdict& verdict) : text(junitXml(verdict)) {
        EXPECT_TRUE(document_.load_buffer(text.data(), text.size())) << text;
    }
    explicit TomlPosition(const SceneVerdict& scene) : TomlPosition(verdictOf({scene})) {}

    pugi::xml_node root() const { return document_.document_element(); }
    pugi::xml_node suite() const { return root().child("testsuite"); }
    pugi::xml_node testCase(const char* name) const {
        const pugi::xml_node found = suite().find_child_by_attribute("testcase", "name", name);
        EXPECT_TRUE(found) << "no case '" << name << "' in\n" << text;
        return found;
    }

    std::string text;

private:
    pugi::xml_document document_;
};

/// "tests failures errors skipped"
std::string countsOf(pugi::xml_node node) {
    std::string counts;
    for (const char* name : {"tests", "failures", "errors", "skipped"})
        counts.append(counts.empty() ? "" : " ").append(node.attribute(name).value());
    return counts;
}

std::string messageOf(pugi::xml_node fault) { return fault.attribute("message").value(); }

ExpectationResult expectation(bool passed) {
    return {.text = "drift of ball below 0.005 m",
            .value = passed ? 0.001 : 0.0125,
            .unit = "m",
            .passed = passed,
            .why = "it lies on a plane"};
}

PictureVerdict pictureVerdict(double time, PictureVerdict::Kind kind) {
    PictureVerdict picture;
    picture.time = time;
    picture.kind = kind;
    picture.baselineState = picture.state = 1;
    picture.difference.sameSize = true;
    picture.baseline = "a.snapshots/" + std::to_string(time) + ".png";
    picture.actual = "output/test/" + picture.baseline;
    return picture;
}

/// Expectation, physics and pictures at 0, 1 and 2.5 s; nothing differs.
SceneVerdict passedScene() {
    SceneVerdict scene;
    scene.name = "stack";
    scene.scene = "scenes/stack.toml";
    scene.expectations = {expectation(true)};
    scene.physics.kind = PhysicsVerdict::Kind::same;
    for (const double time : {0.0, 1.0, 2.5})
        scene.pictures.push_back(pictureVerdict(time, PictureVerdict::Kind::same));
    return scene;
}

SceneVerdict failedScene() {
    SceneVerdict scene = passedScene();
    scene.state = SceneVerdict::State::failed;
    scene.expectations.push_back(expectation(false));
    scene.physics.kind = PhysicsVerdict::Kind::changed;
    scene.physics.lines = {"first apart in step 31: box9, y, +0.002 m", "box8-box9: 1 N s, was 2"};
    scene.settings = {{"solver.sweeps", "10", "12"}, {"preset", "", "fast"}};
    PictureVerdict& changed = scene.pictures[2];
    changed.kind = PictureVerdict::Kind::changed;
    changed.state = 2;
    changed.difference.differing = 345;
    changed.difference.largest = 90;
    changed.difference.worstWindow = 77;
    changed.difference.windowX = 12;
    changed.difference.windowY = 34;
    changed.difference.worstSsim = 0.5;
    return scene;
}

SceneVerdict errorScene() {
    SceneVerdict scene;
    scene.name = "bad";
    scene.scene = "bad.toml";
    scene.state = SceneVerdict::State::error;
    scene.problem = "bad.toml:1:1: 'fromat' is no key here";
    return scene;
}

TEST(JunitXml, OfNoSceneIsEmpty) {
    const TomlPosition written{TestVerdict{}};
    EXPECT_STREQ(written.root().name(), "testsuites");
    EXPECT_EQ(countsOf(written.root()), "0 0 0 0");
    EXPECT_FALSE(written.suite());
}

TEST(JunitXml, NamesCasesAsApproveTakesThem) {
    const TomlPosition written(passedScene());
    EXPECT_STREQ(written.suite().attribute("name").value(), "stack");
    std::vector<std::string> names;
    for (const pugi::xml_node node : written.suite().children("testcase")) {
        EXPECT_STREQ(node.attribute("classname").value(), "stack");
        EXPECT_STREQ(node.attribute("file").value(), "scenes/stack.toml");
        EXPECT_FALSE(node.first_child()) << "a case that passed has nothing to say";
        names.emplace_back(node.attribute("name").value());
    }
    EXPECT_EQ(names,
              (std::vector<std::string>{"expect: drift of ball below 0.005 m", "stack@physics",
                                        "stack@0", "stack@1", "stack@2.5"}));
    EXPECT_EQ(countsOf(written.suite()), "5 0 0 0");
}

TEST(JunitXml, ABuiltInSceneHasNoFile) {
    SceneVerdict scene = passedScene();
    scene.scene = scene.name;
    EXPECT_FALSE(TomlPosition(scene).testCase("stack@physics").attribute("file"));
}

TEST(JunitXml, SaysWhatFailed) {
    const TomlPosition written(failedScene());
    EXPECT_EQ(countsOf(written.suite()), "6 3 0 0");
    const pugi::xml_node expected = written.suite().find_node(
        [](const pugi::xml_node& node) { return std::string(node.name()) == "failure"; });
    EXPECT_EQ(messageOf(expected), "measured 0.0125 m");
    EXPECT_STREQ(expected.text().get(), "measured 0.0125 m\nwhy: it lies on a plane");
    const pugi::xml_node physics = written.testCase("stack@physics").child("failure");
    EXPECT_EQ(messageOf(physics), "first apart in step 31: box9, y, +0.002 m");
    EXPECT_STREQ(physics.text().get(),
                 "first apart in step 31: box9, y, +0.002 m\nbox8-box9: 1 N s, was 2\n"
                 "made with another setting: solver.sweeps 10 -> 12\n"
                 "made with another setting: preset - -> fast");
}

TEST(JunitXml, ReportsByHowMuchAPictureDiffers) {
    const TomlPosition written(failedScene());
    const pugi::xml_node testCase = written.testCase("stack@2.5");
    const std::string message = messageOf(testCase.child("failure"));
    EXPECT_EQ(
        message,
        "345 pixels differ, by 90 of 255 at most; the worst 16x16 window, at 12,34, has 77 that "
        "differ by more than 4 (8 allowed); an area of 8x8 changed its colour by 0.0 (2.0 allowed); "
        "lowest SSIM 0.500 (0.90 needed)");
    const std::string details = testCase.child("failure").text().get();
    EXPECT_NE(details.find("\nactual: output/test/a.snapshots/"), std::string::npos) << details;
    EXPECT_NE(details.find("\nthe state of the world differs"), std::string::npos) << details;
    EXPECT_STREQ(testCase.child("system-out").text().get(),
                 "[[ATTACHMENT|output/test/a.snapshots/2.500000.png]]");
}

TEST(JunitXml, ReportsWhyThereIsNothingToCompare) {
    SceneVerdict scene = failedScene();
    scene.physics = {};
    scene.pictures[0].kind = PictureVerdict::Kind::added;
    scene.pictures[1].kind = PictureVerdict::Kind::broken;
    scene.pictures[1].problem = "'1.png' is no PNG";
    const TomlPosition written(scene);
    const auto said = [&](const char* name) {
        return messageOf(written.testCase(name).child("failure"));
    };
    EXPECT_EQ(countsOf(written.suite()), "6 5 0 0");
    EXPECT_EQ(said("stack@physics"), "there is no baseline of the physics");
    EXPECT_EQ(said("stack@0"), "there is no baseline of this picture");
    EXPECT_EQ(said("stack@1"), "'1.png' is no PNG");
}

// An unusable baseline fails the physics and every picture, each with the reason.
TEST(JunitXml, ReportsWhatIsWrongWithTheWholeBaseline) {
    SceneVerdict scene = failedScene();
    scene.physics = {};
    scene.problem = "a.snapshots/baseline.json was edited";
    for (PictureVerdict& picture : scene.pictures) picture.kind = PictureVerdict::Kind::broken;
    const TomlPosition written(scene);
    EXPECT_EQ(countsOf(written.suite()), "6 5 0 0");
    for (const char* name : {"stack@physics", "stack@0", "stack@2.5"})
        EXPECT_EQ(messageOf(written.testCase(name).child("failure")), scene.problem) << name;
}

// Differences within the gate are reported, but pass.
TEST(JunitXml, ADifferenceWithinTheGatesPasses) {
    SceneVerdict scene = passedScene();
    scene.physics.kind = PhysicsVerdict::Kind::bits;
    scene.physics.lines = {"other bits from step 7"};
    scene.pictures[1].kind = PictureVerdict::Kind::within;
    scene.pictures[1].difference.differing = 4;
    const TomlPosition written(scene);
    EXPECT_EQ(countsOf(written.suite()), "5 0 0 0");
    EXPECT_STREQ(written.testCase("stack@physics").child("system-out").text().get(),
                 "other bits from step 7");
    const std::string said = written.testCase("stack@1").child("system-out").text().get();
    EXPECT_EQ(said.rfind("4 pixels differ", 0), 0u) << said;
}

TEST(JunitXml, ASceneWithoutPicturesHasItsContractOnly) {
    SceneVerdict scene;
    scene.name = "stack";
    scene.state = SceneVerdict::State::failed;
    scene.expectations = {expectation(false)};
    EXPECT_EQ(countsOf(TomlPosition(scene).suite()), "1 1 0 0");
}

// With --update, the actual has become the baseline.
TEST(JunitXml, WhatWasUpdatedPasses) {
    for (const auto state : {SceneVerdict::State::updated, SceneVerdict::State::added}) {
        SceneVerdict scene = failedScene();
        scene.expectations = {expectation(true)};
        scene.state = state;
        EXPECT_EQ(countsOf(TomlPosition(scene).suite()), "5 0 0 0") << nameOf(state);
    }
}

TEST(JunitXml, WhatWasNotPlayedIsSkipped) {
    SceneVerdict scene = passedScene();
    scene.cached = true;
    const TomlPosition written(scene);
    EXPECT_EQ(countsOf(written.suite()), "1 0 0 1");
    EXPECT_EQ(messageOf(written.testCase("stack").child("skipped")),
              "nothing has changed since it passed");
}

TEST(JunitXml, ASceneThatCannotBeTestedIsAnError) {
    const SceneVerdict scene = errorScene();
    const TomlPosition written(scene);
    EXPECT_EQ(countsOf(written.suite()), "1 0 1 0");
    EXPECT_EQ(messageOf(written.testCase("bad").child("error")), scene.problem);
}

TEST(JunitXml, AddsUpItsSuites) {
    TestVerdict verdict = verdictOf({passedScene(), failedScene(), passedScene(), errorScene()});
    verdict.scenes[2].cached = true;
    const TomlPosition written(verdict);
    EXPECT_EQ(countsOf(written.root()), "13 3 1 1");
    const auto suites = written.root().children("testsuite");
    EXPECT_EQ(std::distance(suites.begin(), suites.end()), 4);
}

TEST(JunitXml, NamesOrphansInTheirSuite) {
    SceneVerdict scene = passedScene();
    scene.orphans = {"stack.snapshots/9.png"};
    EXPECT_STREQ(TomlPosition(scene).suite().child("system-out").text().get(),
                 "no listed time uses stack.snapshots/9.png");
}

// Texts cannot add markup to the file, and every byte of it is allowed in XML 1.0.
TEST(JunitXml, StaysWellFormedWhateverTheTextsHold) {
    std::string bytes = "]]></failure><testcase name=\"forged\"/><!-- & &lt; '\" ";
    for (int byte = 0; byte < 256; ++byte) bytes += static_cast<char>(byte);
    bytes += "\xef\xbf\xbf\xed\xa0\x80\xc0\x80\xf4\x90\x80\x80\xf0\x9f\x8e\xb2";
    SceneVerdict scene = failedScene();
    scene.name = scene.scene = scene.title = bytes;
    scene.scene += "2";
    scene.expectations[1].text = scene.expectations[1].unit = scene.expectations[1].why = bytes;
    scene.physics.lines = {bytes, bytes};
    scene.settings = {{bytes, bytes, bytes}};
    scene.pictures[2].actual = scene.pictures[2].baseline = bytes;
    scene.pictures[1].kind = PictureVerdict::Kind::broken;
    scene.pictures[1].problem = scene.orphans.emplace_back(bytes);
    SceneVerdict broken = scene;
    broken.state = SceneVerdict::State::error;
    broken.problem = bytes;
    const TomlPosition written(verdictOf({scene, broken}));
    EXPECT_EQ(countsOf(written.root()), "7 4 1 0");
    EXPECT_EQ(written.text.find("<testcase name=\"forged\""), std::string::npos);
    EXPECT_EQ(written.text.find("&#"), std::string::npos) << "a control byte in other words";
    EXPECT_EQ(written.text.find("\xef\xbf\xbf"), std::string::npos);
    for (const char byte : written.text)
        ASSERT_TRUE(static_cast<unsigned char>(byte) >= 0x20 || byte == '\n') << int{byte};
    EXPECT_NO_THROW(nlohmann::json(written.text).dump()) << "not UTF-8";
    EXPECT_NE(written.text.find("\xf0\x9f\x8e\xb2"), std::string::npos) << "but this is";
}

TEST(JunitXml, IsTheSameForTheSameVerdict) {
    EXPECT_EQ(TomlPosition(failedScene()).text, TomlPosition(failedScene()).text);
}

}  // namespace
}  // namespace demos::test
