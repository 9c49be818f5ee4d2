// Every misuse of a world stops the program with advice (world_checks.h), or has the answer that is
// documented.
#include "tests/engine/misuse.h"

namespace engine {
namespace {

using namespace misuse;

Misuse adding(const std::function<void(BodyDef&)>& change) {
    return [change](Scene& s) {
        BodyDef def = support::body(Shape::sphere(0.5), {0, 5, 0});
        change(def);
        s.world.add(def);
    };
}

Misuse setting(const std::function<void(Settings&)>& change) {
    return [change](Scene& s) {
        Settings settings;
        change(settings);
        s.world.setSettings(settings);
    };
}

TEST(MisuseDeathTest, OfShapes) {
    stops("a sphere needs", {[](Scene&) { Shape::sphere(0); }, [](Scene&) { Shape::sphere(kNan); },
                             [](Scene&) { Shape::sphere(kInf); }});
    stops("a box needs", {[](Scene&) {
                              Shape::box({1, 1, 0});
                          },
                          [](Scene&) {
                              Shape::box({1, kNan, 1});
                          },
                          [](Scene&) {
                              Shape::box({-1, 1, 1});
                          },
                          [](Scene&) { Shape::box(kEndless); }});
    stops("a capsule needs",
          {[](Scene&) { Shape::capsule(1, 1); }, [](Scene&) { Shape::capsule(kNan, 1); },
           [](Scene&) { Shape::capsule(1, kInf); }});
    stops("a plane needs", {[](Scene&) {
                                Shape::plane({0, 0, 0});
                            },
                            [](Scene&) { Shape::plane(kNowhere); }});
    stops("a cylinder needs",
          {[](Scene&) { Shape::cylinder(1, -1); }, [](Scene&) { Shape::cylinder(kNan, 1); }});
    stops("a cone needs",
          {[](Scene&) { Shape::cone(-1, 1); }, [](Scene&) { Shape::cone(1, kNan); }});
    stops("a height field needs",
          {[](Scene&) { Shape::heightField(1, 2, 1, std::vector<double>(2)); },
           [](Scene&) { Shape::heightField(2, 2, kNan, std::vector<double>(4)); },
           [](Scene&) { Shape::heightField(2, 2, 1, std::vector<double>(5)); }});
    stops("three corners",
          {[](Scene&) { Shape::heightField(2, 2, 1, std::vector<double>(4, kNan)); }});
}

TEST(MisuseDeathTest, OfParts) {
    const auto made = [](const std::function<void(ShapePart&)>& change) -> Misuse {
        return [change](Scene&) {
            ShapePart part;
            change(part);
            Shape::compound(std::vector{part});
        };
    };
    stops("at least one part", {[](Scene&) { Shape::compound({}); }});
    stops("cannot contain", {made([](ShapePart& p) { p.shape = Shape::plane({0, 1, 0}); })});
    stops("a positive density", {made([](ShapePart& p) { p.density = 0; }),
                                 made([](ShapePart& p) { p.density = kNan; })});
    stops("a finite place", {made([](ShapePart& p) { p.pose.position = kNowhere; }),
                             made([](ShapePart& p) { p.pose.rotation.coeffs().setZero(); })});
    stops("with a function of Shape",
          {made([](ShapePart& p) { p.shape.type = ShapeType::compound; }),
           made([](ShapePart& p) { p.shape.type = ShapeType::hull; })});
    stops("a centre of mass",
          {[](Scene&) { Shape::compound(std::vector<ShapePart>(1), kNowhere); }});
}

TEST(MisuseDeathTest, OfBodies) {
    stops("positive mass",
          {adding([](BodyDef& d) { d.mass = 0; }), adding([](BodyDef& d) { d.mass = -1; }),
           adding([](BodyDef& d) { d.mass = kNan; }), adding([](BodyDef& d) { d.mass = kInf; }),
           adding([](BodyDef& d) { d.mass = 1e-320; }),
           adding([](BodyDef& d) { d.mass.reset(), d.material.density = 0; }),
           adding([](BodyDef& d) { d.mass.reset(), d.material.density = kNan; })});
    stops("has no mass", {adding([](BodyDef& d) { d.shape = Shape::plane({0, 1, 0}); })});
    stops("an inertia tensor",
          {adding([](BodyDef& d) { d.inertia = Vec3(1, 1, 5).asDiagonal(); }),
           adding([](BodyDef& d) { d.inertia = Mat3::Zero(); }),
           adding([](BodyDef& d) { d.inertia = Mat3::Constant(kNan); }),
           adding([](BodyDef& d) { d.inertia = Mat3(Mat3::Identity()) * kInf; }),
           adding([](BodyDef& d) { (d.inertia = Mat3::Identity()).value()(0, 1) = 0.5; })});
    stops("a position must be finite",
          {adding([](BodyDef& d) { d.pose.position = kNowhere; }),
           adding([](BodyDef& d) { d.kind = BodyKind::fixed, d.pose.position = kNowhere; })});
    stops("a nonzero quaternion", {adding([](BodyDef& d) { d.pose.rotation.coeffs().setZero(); }),
                                   adding([](BodyDef& d) { d.pose.rotation.x() = kNan; }),
                                   adding([](BodyDef& d) { d.pose.rotation.w() = kInf; })});
    stops("a velocity and a spin", {adding([](BodyDef& d) { d.velocity = kNowhere; }),
                                    adding([](BodyDef& d) { d.spin = kEndless; })});
    stops("friction and rolling", {adding([](BodyDef& d) { d.material.friction = kNan; }),
                                   adding([](BodyDef& d) { d.material.friction = -1; }),
                                   adding([](BodyDef& d) { d.material.rolling = -1e-3; })});
    stops("a restitution", {adding([](BodyDef& d) { d.material.restitution = 5; }),
                            adding([](BodyDef& d) { d.material.restitution = -0.1; }),
                            adding([](BodyDef& d) { d.material.restitution = kNan; })});
    stops("no such friction rule",
          {adding([](BodyDef& d) { d.material.frictionRule = FrictionRule(17); })});
    stops("no such kind", {adding([](BodyDef& d) { d.kind = BodyKind(-1); })});
    stops("no such type of shape", {adding([](BodyDef& d) { d.shape.type = ShapeType(99); })});
    stops("make hulls",
          {adding([](BodyDef& d) { d.shape.type = ShapeType::hull; }),
           adding([](BodyDef& d) { d.kind = BodyKind::fixed, d.shape.type = ShapeType::mesh; })});
    stops("positive, finite sizes", {adding([](BodyDef& d) { d.shape.radius = kNan; }),
                                     adding([](BodyDef& d) { d.shape.radius = -1; })});
    stops("make it with Shape::box",
          {adding([](BodyDef& d) { d.shape.type = ShapeType::box, d.shape.halfSize.x() = -1; })});
}

TEST(MisuseDeathTest, OfSettings) {
    stops("at least one sub-step", {setting([](Settings& s) { s.substeps = 0; }),
                                    setting([](Settings& s) { s.substeps = -4; }),
                                    setting([](Settings& s) { s.sweeps = -1; }),
                                    setting([](Settings& s) { s.nudges = -1; })});
    stops("10000 sub-steps", {setting([](Settings& s) { s.substeps = 1'000'000'000; }),
                              setting([](Settings& s) { s.maxSubsteps = 0; })});
    stops("1000000 sweeps", {setting([](Settings& s) { s.sweeps = 2'000'000'000; }),
                             setting([](Settings& s) { s.minSweeps = -1; }),
                             setting([](Settings& s) { s.movingSweeps = -1; })});
    stops("restFactor", {setting([](Settings& s) { s.restFactor = 0; })});
    stops("never both", {setting([](Settings& s) { s.baumgarte = 0.2; })});
    stops("finite and not negative", {setting([](Settings& s) { s.tolerance = kNan; }),
                                      setting([](Settings& s) { s.slop = kNan; }),
                                      setting([](Settings& s) { s.speculativeMargin = kInf; }),
                                      setting([](Settings& s) { s.nudgeFactor = -1; }),
                                      setting([](Settings& s) { s.bounceSpeed = kNan; }),
                                      setting([](Settings& s) { s.depenetrationSpeed = -1; })});
    stops("sleepAfter", {setting([](Settings& s) { s.sleepAfter = 0; }),
                         setting([](Settings& s) { s.sleepAfter = kNan; })});
    stops("one thread", {setting([](Settings& s) { s.threads = 0; }),
                         setting([](Settings& s) { s.threads = 1'000'000; })});
    stops("no such method", {setting([](Settings& s) { s.method = Method(9); }),
                             setting([](Settings& s) { s.order = Order(-1); })});
}

TEST(MisuseDeathTest, OfCalls) {
    stops("no such body", {[](Scene& s) { (void)s.world.pose({7}); },
                           [](Scene& s) { (void)s.world.velocity({-1}); },
                           [](Scene& s) {
                               (void)s.world.mass({1, 3});
                           },
                           [](Scene& s) { s.world.remove(BodyId{7}); },
                           [](Scene& s) { s.world.remove(s.box), s.world.remove(s.box); },
                           [](Scene& s) {
                               s.world.remove(s.box), s.world.applyForce(s.box, {0, 1, 0});
                           },
                           [](Scene& s) { s.world.setPose({7}, {}); },
                           [](Scene& s) {
                               s.world.applyImpulse({7}, {0, 1, 0}, {0, 0, 0});
                           }});
    stops("no such joint", {[](Scene& s) { (void)s.world.joint({7}); },
                            [](Scene& s) { s.world.remove(s.rope), s.world.remove(s.rope); },
                            [](Scene& s) { s.world.setFreedom({7}, 0, {}); }});
    stops("no such force", {[](Scene& s) { s.world.remove(s.push), s.world.remove(s.push); },
                            [](Scene& s) { s.world.remove(ForceId{7}); }});
    stops("positive time",
          {[](Scene& s) { s.world.step(0); }, [](Scene& s) { s.world.step(-1); },
           [](Scene& s) { s.world.step(kNan); }, [](Scene& s) { s.world.step(kInf); }});
    stops("gravity must be finite", {[](Scene& s) { s.world.setGravity(kNowhere); }});
    stops("a nonzero quaternion", {[](Scene& s) {
                                       s.world.setPose(s.box, {{0, 0, 0}, Quat(0, 0, 0, 0)});
                                   },
                                   [](Scene& s) {
                                       s.world.setPose(s.box, {{0, 0, 0}, Quat(kNan, 0, 0, 0)});
                                   }});
    stops("a position must be finite", {[](Scene& s) {
              s.world.setPose(s.floor, {kNowhere, Quat::Identity()});
          }});
    stops("has a velocity", {[](Scene& s) { s.world.setVelocity(s.floor, {1, 0, 0}, {0, 0, 0}); }});
    stops("ends of a ray", {[](Scene& s) { (void)s.world.castRay(kNowhere, {0, 0, 0}); }});
}

/// Calls that change the world, from within its force field and its observer.
TEST(MisuseDeathTest, FromWithinAStep) {
    const Misuse changes[] = {[](Scene& s) { s.world.step(kStep); },
                              [](Scene& s) {
                                  s.world.add(support::body(Shape::sphere(1), {9, 9, 9}));
                              },
                              [](Scene& s) { s.world.remove(s.ball); },
                              [](Scene& s) { s.world.remove(s.rope); },
                              [](Scene& s) { s.world.remove(s.push); },
                              [](Scene& s) {
                                  s.world.add(ForceDef{Drag{}, {s.box}});
                              },
                              [](Scene& s) { s.world.setPose(s.box, {}); },
                              [](Scene& s) {
                                  s.world.setVelocity(s.box, {1, 0, 0}, {0, 0, 0});
                              },
                              [](Scene& s) {
                                  s.world.applyForce(s.box, {1, 0, 0});
                              },
                              [](Scene& s) {
                                  s.world.applyImpulse(s.box, {1, 0, 0}, {0, 0, 0});
                              },
                              [](Scene& s) { s.world.setFreedom(s.rope, 0, {}); },
                              [](Scene& s) {
                                  s.world.setGravity({0, 0, 0});
                              },
                              [](Scene& s) { s.world.setSettings({}); },
                              [](Scene& s) { s.world.findContacts(); },
                              [](Scene& s) { s.world.watchTouches(true); },
                              [](Scene& s) { s.world.setForceField({}); },
                              [](Scene& s) { s.world.observe({}); }};
    for (const Misuse& change : changes)
        stops("may only read its world",
              {[&change](Scene& s) {
                   s.world.setForceField([&](const World&, std::span<Load>) { change(s); });
                   s.world.step(kStep);
               },
               [&change](Scene& s) {
                   s.world.observe([&](Phase, int) { change(s); });
                   s.world.step(kStep);
               }});
}

TEST(Misuse, AFunctionThatThrowsLeavesTheWorldUsable) {
    Scene scene;
    scene.world.observe([](Phase, int) { throw 1; });
    EXPECT_THROW(scene.world.step(kStep), int);
    scene.world.observe({});
    scene.world.remove(scene.ball);
    EXPECT_TRUE(scene.world.step(kStep));
}

/// What is seen only in a step is reported, and the rest of the world goes on.
TEST(Misuse, LoadsAndVelocitiesWithoutAValueTakeTheirBodyOut) {
    const std::function<void(Scene&)> causes[] = {
        [](Scene& s) { s.world.applyForce(s.ball, kNowhere); },
        [](Scene& s) {
            s.world.applyImpulse(s.ball, kEndless, {0, 0, 0});
        },
        [](Scene& s) {
            s.world.setVelocity(s.ball, kNowhere, {0, 0, 0});
        },
        [](Scene& s) {
            s.world.setForceField([ball = s.ball.index](const World& w, std::span<Load> loads) {
                if (w.has({ball})) loads[ball].torque = kNowhere;
            });
        }};
    for (const auto& cause : causes) {
        Scene scene;
        cause(scene);
        EXPECT_TRUE(scene.world.step(kStep));
        ASSERT_EQ(scene.world.report().incidents.size(), 1u);
        EXPECT_EQ(scene.world.report().incidents[0].body, scene.ball);
        EXPECT_FALSE(scene.world.has(scene.ball));
        EXPECT_TRUE(scene.world.step(kStep) && scene.world.pose(scene.box).position.allFinite());
    }
}

TEST(Misuse, AKinematicBodyWithoutAVelocityIsTakenOutToo) {
    Scene scene;
    BodyDef def = support::body(Shape::box({1, 1, 1}), {9, 9, 9});
    def.kind = BodyKind::kinematic;
    const BodyId belt = scene.world.add(def);
    scene.world.setVelocity(belt, kNowhere, {0, 0, 0});
    EXPECT_TRUE(scene.world.step(kStep));
    EXPECT_FALSE(scene.world.has(belt));
    EXPECT_TRUE(scene.world.has(scene.box) && scene.world.has(scene.ball));
}

}  // namespace
}  // namespace engine
