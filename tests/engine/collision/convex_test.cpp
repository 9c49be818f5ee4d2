// Pairs of general convex shapes compared with an independent measure: the largest separation over many
// directions, each improved to a local maximum.
#include <gtest/gtest.h>

#include "engine/base/trigonometry.h"
#include "engine/collision/collide.h"
#include "engine/collision/collide_convex.h"
#include "engine/collision/way_out.h"
#include "engine/world.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

Shape wedge() {
    const Vec3 points[] = {{0, 0, 0}, {1, 0, 0}, {0, 0, 0.8}, {1, 0, 0.8}, {0, 0.6, 0}, {0, 0.6, 0.8}};
    return *Shape::hullOf(points);
}

/// Twelve corners, twenty faces.
Shape icosahedron() {
    const double g = 0.5 * (1.0 + std::sqrt(5.0));
    std::vector<Vec3> points;
    for (const double a : {-0.3, 0.3})
        for (const double b : {-0.3 * g, 0.3 * g})
            for (const Vec3& p : {Vec3(0, a, b), Vec3(a, b, 0), Vec3(b, 0, a)}) points.push_back(p);
    return *Shape::hullOf(points);
}

const std::vector<Shape>& shapes() {
    static const std::vector<Shape> all{Shape::sphere(0.4),      Shape::box({1.0, 0.7, 1.4}),
                                        Shape::capsule(0.25, 1.3), Shape::cylinder(0.4, 0.9),
                                        Shape::cone(0.45, 1.1),  wedge(), icosahedron()};
    return all;
}

struct ConvexPair {
    int a, b;
};
void PrintTo(const ConvexPair& pair, std::ostream* out) { *out << pair.a << " and " << pair.b; }

std::vector<ConvexPair> pairsWithNew() {
    std::vector<ConvexPair> pairs;
    for (int a = 0; a < 7; ++a)
        for (int b = a < 3 ? 3 : a; b < 7; ++b) pairs.push_back({a, b});
    return pairs;
}

double separation(const Convex& a, const Convex& b, const Vec3& n) {
    return separationOfCores(a, b, n) - a.radius() - b.radius();
}

/// max over n of s(n): from the best of many directions, refined by ever smaller steps.
double largestSeparation(const Convex& a, const Convex& b) {
    support::Random random(5);
    std::vector<std::pair<double, Vec3>> starts;
    for (int i = 0; i < 400; ++i) {
        const Vec3 n = random.rotation() * Vec3::UnitX();
        starts.push_back({separation(a, b, n), n});
    }
    std::sort(starts.begin(), starts.end(),
              [](const auto& l, const auto& r) { return l.first > r.first; });
    double best = -1e9;
    for (int k = 0; k < 12; ++k) {
        auto [top, n] = starts[k];
        for (double step = 0.2; step > 1e-7;) {
            bool climbed = false;
            for (int i = 0; i < 12; ++i) {
                const Vec3 m = (n + step * (random.rotation() * Vec3::UnitX())).normalized();
                if (const double s = separation(a, b, m); s > top) top = s, n = m, climbed = true;
            }
            if (!climbed) step *= 0.5;
        }
        best = larger(best, top);
    }
    return best;
}

class ConvexPairs : public testing::TestWithParam<ConvexPair> {};

TEST_P(ConvexPairs, ClosestPointsAreApartByTheLargestSeparation) {
    const Shape &shapeA = shapes()[GetParam().a], &shapeB = shapes()[GetParam().b];
    support::Random random(100 + 10 * GetParam().a + GetParam().b);
    int apart = 0;
    for (int i = 0; i < 60; ++i) {
        const Pose poseA{random.vector(1.1), random.rotation()}, poseB{Vec3::Zero(), random.rotation()};
        const Convex a(shapeA, poseA), b(shapeB, poseB);
        const ConvexGap gap = gapOf(a, b);
        EXPECT_NEAR(gap.normal.norm(), 1.0, 1e-12);
        const double largest = largestSeparation(a, b);
        if (largest < -0.02) {  // deep: a way out, if not always the shortest
            EXPECT_LT(gap.distance, 0.0);
            EXPECT_GT(gap.distance, -a.reach() - a.radius() - b.reach() - b.radius());
            continue;
        }
        ++apart;
        EXPECT_NEAR(gap.distance, largest, 2e-4) << i;
        EXPECT_NEAR(separation(a, b, gap.normal), gap.distance, 2e-5) << i;
    }
    EXPECT_GT(apart, 10);
}

/// A search that ends early has a distance between what was enough and the true one.
TEST_P(ConvexPairs, ADistanceThatIsEnoughIsNeverTooLarge) {
    const Shape &shapeA = shapes()[GetParam().a], &shapeB = shapes()[GetParam().b];
    support::Random random(900 + 10 * GetParam().a + GetParam().b);
    for (int i = 0; i < 40; ++i) {
        const Pose poseA{Vec3::Zero(), random.rotation()}, poseB{random.rotation() * Vec3(4, 0, 0), random.rotation()};
        const Convex a(shapeA, poseA), b(shapeB, poseB);
        const double exact = closestPoints(a, b, Vec3::Zero()).distance;
        for (const double enough : {0.1 * exact, 0.7 * exact, 0.97 * exact}) {
            const double found = closestPoints(a, b, Vec3::Zero(), enough).distance;
            EXPECT_LE(found, exact + 1e-9) << i << ' ' << enough;
            EXPECT_GE(found, enough) << i;
        }
    }
}

