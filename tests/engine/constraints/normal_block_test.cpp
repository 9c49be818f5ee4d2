#include "engine/constraints/normal_block.h"

#include <gtest/gtest.h>

#include "tests/support/worlds.h"

namespace engine {
namespace {

NormalBlock blockOf(int count, support::Random& random, bool coplanar) {
    const InverseMass still, mass{1.0, 6.0 * Mat3::Identity()};
    const double corners[4][2] = {{-.5, -.5}, {.5, -.5}, {.5, .5}, {-.5, .5}};
    std::vector<Row> rows;
    for (int i = 0; i < count; ++i) {
        const Vec3 arm = coplanar ? Vec3(corners[i][0], -0.5, corners[i][1]) : random.vector(1);
        rows.push_back(makeRow(alongDirection({0, 1, 0}, Vec3::Zero(), arm), still, mass));
    }
    return makeNormalBlock(count, [&](int i) -> const Row& { return rows[i]; });
}

TEST(NormalBlock, FindsTheComplementarySolution) {
    support::Random random(1);
    for (int i = 0; i < 5000; ++i) {
        const int count = 1 + i % 4;
        const NormalBlock block = blockOf(count, random, i % 2 == 0);
        Vec4 q = Vec4::Zero();
        for (int k = 0; k < count; ++k) q[k] = random.number(-1, 1);
        const Vec4 lambda = solveNormalBlock(block, q);
        const Vec4 w = block.k * lambda + q;
        for (int k = 0; k < count; ++k) {
            EXPECT_GE(lambda[k], 0.0);
            EXPECT_GE(w[k], -1e-8);
            EXPECT_NEAR(lambda[k] * w[k], 0.0, 1e-7);
        }
        for (int k = count; k < 4; ++k) EXPECT_EQ(lambda[k], 0.0);
    }
}

TEST(NormalBlock, SharesAnEvenLoadEvenly) {
    support::Random random(2);
    const NormalBlock block = blockOf(4, random, true);
    const Vec4 lambda = solveNormalBlock(block, Vec4(Vec4::Constant(-1.0)));
    EXPECT_NEAR(lambda.sum(), 1.0, 1e-3);  // m v; the raised diagonal costs a quarter per mille
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(lambda[i], lambda.sum() / 4, 1e-12);
}

}  // namespace
}  // namespace engine
