#include "demos/measures/measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/demos/reading.h"

namespace demos::test {
namespace {

/// Simulates and records a ball that falls 0.1 m, for `seconds`.
struct Played {
    Stage stage;
    Recorder recorder;

    explicit Played(double seconds, const std::vector<std::string>& overrides = {})
        : stage(read(kFloor + kBall, overrides)) {
        recorder.look(stage);
        for (int step = 0; step < std::lround(seconds * stage.scene.hz); ++step) {
            EXPECT_TRUE(stage.step());
            recorder.look(stage);
        }
    }
    Chart chart(const std::string& name) const { return recorder.charts({name}).front(); }
};

const std::string kLow = "body.ball.at=[0,0.6,0]";

TEST(Recorder, NamesGiveTheirChartsInTheOrderAsked) {
    const Played played(0.1);
    const std::vector<Chart> charts = played.recorder.charts({"residual", "energy"});
    ASSERT_EQ(charts.size(), 3u);  // the residual has two
    EXPECT_EQ(charts[0].xTitle, "sweep");
    EXPECT_EQ(charts[2].yUnit, "J");
    for (const std::string& name : measureNames())
        EXPECT_FALSE(played.recorder.charts({name}).empty());
}

TEST(Recorder, EnergyIsKineticAndPotential) {
    const Chart chart = Played(0.5).chart("energy");
    ASSERT_EQ(chart.series.size(), 3u);
    ASSERT_EQ(chart.series[0].y.size(), 31u);  // time 0, thirty steps
    EXPECT_EQ(chart.series[0].x.front(), 0.0);
    EXPECT_NEAR(chart.series[0].x.back(), 0.5, 1e-9);
    for (std::size_t i = 0; i < 31; ++i)
        EXPECT_DOUBLE_EQ(chart.series[2].y[i], chart.series[0].y[i] + chart.series[1].y[i]);
    EXPECT_EQ(chart.series[0].y.front(), 0.0);
    EXPECT_GT(chart.series[0].y.back(), 0.0);
}

TEST(Recorder, WhatIsNotThereHasNoData) {
    const Played played(0.1);  // still in the air
    EXPECT_FALSE(hasData(played.chart("penetration")));
    EXPECT_FALSE(hasData(played.chart("separation")));
    EXPECT_FALSE(hasData(played.chart("impulse")));
    EXPECT_TRUE(hasData(played.chart("contacts")));
}

TEST(Recorder, AContactsImpulseCarriesTheWeightAndIsAGapBefore) {
    const Chart chart = Played(1.0, {kLow, "body.ball.mass=2"}).chart("impulse");
    ASSERT_EQ(chart.series.size(), 1u);
    EXPECT_EQ(chart.series[0].label, "floor–ball");
    EXPECT_TRUE(std::isnan(chart.series[0].y.front()));
    EXPECT_NEAR(chart.series[0].y.back(), 2 * 9.81 / 60, 1e-3);  // m g dt
}

TEST(Recorder, PointsOfOnePairAreNumbered) {
    const std::string box =
        "[[body]]\nname = 'box'\nshape = { box = [1, 1, 1] }\nat = [0, 0.5, 0]\n";
    Stage stage(read(kFloor + box));
    Recorder recorder;
    for (int i = 0; i < 10; ++i) stage.step(), recorder.look(stage);
    const Chart chart = recorder.charts({"impulse"}).front();
    ASSERT_EQ(chart.series.size(), 4u);  // one per corner
    EXPECT_EQ(chart.series[0].label, "floor–box (1)");
    EXPECT_EQ(chart.series[3].label, "floor–box (4)");
}

Series lossOf(const std::vector<std::string>& overrides) {
    std::string boxes;
    for (const char* i : {"0", "1", "2"})
        boxes += std::string("[[body]]\nname = 'box") + i +
                 "'\nshape = { box = [1, 1, 1] }\nat = [0, " + i + ".5, 0]\n";
    Stage stage(read(kFloor + boxes, overrides));
    Recorder recorder;
    for (int i = 0; i < 10; ++i) stage.step(), recorder.look(stage);
    return recorder.charts({"residual"}).front().series.front();
}

TEST(Recorder, TheLossCurveIsOneSubStepOnly) {
    const Series all = lossOf({"solver.tolerance=0", "solver.sweeps=7", "solver.warm_start=false",
                               "solver.block=false", "solver.substeps=3"});
    EXPECT_EQ(all.x, (std::vector<double>{1, 2, 3, 4, 5, 6, 7}));
    const Series early =
        lossOf({"solver.tolerance=1e-2", "solver.sweeps=50", "solver.warm_start=false"});
    ASSERT_GT(early.y.size(), 2u);  // the least number of sweeps
    ASSERT_LT(early.y.size(), 50u);
    for (std::size_t i = 1; i + 1 < early.y.size(); ++i) EXPECT_GE(early.y[i], 1e-2);
    EXPECT_LT(early.y.back(), 1e-2);
}

TEST(Recorder, TheLossCurveEndsWhereNothingIsLeft) {
    const Played played(0.5, {kLow, "solver.tolerance=0", "solver.sweeps=30"});
    EXPECT_LT(played.chart("residual").series[0].x.size(), 30u);  // one contact: exact at once
}

}  // namespace
}  // namespace demos::test
