// Joints and forces that are no joints and forces stop the program with advice (world_checks.h).
#include "tests/engine/misuse.h"

namespace engine {
namespace {

using namespace misuse;

Misuse joining(const std::function<void(JointDef&)>& change) {
    return [change](Scene& s) {
        JointDef def;
        def.a = s.box, def.b = s.ball;
        change(def);
        s.world.add(def);
    };
}

Misuse driving(JointType type, const std::function<void(Freedom&)>& change) {
    return joining([=](JointDef& def) {
        def.type = type;
        change(def.free[0]);
    });
}

Misuse pushing(const ForceKind& kind) {
    return [kind](Scene& s) { s.world.add(ForceDef{kind, {s.box, s.ball}}); };
}

template <class Change>
Misuse flying(const Change& change) {
    Airfoil wing;
    change(wing);
    return pushing(wing);
}

TEST(MisuseDeathTest, OfJoints) {
    stops("two bodies of this world",
          {joining([](JointDef& d) { d.a = {}; }), joining([](JointDef& d) { d.b = {70}; }),
           [](Scene& s) {
               s.world.remove(s.box);
               support::join(s.world, JointType::ball, s.box, s.ball, {0, 0, 0});
           }});
    stops("two different bodies", {joining([](JointDef& d) { d.b = d.a; })});
    stops("must be dynamic", {[](Scene& s) {
              const BodyId wall = s.world.add(support::hook());
              support::join(s.world, JointType::ball, s.floor, wall, {0, 0, 0});
          }});
    stops("no such type", {joining([](JointDef& d) { d.type = JointType(40); })});
    stops("anchors, axes and ratio", {joining([](JointDef& d) { d.anchorA = kNowhere; }),
                                      joining([](JointDef& d) { d.anchorB = kEndless; }),
                                      joining([](JointDef& d) { d.axis = kNowhere; }),
                                      joining([](JointDef& d) { d.axis2 = kNowhere; }),
                                      joining([](JointDef& d) { d.ratio = kNan; })});
    stops("axis must not be zero", {joining([](JointDef& d) { d.axis.setZero(); })});
    stops("positive length", {joining([](JointDef& d) { d.type = JointType::distance; })});
    stops("length must be", {joining([](JointDef& d) { d.length = -1; }),
                             joining([](JointDef& d) { d.length = kNan; })});
    stops("right angles",
          {joining([](JointDef& d) { d.type = JointType::universal; }), joining([](JointDef& d) {
               d.type = JointType::wheel, d.axis2 = {0, 1, 1};
           })});
    stops("a gear's ratio", {joining([](JointDef& d) { d.type = JointType::gear, d.ratio = 0; })});
    stops("two points", {joining([](JointDef& d) { d.type = JointType::path; })});
    stops("path's points", {joining([](JointDef& d) {
              d.type = JointType::path, d.path = {kNowhere, kNowhere};
          })});
    stops("breakForce", {joining([](JointDef& d) { d.breakForce = 0; }),
                         joining([](JointDef& d) { d.breakTorque = kNan; })});
    stops("a spring's frequency", {joining([](JointDef& d) { d.spring.hz = -1; }),
                                   joining([](JointDef& d) { d.spring.damping = kNan; }),
                                   joining([](JointDef& d) { d.spring.stiffness = kInf; })});
}

TEST(MisuseDeathTest, OfCoordinates) {
    stops("no such coordinate",
          {driving(JointType::weld, [](Freedom& f) { f.motor.strength = 1; })});
    stops("swing is coordinate 1",
          {driving(JointType::constantVelocity, [](Freedom& f) { f.inertia = 1; })});
    stops("only a sixDof", {driving(JointType::hinge, [](Freedom& f) { f.locked = true; })});
    stops("a lower limit", {driving(JointType::hinge,
                                    [](Freedom& f) {
                                        f.limits = {1, 0};
                                    }),
                            driving(JointType::hinge, [](Freedom& f) { f.limits.low = kNan; })});
    stops("motor's strength",
          {driving(JointType::hinge, [](Freedom& f) { f.motor.strength = -1; }),
           driving(JointType::hinge, [](Freedom& f) { f.motor.strength = kNan; })});
    stops("motor's speed", {driving(JointType::hinge,
                                    [](Freedom& f) {
                                        f.motor = {kNan, 1};
                                    }),
                            driving(JointType::hinge, [](Freedom& f) { f.rest = kInf; })});
    stops("rotor's inertia", {driving(JointType::hinge, [](Freedom& f) { f.inertia = -1; })});
    stops("coordinates 0 to 5", {[](Scene& s) { s.world.setFreedom(s.rope, 6, {}); },
                                 [](Scene& s) { s.world.setFreedom(s.rope, -1, {}); }});
}

TEST(MisuseDeathTest, OfForces) {
    stops("bodies of this world", {[](Scene& s) { s.world.add(ForceDef{Drag{}, {BodyId{70}}}); }});
    stops("two ends", {[](Scene& s) { s.world.add(ForceDef{SpringForce{}, {s.box}}); }});
    stops("two different bodies", {[](Scene& s) {
              s.world.add(ForceDef{SpringForce{}, {s.box, s.box}});
          }});
    stops("before it begins", {[](Scene& s) {
                                   s.world.add(ForceDef{Drag{}, {s.box}, 2.0, 1.0});
                               },
                               [](Scene& s) {
                                   s.world.add(ForceDef{Drag{}, {s.box}, kNan});
                               }});
    stops("a force, its torque",
          {pushing(ConstantForce{.force = kNowhere}), pushing(ConstantForce{.at = kEndless})});
    stops("drag must be", {pushing(Drag{.linear = -1}), pushing(Drag{.angular = kNan})});
    stops("a medium's density",
          {pushing(Medium{.density = -1}), pushing(Medium{.dragCoefficient = kNan})});
    stops("a medium's velocity", {pushing(Medium{.velocity = kNowhere})});
    stops("a medium's level", {pushing(Medium{.level = kNan}), pushing(Medium{.low = kNowhere})});
    stops("a point's place",
          {pushing(PointGravity{.centre = kNowhere}), pushing(PointGravity{.strength = kInf})});
    stops("softening",
          {pushing(PointGravity{.softening = -1}), pushing(NBodyGravity{.softening = kNan})});
    stops("constant of gravity", {pushing(NBodyGravity{.constant = kNan})});
    stops("a spring's ends", {pushing(SpringForce{.anchorA = kNowhere})});
    stops("a spring's length",
          {pushing(SpringForce{.stiffness = -1}), pushing(SpringForce{.damping = kNan})});
    stops("an airfoil's place", {flying([](Airfoil& a) { a.wind = kNowhere; })});
    stops("chord and normal", {flying([](Airfoil& a) {
                                   a.chord = {0, 1, 0};
                               }),
                               flying([](Airfoil& a) { a.normal *= 2; })});
    stops("an airfoil's numbers",
          {flying([](Airfoil& a) { a.area = -1; }), flying([](Airfoil& a) { a.aspect = 0; })});
}

}  // namespace
}  // namespace engine
