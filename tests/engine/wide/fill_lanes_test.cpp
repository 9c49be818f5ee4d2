// Manifolds that are written into lanes together have the frames that each has alone, to the last bit.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "engine/constraints/manifold_frame.h"
#include "engine/wide/contact_kernels.h"

namespace engine {
namespace {

struct Manifold8 {
    std::array<Contact, 8> contacts;
    std::array<Mat3, 8> axesA, axesB;
    std::array<Vec3, 8> apart;
};

Manifold8 someManifolds(unsigned seed) {
    std::mt19937 random(seed);
    const auto number = [&] { return static_cast<double>(random()) / 2147483648.0 - 1.0; };
    const auto vector = [&] { return Vec3(number(), number(), number()); };
    Manifold8 m;
    for (int lane = 0; lane < 8; ++lane) {
        Contact& c = m.contacts[lane];
        c.count = lane % 5;  // one lane has none
        c.normal = lane % 2 == 0 ? Vec3::Unit(lane / 2 % 3) : vector().normalized();
        if (lane % 3 == 0) c.slideA = 0.1 * vector(), c.slideB = 0.1 * vector();
        c.rollingMoment = vector();
        for (int i = 0; i < c.count; ++i)
            c.points[i] = {vector(), vector(), i, number(), vector()};
        m.axesA[lane] = Quat(number(), number(), number(), number()).normalized().toRotationMatrix();
        m.axesB[lane] = Quat(number(), number(), number(), number()).normalized().toRotationMatrix();
        m.apart[lane] = 2.0 * vector();
    }
    return m;
}

void put(double (&x)[3][8], int lane, const Vec3& v) {
    for (int i = 0; i < 3; ++i) x[i][lane] = v[i];
}

ContactInputs inputsOf(const Manifold8& m) {
    ContactInputs inputs{};
    for (int lane = 0; lane < 8; ++lane) {
        const Contact& c = m.contacts[lane];
        inputs.count[lane] = c.count;
        put(inputs.normal, lane, c.normal), put(inputs.apart, lane, m.apart[lane]);
        put(inputs.slideA, lane, c.slideA), put(inputs.slideB, lane, c.slideB);
        put(inputs.rollingMoment, lane, c.rollingMoment);
        for (int i = 0; i < c.count; ++i) {
            put(inputs.anchorA[i], lane, c.points[i].anchorA), put(inputs.anchorB[i], lane, c.points[i].anchorB);
            put(inputs.friction[i], lane, c.points[i].friction);
            inputs.impulse[i][lane] = c.points[i].impulse;
        }
        for (int i = 0; i < 9; ++i) {
            inputs.axesA[i][lane] = m.axesA[lane].data()[i];
            inputs.axesB[i][lane] = m.axesB[lane].data()[i];
        }
    }
    return inputs;
}

void expectSame(const float (&x)[3][8], int lane, const Vec3& v) {
    for (int i = 0; i < 3; ++i) EXPECT_EQ(x[i][lane], static_cast<float>(v[i])) << lane << ' ' << i;
}

void expectFrameOf(const Manifold8& m, int lane, const ContactBatch& batch, const ContactRecord& record) {
    const Contact& c = m.contacts[lane];
    Vec3 armA[4], between[4];
    double open = 0.0;
    for (int i = 0; i < c.count; ++i) {
        armA[i] = m.axesA[lane] * c.points[i].anchorA;
        between[i] = m.axesB[lane] * c.points[i].anchorB - armA[i];
        const double gap = c.normal.dot(between[i] - m.apart[lane]);
        open = i == 0 ? gap : smaller(open, gap);
    }
    open = larger(open, 0.0);
    const Vec3 offset = m.apart[lane] + open * c.normal;
    ManifoldFrame frame;
    for (int i = 0; i < c.count; ++i) {
        const Vec3 left = between[i] - offset;
        frame.add(armA[i] + 0.5 * left + c.slideA, c.normal.dot(left) + open);
    }
    frame.finish(c.normal);
    expectSame(batch.n, lane, c.normal), expectSame(batch.t1, lane, frame.t1), expectSame(batch.t2, lane, frame.t2);
    expectSame(batch.centre, lane, frame.centre);
    expectSame(batch.offset, lane, offset + c.slideB - c.slideA);
    EXPECT_EQ(batch.reach[lane], static_cast<float>(frame.reach));
    EXPECT_EQ(batch.roll.moment[0][lane], static_cast<float>(c.rollingMoment.dot(frame.t1)));
    EXPECT_EQ(batch.roll.moment[1][lane], static_cast<float>(c.rollingMoment.dot(frame.t2)));
    for (int i = 0; i < c.count; ++i) {
        const WidePoint& point = batch.point[i];
        EXPECT_EQ(point.x[lane], static_cast<float>(frame.x[i])) << lane << ' ' << i;
        EXPECT_EQ(point.y[lane], static_cast<float>(frame.y[i])) << lane << ' ' << i;
        EXPECT_EQ(point.lambda[lane], static_cast<float>(c.points[i].impulse));
        EXPECT_EQ(point.friction[0][lane], static_cast<float>(c.points[i].friction.dot(frame.t1)));
        EXPECT_EQ(point.friction[1][lane], static_cast<float>(c.points[i].friction.dot(frame.t2)));
        EXPECT_EQ(record.gapAtStart[i][lane], static_cast<float>(frame.gap[i])) << lane << ' ' << i;
    }
}

TEST(FillLanes, GivesEachManifoldItsOwnFrame) {
    for (const Instructions set : {Instructions::baseline, Instructions::best})
        for (unsigned seed = 0; seed < 50; ++seed) {
            const Manifold8 m = someManifolds(seed);
            ContactBatch batch{};
            ContactRecord record{};
            contactKernels(set).fill(inputsOf(m), batch, record);
            for (int lane = 0; lane < 8; ++lane) {
                if (m.contacts[lane].count > 0) expectFrameOf(m, lane, batch, record);
                for (int i = m.contacts[lane].count; i < ContactBatch::kPoints; ++i) {
                    EXPECT_EQ(record.separation[i][lane], kNoPoint);
                    EXPECT_EQ(batch.point[i].x[lane], 0.0f);
                    EXPECT_EQ(batch.point[i].lambda[lane], 0.0f);
                }
            }
        }
}

}  // namespace
}  // namespace engine