/// Two shapes moved until they just touch or overlap a little: the manifold agrees.
TEST_P(ConvexPairs, ManifoldsTellTheDepthOfTouchingPairs) {
    const Shape &shapeA = shapes()[GetParam().a], &shapeB = shapes()[GetParam().b];
    support::Random random(500 + 10 * GetParam().a + GetParam().b);
    for (const double wanted : {0.01, 1e-4, -1e-4, -1e-3})
        for (int i = 0; i < 40; ++i) {
            const Pose poseA{Vec3::Zero(), random.rotation()};
            Pose poseB{random.rotation() * Vec3(5, 0, 0), random.rotation()};
            const ConvexGap far = gapOf({shapeA, poseA}, {shapeB, poseB});
            poseB.position -= (far.distance - wanted) * far.normal;
            const double gap = gapOf({shapeA, poseA}, {shapeB, poseB}).distance;
            // On the way in the normal may turn, so the way out may be shorter.
            EXPECT_GE(gap, wanted - 5e-5);
            const Manifold m = collide(shapeA, poseA, shapeB, poseB, 0.02);
            ASSERT_GT(m.count, 0) << wanted << ' ' << i;
            EXPECT_NEAR(m.normal.norm(), 1.0, 1e-12);
            double deepest = 1e9;
            for (int k = 0; k < m.count; ++k) {
                const Vec3 between = m.points[k].onB - m.points[k].onA;
                EXPECT_LT(between.cross(m.normal).norm(), 1e-9);
                deepest = smaller(deepest, between.dot(m.normal));
            }
            EXPECT_NEAR(deepest, gap, 2.5e-3) << wanted << ' ' << i;  // a face may be off by 2 mm
        }
}

/// A lower bound of the distance; with a ball, the distance.
TEST(ConvexTriangles, AreApartAtLeastByTheirNearestPoint) {
    const Vec3 corners[] = {{0, 0, 0}, {1, 0, 0.3}, {0.2, 0.1, 1}};
    const std::array<int, 3> triangles[] = {{0, 2, 1}};
    const Shape mesh = Shape::meshOf(corners, triangles);
    support::Random random(8);
    for (int run = 0; run < 300; ++run) {
        const Shape& shape = shapes()[run % shapes().size()];
        const Pose poseA{random.vector(1.0), random.rotation()},
            poseB{random.vector(1.0), random.rotation()};
        const Convex triangle(*mesh.mesh, 0, poseA), piece(shape, poseB);
        const double apart = apartFromTriangle(triangle, piece);
        if (apart <= 0.0) continue;
        const double distance =
            closestPoints(triangle, piece, Vec3::Zero()).distance - piece.radius();
        EXPECT_LE(apart, distance + 1e-12);
        if (shape.type == ShapeType::sphere) {
            EXPECT_NEAR(apart, distance, 1e-12);
        }
    }
}

TEST(ConvexFaces, NoneIsBetterThanTheOneThatIsFound) {
    support::Random random(31);
    int faces = 0;
    for (int k = 0; k < 300; ++k) {
        std::vector<Vec3> points;
        for (int i = 0; i < 40; ++i) points.push_back(0.5 * random.vector(1.0).normalized());
        const Shape hull = *Shape::hullOf(points), other = k % 2 ? icosahedron() : wedge();
        const Pose poseB{0.8 * random.vector(1.0).normalized(), random.rotation()};
        const Convex a(hull, {Vec3::Zero(), random.rotation()}), b(other, poseB);
        const Manifold m = collideConvex(a, b, 0.02);
        double best = -1e300;
        for (int i = 0; i < a.faceCount(); ++i)
            best = larger(best, separationOfCores(a, b, a.faceNormal(i)));
        for (int i = 0; i < b.faceCount(); ++i)
            best = larger(best, separationOfCores(a, b, -b.faceNormal(i)));
        if (best > 0.02) {
            EXPECT_EQ(m.count, 0) << k;
        }
        if (m.count < 2) continue;  // edges and corners differ
        EXPECT_GE(separationOfCores(a, b, m.normal), best - 5.1e-4) << k;  // b's faces have a handicap
        ++faces;
    }
    EXPECT_GT(faces, 100);
}

INSTANTIATE_TEST_SUITE_P(All, ConvexPairs, testing::ValuesIn(pairsWithNew()));

struct Rest {
    const char* name;
    Shape shape;
    double height;  // of its centre above the ground
    Quat turn;
    int points;
};

