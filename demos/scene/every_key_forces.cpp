// [[force]]

#include <cmath>

#include "demos/scene/every_key.h"
#include "demos/text/complaints.h"
#include "engine/base/trigonometry.h"
#include "engine/force.h"

namespace demos {
namespace {

const std::vector<KeyExample> kForceExamples{
    {"wind", R"(
[[force]]
type = "wind"
name = "breeze"
on = ["ball"]
from = 0
until = 1
velocity = [3, 0, 0]
density = 1.2
drag = 0.5
within = { from = [-1, -1, -1], to = [1, 1, 1] }
)"},
    {"medium, drag", R"(
[[force]]
type = "medium"
density = 1000
level = 0
[[force]]
type = "drag"
linear = 0.1
angular = 0.1
)"},
    {"gravity", R"(
[[force]]
type = "point-gravity"
at = [0, 0, 0]
strength = 10
softening = 0.1
[[force]]
type = "n-body-gravity"
constant = 1
softening = 0.1
)"},
    {"spring", R"(
[[force]]
type = "spring"
a = "ball"
b = "world"
anchor_a = [0, 0, 0]
anchor_b = [0, 5, 0]
length = 1
stiffness = 100
damping = 1
)"},
    {"constant", R"(
[[force]]
type = "constant"
force = [1, 0, 0]
torque = [0, 1, 0]
at = [0, 0, 0]
turn = true
)"},
    {"airfoil", R"(
[[force]]
type = "airfoil"
area = 0.5
at = [0, 0, 0]
chord = [1, 0, 0]
normal = [0, 1, 0]
density = 1.2
velocity = [0, 0, 0]
lift_slope = 6
stall_deg = 15
drag = 0.01
plate_drag = 2
aspect = 6
)"},
};

std::string stallText() {
    const double degrees = engine::Airfoil{}.stall / engine::radians(1.0);
    return "about " + numberText(std::round(10.0 * degrees) / 10.0);
}

TableTexts forceTexts() {
    return {
        "a [[force]]",
        {
            {"type", "required", "The kind of force, which decides what other keys the table has."},
            {"name", "none", "A name for people who read the file; nothing refers to it."},
            {"on", inToml(std::string("*")),
             "The bodies on which it acts, by name or with *; bodies that cannot move are left "
             "out."},
            {"from", inToml(engine::ForceDef{}.from),
             "The time from which the force acts; start a gust or an engine with it."},
            {"until", "the end of the run", "The time until which the force acts."},
            {"velocity", "required for wind, else [0, 0, 0]",
             "The velocity of the air or water itself, which drags bodies along."},
            {"density", "required for medium, else " + inToml(engine::Medium{}.density),
             "The density of the air or water: 1.2 for air, 1000 for water; a medium lifts "
             "whatever is lighter."},
            {"drag",
             "wind and medium: " + inToml(engine::Medium{}.dragCoefficient) +
                 "; airfoil: " + inToml(engine::Airfoil{}.profileDrag),
             "The drag coefficient: about 0.5 for a ball and 1 for a cube; of an airfoil, that of "
             "the attached flow without lift."},
            {"within", "everywhere",
             "The box in which the air or water is; a body is in it when its centre of mass is."},
            {"level", "no surface",
             "The height of the surface of the water; only the part of a body below it is lifted "
             "and slowed down."},
            {"linear", inToml(engine::Drag{}.linear),
             "The drag force per speed, as in oil; 0 leaves the motion of the centre free."},
            {"angular", inToml(engine::Drag{}.angular),
             "The drag torque per angular speed; lets spinning bodies come to rest."},
            {"at", "required for point-gravity, else [0, 0, 0]",
             "The attracting point of the world; for constant and airfoil the point of the body, "
             "from its centre of mass, where the force acts."},
            {"strength", "required",
             "The pull of the point, G times its mass; a body at distance r orbits with the speed "
             "sqrt(strength / r)."},
            {"softening", "0",
             "A length that keeps the attraction finite at small distances; give a few percent of "
             "the size of the system if bodies come close."},
            {"constant", inToml(engine::NBodyGravity{}.constant),
             "The gravitational constant between the bodies; a large one makes kilograms orbit "
             "within metres."},
            {"a", "required", "The first end of the spring: a body, or \"world\"."},
            {"b", "required", "The second end of the spring: a body, or \"world\"."},
            {"anchor_a", "the centre of mass, or the origin of the world",
             "The point of a where the spring is attached."},
            {"anchor_b", "the centre of mass, or the origin of the world",
             "The point of b where the spring is attached."},
            {"length", "the distance of the ends at the start",
             "The length at which the spring is slack; shorter than the distance, it pulls from "
             "the start."},
            {"stiffness", "required",
             "The force per metre of stretch; a mass m swings on it with the period 2 pi sqrt(m / "
             "stiffness)."},
            {"damping", inToml(engine::SpringForce{}.damping),
             "The force per speed along the spring; 2 sqrt(m stiffness) stops the swing without "
             "overshoot."},
            {"force", inToml(engine::ConstantForce{}.force),
             "The constant force, like the thrust of a rocket."},
            {"torque", inToml(engine::ConstantForce{}.torque),
             "The constant torque, which spins the body up."},
            {"turn", inToml(engine::ConstantForce{}.turns),
             "Turns force and torque with the body, as for a thruster; otherwise they keep their "
             "direction in the world."},
            {"area", "required",
             "The area of the wing, fin or plate; lift and drag grow in proportion."},
            {"chord", inToml(engine::Airfoil{}.chord),
             "The direction of the body from the trailing to the leading edge of the wing."},
            {"normal", inToml(engine::Airfoil{}.normal),
             "The direction of the body across the chord, towards positive lift."},
            {"lift_slope", inToml(engine::Airfoil{}.liftSlope),
             "The lift coefficient per sine of the angle of attack; 2 pi is that of a thin plate, "
             "a real wing has less."},
            {"stall_deg", stallText(),
             "The angle of attack beyond which the flow breaks away and lift collapses; 0 makes it "
             "a flat plate, stalled at every angle."},
            {"plate_drag", inToml(engine::Airfoil{}.plateDrag),
             "The pressure coefficient across the plate once the flow has broken away; 2 is a flat "
             "plate."},
            {"aspect", inToml(engine::Airfoil{}.aspect),
             "Span squared over area; a slender wing, with a large value, pays less drag for its "
             "lift."},
        }};
}

TableTexts withinTexts() {
    return {"within",
            {
                {"from", "required", "The corner of the box with the lowest coordinates."},
                {"to", "required", "The corner of the box with the highest coordinates."},
            }};
}

}  // namespace

KeyPart forceKeys() { return {kForceExamples, {forceTexts(), withinTexts()}}; }

}  // namespace demos
