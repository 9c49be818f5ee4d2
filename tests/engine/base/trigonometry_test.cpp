#include "engine/base/trigonometry.h"

#include <gtest/gtest.h>

#include <cmath>

namespace engine {
namespace {

// The C library is accurate to better than 1 ulp; it just differs between machines.
TEST(Trigonometry, AgreesWithTheLibraryTo2e15) {
    for (int i = -4000; i <= 4000; ++i) {
        const double x = 0.0137 * i;
        EXPECT_NEAR(sine(x), std::sin(x), 2e-15) << x;
        EXPECT_NEAR(cosine(x), std::cos(x), 2e-15) << x;
    }
    EXPECT_NEAR(sine(1e5), std::sin(1e5), 2e-15);
    EXPECT_NEAR(cosine(-99999.5), std::cos(-99999.5), 2e-15);
}

TEST(Trigonometry, ArctangentAgreesInAllFourQuadrants) {
    for (int i = -50; i <= 50; ++i)
        for (int j = -50; j <= 50; ++j) {
            const double y = 0.31 * i, x = 0.17 * j;
            if (x == 0.0 && y == 0.0) continue;
            EXPECT_NEAR(arctangent(y, x), std::atan2(y, x), 2e-15) << y << " " << x;
        }
    EXPECT_EQ(arctangent(0.0, 0.0), 0.0);
}

TEST(Trigonometry, TurnsAboutXThenYThenZ) {
    const Quat q = turnAboutXyz(Vec3(radians(90), 0, radians(90)));
    EXPECT_NEAR((q * Vec3(0, 1, 0) - Vec3(0, 0, 1)).norm(), 0.0, 1e-15);   // x only moves it to z
    EXPECT_NEAR((q * Vec3(1, 0, 0) - Vec3(0, 1, 0)).norm(), 0.0, 1e-15);   // z moves x to y
    EXPECT_NEAR(q.norm(), 1.0, 1e-15);
}

}  // namespace
}  // namespace engine
