// The submerged volume of a body and its centroid, compared with closed forms.
#include "engine/forces/submerged.h"

#include <gtest/gtest.h>

#include "engine/base/trigonometry.h"
#include "engine/forces/medium.h"
#include "engine/shapes/mass.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

using support::at;

constexpr double kEverything = 1e9;

TEST(Submerged, HalfABallHasItsMiddleThreeEighthsOfARadiusDown) {
    const Shape ball = Shape::sphere(0.5);
    const SubmergedPart part = submergedPart(ball, at({1, 2, 3}), Vec3::UnitY(), 2.0);
    EXPECT_NEAR(part.volume, 0.5 * volume(ball), 1e-15);
    EXPECT_LT((part.centre - Vec3(1, 2 - 3.0 / 8 * 0.5, 3)).norm(), 1e-15);
}

// A cap of depth d: pi d^2 (3 r - d) / 3.
TEST(Submerged, ACapOfABall) {
    const SubmergedPart part =
        submergedPart(Shape::sphere(2.0), at(Vec3::Zero()), Vec3::UnitY(), -1.5);
    EXPECT_NEAR(part.volume, kPi * 0.25 * 5.5 / 3.0, 1e-14);
}

TEST(Submerged, AnUprightBoxIsABox) {
    const SubmergedPart part =
        submergedPart(Shape::box({2, 4, 3}), at({5, 0, 5}), Vec3::UnitY(), -1.0);
    EXPECT_NEAR(part.volume, 2 * 1 * 3, 1e-13);
    EXPECT_LT((part.centre - Vec3(5, -1.5, 5)).norm(), 1e-13);
}

// A cube on its edge, the surface through its middle: a prism of a right triangle, half the cube,
// whose centroid is a third of the half diagonal down.
TEST(Submerged, ABoxOnItsEdgeIsAPrism) {
    const Quat turn = turnAbout(Vec3::UnitZ(), kPi / 4);
    const SubmergedPart part =
        submergedPart(Shape::box({1, 1, 1}), at(Vec3::Zero(), turn), Vec3::UnitY(), 0.0);
    EXPECT_NEAR(part.volume, 0.5, 1e-14);
    EXPECT_LT((part.centre - Vec3(0, -std::sqrt(0.5) / 3, 0)).norm(), 1e-14);
}

// The parts below a plane and below its reverse add up to the whole body.
TEST(Submerged, TwoSidesOfASurfaceAreTheWholeBody) {
    support::Random random(7);
    const Vec3 corners[] = {{0, 0, 0}, {2, 0.1, 0}, {0.2, 1.8, 0.1}, {0.1, 0.2, 2}, {1.5, 1.4, 1}};
    const ShapePart parts[] = {{Shape::box({0.6, 0.8, 1.3}), {{0.2, 0, 0}, Quat::Identity()}},
                               {Shape::sphere(0.6), {{1.1, 0.6, 0}, Quat::Identity()}}};
    for (const Shape& shape :
         {Shape::box({1, 2, 3}), Shape::sphere(0.8), Shape::capsule(0.4, 2.5),
          Shape::cylinder(0.6, 1.4), Shape::cone(0.8, 1.5), *Shape::hullOf(corners),
          Shape::compound(parts)})
        for (int i = 0; i < 200; ++i) {
            const Pose pose = at(random.vector(0.5), random.rotation());
            const Vec3 up = random.vector(1).normalized();
            const double level = random.number(-1, 1);
            const SubmergedPart below = submergedPart(shape, pose, up, level);
            const SubmergedPart above = submergedPart(shape, pose, -up, -level);
            EXPECT_NEAR(below.volume + above.volume, volume(shape), 1e-12);
            const Vec3 moment = below.volume * below.centre + above.volume * above.centre;
            EXPECT_LT((moment - volume(shape) * pose.position).norm(), 1e-12);
        }
}

// The cylinder between the ends is approximated by balls: a few per cent error half way in.
TEST(Submerged, ALyingCapsuleIsHalfUnderAtItsMiddleAndAllOfItBelow) {
    const Shape capsule = Shape::capsule(0.3, 2.0);
    const Quat lying = turnAbout(Vec3::UnitZ(), kPi / 2);
    EXPECT_NEAR(submergedPart(capsule, at(Vec3::Zero(), lying), Vec3::UnitY(), 0.0).volume,
                0.5 * volume(capsule), 1e-14);
    EXPECT_NEAR(submergedPart(capsule, at(Vec3::Zero()), Vec3::UnitY(), 1.0).volume,
                volume(capsule), 1e-14);
    EXPECT_EQ(submergedPart(capsule, at({0, 1.01, 0}), Vec3::UnitY(), 0.0).volume, 0.0);
}

// The submerged share of an upright cylinder and cone: h / H, and 1 - (1 - h / H)^3.
TEST(Submerged, AnUprightCylinderAndConeAreAsTheirSections) {
    const Shape cylinder = Shape::cylinder(0.5, 2.0), cone = Shape::cone(0.5, 2.0);
    EXPECT_NEAR(submergedPart(cylinder, at(Vec3::Zero()), Vec3::UnitY(), -0.4).volume,
                0.3 * volume(cylinder), 1e-12);
    EXPECT_NEAR(submergedPart(cone, at(Vec3::Zero()), Vec3::UnitY(), 0.0).volume,
                (1.0 - 0.75 * 0.75 * 0.75) * volume(cone), 1e-12);
}

// The projection of a cylinder is a rectangle from the side and a disc along its axis; of a cone, a
// triangle.
TEST(Submerged, ShadowsOfRoundThings) {
    const Quat upright = Quat::Identity();
    EXPECT_NEAR(shadowOf(Shape::cylinder(0.5, 2.0), upright, Vec3::UnitX()), 2.0, 0.02);
    EXPECT_NEAR(shadowOf(Shape::cylinder(0.5, 2.0), upright, Vec3::UnitY()), kPi * 0.25, 0.01);
    EXPECT_NEAR(shadowOf(Shape::cone(0.5, 2.0), upright, Vec3::UnitZ()), 1.0, 0.01);
}

TEST(Submerged, WithoutASurfaceAllOfItIs) {
    const Shape box = Shape::box({1, 2, 3});
    const double noEnd = Medium::kNoEnd;
    const SubmergedPart part = submergedPart(box, at({0, kEverything, 0}), Vec3::UnitY(), noEnd);
    EXPECT_EQ(part.volume, volume(box));
    EXPECT_EQ(part.centre.y(), kEverything);
}

TEST(Shadow, OfABoxIsTheSumOfItsFacesAndOfACapsuleAStadium) {
    const Quat upright = Quat::Identity();
    EXPECT_NEAR(shadowOf(Shape::box({1, 2, 3}), upright, Vec3::UnitX()), 6.0, 1e-14);
    EXPECT_NEAR(shadowOf(Shape::box({1, 1, 1}), upright, Vec3(1, 1, 1).normalized()),
                std::sqrt(3.0), 1e-14);
    EXPECT_NEAR(shadowOf(Shape::sphere(2), upright, Vec3::UnitZ()), 4 * kPi, 1e-14);
    const Shape capsule = Shape::capsule(0.5, 3.0);
    EXPECT_NEAR(shadowOf(capsule, upright, Vec3::UnitX()), kPi / 4 + 2.0, 1e-14);
    EXPECT_NEAR(shadowOf(capsule, upright, Vec3::UnitY()), kPi / 4, 1e-14);
}

}  // namespace
}  // namespace engine