std::vector<Rest> rests() {
    const Quat lying = turnAbout(Vec3::UnitZ(), radians(90));
    return {{"cylinder", Shape::cylinder(0.4, 1.0), 0.5, Quat::Identity(), 4},
            {"lying cylinder", Shape::cylinder(0.4, 1.0), 0.4, lying, 2},
            {"cone", Shape::cone(0.4, 1.0), 0.25, Quat::Identity(), 4},
            {"lying cone", Shape::cone(0.4, 1.0), 0.75 * 0.4 / std::sqrt(1.16),
             turnAbout(Vec3::UnitZ(), kPi / 2 + arctangent(0.4, 1.0)), 2},
            {"wedge", wedge(), 0.2, Quat::Identity(), 4}};
}

TEST(ConvexRest, LiesOnPlanesBoxesAndCylindersWithItsWholeFeature) {
    const Shape grounds[] = {Shape::plane({0, 1, 0}), Shape::box({6, 1, 6}),
                             Shape::cylinder(3, 1)};
    for (const Shape& ground : grounds)
        for (const Rest& rest : rests()) {
            const bool plane = ground.type == ShapeType::plane;
            const Pose below{{0, plane ? 0.0 : -0.5, 0}, Quat::Identity()};
            const Manifold m = collide(ground, below, rest.shape,
                                       {{0.1, rest.height - 5e-4, 0.2}, rest.turn}, 0.02);
            ASSERT_EQ(m.count, rest.points) << rest.name;
            EXPECT_LT((m.normal - Vec3::UnitY()).norm(), 1e-12) << rest.name;
            for (int i = 0; i < m.count; ++i) EXPECT_NEAR(m.separation(i), -5e-4, 1e-9) << rest.name;
        }
}

TEST(ConvexRest, CylindersSideBySideTouchAlongALine) {
    const Shape log = Shape::cylinder(0.3, 2.0);
    const Quat lying = turnAbout(Vec3::UnitX(), radians(90));
    for (const double gap : {5e-3, -5e-4}) {
        const Manifold m = collide(log, {{0, 0, 0}, lying}, log, {{0.6 + gap, 0, 0.4}, lying}, 0.02);
        ASSERT_EQ(m.count, 2) << gap;
        EXPECT_LT((m.normal - Vec3::UnitX()).norm(), 1e-5);
        EXPECT_NEAR(std::abs(m.points[0].onA.z() - m.points[1].onA.z()), 1.6, 1e-6);
        EXPECT_NEAR(m.separation(0), gap, 1e-6);
    }
}

TEST(ConvexRest, ConcentricShapesGetSomeNormalAndNoNaN) {
    for (const Shape& a : shapes())
        for (const Shape& b : shapes()) {
            const Manifold m = collide(a, {}, b, {}, 0.02);
            ASSERT_GT(m.count, 0);
            EXPECT_NEAR(m.normal.norm(), 1.0, 1e-12);
            for (int i = 0; i < m.count; ++i) EXPECT_TRUE(m.points[i].onB.allFinite());
        }
}

// Overlaps of less than 0.1 mm. With four nearly coplanar corners, GJK took the origin for inside of them, though the
// pieces were apart, and these were up to 27 mm deep.
TEST(ConvexRims, TouchingAlmostNotAtAllAreNotDeep) {
    const Shape cylinder = Shape::cylinder(0.1, 0.2), cone = Shape::cone(0.1, 0.3);
    struct Pair {
        Shape a, b;
        Vec3 atA, atB;
        Quat turnA, turnB;
    };
    const Pair pairs[] = {  // whether it happened hung on the last bits
        {cylinder, cylinder, {9, 2, 3}, {9.218611843407285, 2.0058083589353077, 2.941405892981467},
         {-0.19150023317958018, -0.4945819492574653, 0.09734819076768861, -0.8421636930639496},
         {-0.40135127259657716, 0.787551743185947, 0.06500261463898274, -0.46413007739268713}},
        {cone, cone, {8, 24, 3}, {8.184669091866164, 23.9164611254019, 2.9882538612878813},
         {0.27982033104082876, -0.798117620281213, 0.10997734618540556, 0.5221243432927352},
         {0.17223434967632112, 0.2626435261889892, -0.08259784965729196, -0.9446061971517852}},
        {cone, Shape::box({0.2, 0.2, 0.2}), {12, 4, 0}, {11.871952183471613, 4.109340600087109, -0.18401787525690386},
         {-0.3725166561883225, -0.6966222029417067, -0.6098671889550887, -0.06333134347961268},
         {0.7463491350861635, 0.5039660693422189, 0.383174751531376, 0.20308939458984215}},
        {cylinder, cylinder, {-0.687545529288133, 0.23772412946705637, -0.04941542770644303},
         {-0.48952917527460416, 0.32016591157369545, -0.1830680458434411},
         {-0.5622935398321898, 0.21003380021041887, -0.207922391283729, 0.7723212136378305},
         {-0.17101983946008723, 0.9044888563165615, 0.29151399507013054, 0.260137874959523}}};
    for (const Pair& pair : pairs) {
        World world;
        BodyDef a = support::fixed(pair.a), b = support::body(pair.b, pair.atB);
        a.pose = {pair.atA, pair.turnA}, b.pose.rotation = pair.turnB;
        world.add(a), world.add(b);
        world.findContacts();
        EXPECT_LT(world.errors().penetration, 1e-4) << "pair " << &pair - pairs;
    }
}

}  // namespace
}  // namespace engine
