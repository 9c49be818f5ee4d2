// Numbers in slides: how they are written, and that they come from the run.
#include "demos/slides/number_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "demos/film/progress.h"
#include "demos/scene/reader.h"
#include "demos/slides/deck_runs.h"
#include "demos/slides/markup.h"
#include "demos/slides/slide_numbers.h"
#include "demos/text/stop.h"

namespace demos {
namespace {

constexpr NumberSetting kText = NumberSetting::text, kFormula = NumberSetting::formula;

struct TomlPosition {
    double value;
    const char *unit, *text, *formula;
    int digits = 3;
};

/// Replaces the minus and the no-break spaces of a text by those of a keyboard.
std::string typed(std::string text) {
    const std::pair<std::string, std::string> signs[] = {{"\u2212", "-"}, {"\u00a0", " "}};
    for (const auto& [sign, key] : signs)
        for (std::size_t i = 0; (i = text.find(sign, i)) != std::string::npos;)
            text.replace(i, sign.size(), key);
    return text;
}

TEST(Quantity, IsAsShortAsItCanBeRead) {
    const TomlPosition cases[] = {
        {0.0012749, "m", "1.27 mm", "1.27\\,\\mathrm{mm}"},
        {0.24, "m", "240 mm", "240\\,\\mathrm{mm}"},
        {1.24, "m", "1.24 m", "1.24\\,\\mathrm{m}"},
        {0.24, "m/s", "0.24 m/s", "0.24\\,\\mathrm{m/s}"},
        {1e-6, "m", "1 \u00b5m", "1\\,\\mu\\mathrm{m}"},
        {3.2e-5, "m/s", "32 \u00b5m/s", "32\\,\\mu\\mathrm{m/s}"},
        {264812.0, "J", "265 kJ", "265\\,\\mathrm{kJ}"},
        {264812.0, "J", "264.8 kJ", "264.8\\,\\mathrm{kJ}", 4},
        {999.9996, "N", "1 kN", "1\\,\\mathrm{kN}"},
        {0.9999996, "m", "1 m", "1\\,\\mathrm{m}"},
        {-0.0456, "N s", "-45.6 mN s", "-45.6\\,\\mathrm{mN\\,s}"},
        {1.234e-13, "m", "1.23 \u00d7 10\u207b\u00b9\u00b3 m",
         "1.23 \\times 10^{-13}\\,\\mathrm{m}"},
        {-2e20, "J", "-2 \u00d7 10\u00b2\u2070 J", "-2 \\times 10^{20}\\,\\mathrm{J}"},
        {12.0, "deg", "12 deg", "12^\\circ"},
        {0.5, "s", "0.5 s", "0.5\\,\\mathrm{s}"},
        {123456.0, "rad/s", "123000 rad/s", "123000\\,\\mathrm{rad/s}"},
        {1234.0, "", "1234", "1234", 2},
        {8.3333, "", "8.33", "8.33"},
        {8.3333, "", "8", "8", 1},
        {0.0, "m", "0 m", "0\\,\\mathrm{m}"},
        {-0.0, "", "0", "0"},
    };
    for (const TomlPosition& c : cases) {
        EXPECT_EQ(typed(quantityText(c.value, c.unit, c.digits, kText)), c.text);
        EXPECT_EQ(quantityText(c.value, c.unit, c.digits, kFormula), c.formula);
    }
}

TEST(Quantity, HasTheDigitsThatAreAskedFor) {
    const auto text = [](double value, const char* unit, int digits) {
        return typed(quantityText(value, unit, digits, kText, Zeros::kept));
    };
    EXPECT_EQ(text(4.4, "N s", 5), "4.4000 N s");
    EXPECT_EQ(text(999.9996, "N", 4), "1.000 kN");
    EXPECT_EQ(text(31.0, "", 4), "31") << "a count";
    EXPECT_EQ(text(0.0, "m", 4), "0 m");
    EXPECT_EQ(typed(vectorText({-0.32, 1e-17, 3.0}, "m/s", 3, kText, Zeros::kept)),
              "(-0.32, 0, 3.00) m/s");
}

// No line breaks in it, and the minus is not a hyphen.
TEST(Quantity, IsOneWordOfALine) {
    EXPECT_EQ(quantityText(-0.0456, "N s", 3, kText), "\u221245.6\u00a0mN\u00a0s");
    EXPECT_EQ(vectorText({-1, 0.5, 2}, "m", 3, kText), "(\u22121,\u00a00.5,\u00a02)\u00a0m");
    EXPECT_EQ(quantityText(1e-13, "m", 3, kText), "1\u00a0\u00d7\u00a010\u207b\u00b9\u00b3\u00a0m");
}

TEST(Quantity, ThatIsNotFiniteIsSaid) {
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(quantityText(infinity, "m", 3, kText), "infinite");
    EXPECT_EQ(quantityText(-infinity, "m", 3, kText), "\u2212infinite");
    EXPECT_EQ(quantityText(std::nan(""), "m", 3, kFormula), "\\text{undefined}");
}

TEST(Quantity, AVectorIsAsExactAsItsLargestPart) {
    const auto text = [](const Vec3& value, const char* unit) {
        return typed(vectorText(value, unit, 3, kText));
    };
    EXPECT_EQ(text({-0.3214, 0.2367, 3.0}, "m/s"), "(-0.32, 0.24, 3) m/s");
    EXPECT_EQ(vectorText({-0.3214, 0.2367, 3.0}, "m/s", 3, kFormula),
              "(-0.32, 0.24, 3)\\,\\mathrm{m/s}");
    EXPECT_EQ(text({1e-9, -1e-9, 0.00251}, "m"), "(0, 0, 2.51) mm");
    EXPECT_EQ(text({0, 0, 0}, "rad/s"), "(0, 0, 0) rad/s");
    EXPECT_EQ(text({-9.3e-7, 0, 1.69e-6}, "rad/s"), "(-0.93, 0, 1.69) \u00d7 10\u207b\u2076 rad/s");
    EXPECT_EQ(text({-9.3e-8, 1e-17, 1.69e-7}, "rad/s"),
              "(-0.93, 0, 1.69) \u00d7 10\u207b\u2077 rad/s");
    EXPECT_EQ(text({1e-17, 0, 0}, "m/s"), "(1, 0, 0) \u00d7 10\u207b\u00b9\u2077 m/s");
    EXPECT_EQ(vectorText({1e-17, 0, 0}, "m/s", 3, kFormula),
              "(1, 0, 0) \\times 10^{-17}\\,\\mathrm{m/s}");
}

const char* const kBallOnARod = R"(format = 1
title = "a ball on a rod, and one that lies"
seconds = 1.0
[[body]]
name = "floor"
shape = { plane = [0, 1, 0] }
fixed = true
[[body]]
name = "lying.one"
shape = { sphere = 0.5 }
mass = 2
at = [3, 0.5, 0]
[[body]]
name = "bob"
shape = { sphere = 0.2 }
mass = 1
at = [1, 3, 0]
[[joint]]
name = "rod"
type = "distance"
a = "world"
b = "bob"
anchor_a = [0, 3, 0]
[[expect]]
what = "penetration"
below = 0.1
why = "the floor holds"
[[expect]]
what = "speed"
of = ["bob"]
above = 100
why = "nothing here is as fast"
)";

constexpr long kSteps = 31;
constexpr int kHz = 60;

/// The numbers after 31 steps, and a stage that was simulated as long without their code.
class NumberValues : public testing::Test {
protected:
    NumberValues() : scene(readScene(kBallOnARod, "rod.toml", "rod")), stage(scene) {
        scene.hz = stage.scene.hz = kHz;
        runs.askMoment("rod", scene, static_cast<double>(kSteps) / kHz);
        runs.askExpectations("rod", scene);
        for (long i = 0; i < kSteps; ++i) stage.step();
    }
    std::string text(NumberName name, NumberSetting setting = kText) {
        const PlayedMoment& played = runs.moment("rod", static_cast<double>(kSteps) / kHz);
        return valueOf(name, {scene, played.summary, played.moment, runs.expectations("rod")},
                       setting);
    }
    /// A number without a prefix, with nine digits.
    double number(const std::string& group, const std::string& of, const std::string& field) {
        return std::strtod(text({1, group, of, field, 9}).c_str(), nullptr);
    }
    std::string complaint(const NumberName& name) {
        try {
            text(name);
        } catch (const Stop& stop) {
            EXPECT_EQ(stop.code(), Exit::scene);
            return stop.what();
        }
        return {};
    }

