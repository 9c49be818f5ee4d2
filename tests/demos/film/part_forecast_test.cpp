// The forecast for films in parts, where the answer is known.
#include <gtest/gtest.h>

#include "demos/film/part_forecast.h"

namespace demos::test {
namespace {

PartForecast forecast(double simulate, double draw, int shards) {
    PartForecast parts;
    parts.frames = 1600;
    parts.shards = shards;
    parts.simulate = simulate;
    parts.draw = draw;
    return parts;
}

TEST(PartForecast, DrawingAloneIsDividedEvenly) {
    const PartForecast parts = forecast(0.0, 0.1, 16);
    EXPECT_DOUBLE_EQ(parts.simulationShare(), 0.0);
    EXPECT_DOUBLE_EQ(parts.alone(), 160.0);
    EXPECT_DOUBLE_EQ(parts.inParts(), 10.0);
    EXPECT_DOUBLE_EQ(parts.speedUp(), 16.0);
    EXPECT_DOUBLE_EQ(parts.processorRatio(), 1.0);
    EXPECT_EQ(parts.partsThatPay(), 1600);
}

TEST(PartForecast, SimulatingIsRepeatedByEveryPart) {
    PartForecast parts = forecast(0.1, 0.0, 16);
    EXPECT_DOUBLE_EQ(parts.speedUp(), 1.0);
    EXPECT_DOUBLE_EQ(parts.processorRatio(), 17.0 / 2.0);  // (1 + 2 + ... + 16) / 16
    EXPECT_EQ(parts.partsThatPay(), 2);
    parts.workers = parts.simulating = 4;
    EXPECT_DOUBLE_EQ(parts.processorRatio(), 17.0 / 2.0);
}

TEST(PartForecast, OneProcessSimulatesWhileTheOthersDraw) {
    PartForecast parts = forecast(0.01, 0.03, 1);
    parts.workers = 2;
    EXPECT_DOUBLE_EQ(parts.alone(), 1600 * 0.02);
    parts.simulating = 2;
    EXPECT_DOUBLE_EQ(parts.alone(), 1600 * 0.025);
    parts.simulating = 1;
    parts.workers = 16;  // they wait for it
    EXPECT_DOUBLE_EQ(parts.alone(), 1600 * 0.01);
}

TEST(PartForecast, ManyPartsPayWhileEachMachineIsWorthHalfOfOneAlone) {
    for (const int workers : {1, 2}) {
        PartForecast parts = forecast(0.01, 0.3, 1);
        parts.workers = workers;
        parts.start = 1.0;
        parts.begin = 0.5;
        const int most = parts.partsThatPay();
        parts.shards = most;
        EXPECT_GE(parts.speedUp(), 0.5 * most);
        parts.shards = most + 1;
        EXPECT_LT(parts.speedUp(), 0.5 * (most + 1));
    }
}

TEST(PartForecast, OnePartIsTheWholeFilm) {
    PartForecast parts = forecast(0.01, 0.2, 1);
    parts.start = 3.0;
    parts.begin = 0.5;
    parts.workers = 2;
    EXPECT_DOUBLE_EQ(parts.speedUp(), 1.0);
    EXPECT_DOUBLE_EQ(parts.processorRatio(), 1.0);
}

}  // namespace
}  // namespace demos::test