    SceneDescription scene;
    Stage stage;
    DeckRuns runs;
};

TEST_F(NumberValues, AreThoseOfTheWorld) {
    const engine::BodyId bob = stage.bodies[2];
    const auto near = [](double value) { return 1e-8 * std::abs(value); };  // nine digits
    const double height = stage.world.pose(bob).position.y();
    EXPECT_NEAR(number("body", "bob", "height"), height, near(height));
    const double speed = stage.world.velocity(bob).norm();
    EXPECT_NEAR(number("body", "bob", "speed"), speed, near(speed));
    const engine::JointState rod = stage.world.joint(stage.joints[0]);
    const double force = rod.force.norm();
    EXPECT_NEAR(number("joint", "rod", "force"), force, near(force));
    EXPECT_NEAR(number("joint", "rod", "impulse"), force / kHz, near(force / kHz));
    double impulse = 0.0;
    for (const engine::ContactState& contact : stage.world.contacts()) impulse += contact.impulse;
    EXPECT_NEAR(impulse, 2.0 * 9.81 / kHz, 1e-3);  // m g dt: it is at rest
    EXPECT_NEAR(number("contacts", "", "impulse"), impulse, near(impulse));
    const double energy = stage.world.energy().total();
    EXPECT_NEAR(number("run", "", "energy"), energy, near(energy));
}

TEST_F(NumberValues, CountAndName) {
    EXPECT_EQ(text({1, "run", "", "steps", 1}), "31");
    EXPECT_EQ(text({1, "run", "", "time", 4}), "0.5167\u00a0s");
    EXPECT_EQ(text({1, "contacts", "", "points", 3}),
              std::to_string(stage.world.errors().contacts));
    EXPECT_EQ(text({1, "run", "", "sweeps", 3}),
              std::to_string(stage.world.report().sweeps.size()));
    const std::string hash = hexText(stage.world.hash());
    EXPECT_EQ(text({1, "run", "", "hash", 3}), hash);
    EXPECT_EQ(text({1, "run", "", "hash", 3}, kFormula), "\\mathtt{" + hash + "}");
    const Vec3& at = stage.world.pose(stage.bodies[1]).position;
    EXPECT_EQ(text({1, "body", "lying.one", "position", 3}), vectorText(at, "m", 3, kText));
}

TEST_F(NumberValues, MeasuresAreOfTheRunSoFar) {
    SceneDescription shorter = scene;
    shorter.seconds = static_cast<double>(kSteps) / kHz;
    const Summary summary = summarize(shorter);
    for (const char* name : {"drift", "speed", "penetration", "separation", "energy", "sweeps"}) {
        const auto i = static_cast<std::size_t>(measureCalled(name));
        EXPECT_EQ(text({1, "measure", "", name, 4}),
                  quantityText(summary.values[i], measures()[i].unit, 4, kText))
            << name;
    }
}

TEST_F(NumberValues, ExpectationsAreOfTheWholeRun) {
    Stage whole(scene);
    double fastest = 0.0;
    for (int i = 0; i < kHz; ++i) {
        whole.step();
        fastest = std::max(fastest, whole.world.velocity(whole.bodies[2]).norm());
    }
    EXPECT_GT(fastest, stage.world.velocity(stage.bodies[2]).norm());
    EXPECT_EQ(text({1, "expect", "2", "", 5}), quantityText(fastest, "m/s", 5, kText));
}

TEST_F(NumberValues, WhatTheSceneHasNotIsRefused) {
    EXPECT_NE(
        complaint({1, "body", "bib", "height", 3}).find("@{body.bib.height}: the scene 'rod'"),
        std::string::npos);
    EXPECT_NE(complaint({2, "joint", "rope", "force", 3}).find("no joint 'rope'"),
              std::string::npos);
    EXPECT_NE(complaint({1, "expect", "3", "", 3}).find("has 2 [[expect]]"), std::string::npos);
    EXPECT_NE(complaint({1, "body", "bob", "hight", 3}).find("no such number"), std::string::npos);
}

TEST(SlideNumbers, AreFilledInEverywhere) {
    Slide slide;
    slide.title = "@{run.steps} steps";
    slide.text = "It falls by @{speed:2}, $v = @{2.speed}$; `$` @{drift} `$`.";
    slide.formulas = {"\\lambda = @{contacts.impulse}"};
    slide.caption = "@{body.a.b.height}";
    slide.notes = "none";
    EXPECT_EQ(numbersIn(slide).size(), 6u);
    fillNumbers(slide, [](const NumberName& name, NumberSetting setting) {
        return std::to_string(name.run) + (setting == kFormula ? "F" : "T") +
               std::to_string(name.digits) + name.field;
    });
    EXPECT_EQ(slide.title, "1T3steps steps");
    EXPECT_EQ(slide.text, "It falls by 1T2speed, $v = 2F3speed$; `$` 1T3drift `$`.");
    EXPECT_EQ(slide.formulas.front(), "\\lambda = 1F3impulse");
    EXPECT_EQ(slide.caption, "1T3height");
    EXPECT_EQ(slide.notes, "none");
}

// CommonMark reads the text after the numbers are filled in.
TEST(SlideNumbers, AreNothingButWords) {
    Slide slide;
    slide.text = "$v=$@{run.steps}\n\n@{run.steps}. Then [a]@{run.time} `@{run.steps}`";
    fillNumbers(slide, [](const NumberName& name, NumberSetting) {
        return std::string(name.field == "time" ? "(0)" : "31");
    });
    const std::string html = htmlOf(slide.text);
    EXPECT_NE(html.find("</math>31</p>"), std::string::npos) << html;
    EXPECT_NE(html.find("<p>31. Then [a](0) <code>31</code></p>"), std::string::npos) << html;
}

TEST(SlideNumbers, MayBeOfNamesWithDollars) {
    Slide slide;
    slide.text = "$x = @{body.a$b.speed}$";
    fillNumbers(slide, [](const NumberName&, NumberSetting setting) {
        return std::string(setting == kFormula ? "F" : "T");
    });
    EXPECT_EQ(slide.text, "$x = F$");
}

TEST(DeckRuns, PlayEachRunOnce) {
    const SceneDescription scene = readScene(kBallOnARod, "rod.toml", "rod");
    DeckRuns runs;
    for (const double until : {0.5, 0.25, 0.5}) runs.askMoment("a", scene, until);
    runs.askMoment("b", scene, 0.1);
    EXPECT_EQ(runs.played(), 0);
    EXPECT_NEAR(runs.moment("a", 0.25).moment.report.time, 0.25, 1e-9);
    EXPECT_NEAR(runs.moment("a", 0.5).moment.report.time, 0.5, 1e-9);
    EXPECT_EQ(runs.moment("a", 0.25).summary.time.size(), 0.25 * scene.hz);
    EXPECT_EQ(runs.played(), 1);
    runs.moment("b", 0.1);
    EXPECT_EQ(runs.played(), 2);
}

}  // namespace
}  // namespace demos
