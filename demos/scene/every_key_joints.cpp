// [[joint]]

#include "demos/scene/every_key.h"

namespace demos {
namespace {

const std::vector<KeyExample> kJointExamples{
    {"ball", R"(
[[joint]]
type = "ball"
name = "full"
a = "world"
b = "ball"
anchor = [0, 3, 0]
axis = [0, 1, 0]
twist_deg = [-10, 10]
swing_deg = 45
break_at = 100
break_torque = 100
spring = { hz = 2, damping = 0.5 }
)"},
    {"distance", R"(
[[joint]]
type = "distance"
a = "ball"
b = "crate"
anchor_a = [0, 0, 0]
anchor_b = [0, 0, 0]
length = 3
limits = [1, 4]
motor = { speed = 1, max = 50 }
)"},
    {"hinge", R"(
[[joint]]
type = "hinge"
a = "ball"
b = "crate"
anchor = [1, 2, 0]
axis = [0, 0, 1]
limits_deg = [-45, 45]
motor = { speed = 1, max = 50 }
spring = { hz = 2, damping = 0.5, rest_deg = 10 }
soft = { hz = 20, damping = 1 }
inertia = 0.1
)"},
    {"slider", R"(
[[joint]]
type = "slider"
a = "ball"
b = "crate"
anchor = [1, 2, 0]
axis = [1, 0, 0]
spring = { hz = 2, damping = 0.5, rest = 0.1 }
inertia = 0.1
)"},
    {"universal", R"(
[[joint]]
type = "universal"
a = "ball"
b = "crate"
anchor = [1, 2, 0]
axis = [1, 0, 0]
axis2 = [0, 1, 0]
limits_deg = [-45, 45]
limits2_deg = [-45, 45]
motor = { speed = 1 }
motor2 = { speed = 1 }
)"},
    {"six-dof", R"(
[[joint]]
type = "six-dof"
a = "ball"
b = "crate"
anchor = [1, 2, 0]
x = "locked"
y = "free"
z = { limits = [-1, 1], motor = { speed = 0, max = 1 }, spring = { hz = 1, rest = 0 }, inertia = 0.1 }
rx = "locked"
ry = "free"
rz = { limits_deg = [-10, 10], motor = { speed = 0, max = 1 }, spring = { hz = 1, rest_deg = 0 }, inertia = 0.1 }
)"},
    {"coordinates", R"(
[[joint]]
type = "six-dof"
a = "ball"
b = "crate"
anchor = [1, 2, 0]
x = { limits = [-1, 1] }
y = { limits = [-1, 1] }
z = "locked"
rx = { limits_deg = [-1, 1] }
ry = { limits_deg = [-1, 1] }
rz = "locked"
)"},
    {"gear", R"(
[[joint]]
type = "gear"
a = "ball"
b = "crate"
axis = [1, 0, 0]
ratio = -2
)"},
    {"path", R"(
[[joint]]
type = "path"
a = "world"
b = "ball"
points = [[0, 2, 0], [1, 2, 0], [2, 3, 0]]
closed = true
)"},
};

TableTexts jointTexts() {
    return {
        "a [[joint]]",
        {
            {"type", "required",
             "What the joint holds and what it leaves free: a hinge leaves one angle, a ball all "
             "three, a weld nothing."},
            {"name", "the names of its bodies, A-B",
             "The name in expectations, tables and events."},
            {"a", "required",
             "The first of the two bodies, or \"world\"; angle and translation of the joint are "
             "those of b seen from it."},
            {"b", "required", "The second of the two bodies, or \"world\"."},
            {"anchor", "required by most types, unless anchor_a and anchor_b are given",
             "The point of the world, at the start, where the two bodies are held together."},
            {"anchor_a", "the anchor; the centre of mass where there is none",
             "The point of body a, from its own origin, where the joint holds it."},
            {"anchor_b", "the anchor; the centre of mass where there is none",
             "The point of body b, from its own origin, where the joint holds it."},
            {"axis", "required by most types; six-dof: x of the world",
             "The direction, at the start, about which the joint turns or along which it slides."},
            {"axis2", "required for universal and wheel, else axis; six-dof: y of the world",
             "The second direction, at the start, fixed in b: the other shaft, the axle of a "
             "wheel, the y of a six-dof."},
            {"length", "the distance of the ends at the start",
             "The distance at which a distance joint holds its ends, like a rod."},
            {"limits", "none",
             "The range of the free translation, as [low, high]: how far a slider, rod, suspension "
             "or path may go."},
            {"limits_deg", "none",
             "The range of the free angle, as [low, high] from the start; full turns are counted, "
             "so 720 is two turns."},
            {"limits2_deg", "none",
             "The range of the second angle of a universal joint, about axis2."},
            {"twist_deg", "none",
             "The range of the rotation of a ball joint about its axis, as [low, high]; keeps the "
             "arm of a doll from spinning."},
            {"swing_deg", "none",
             "How far the axis of a ball joint, or the bend between two shafts, may lean; keeps "
             "limbs within a cone."},
            {"motor", "none",
             "Drives the free coordinate at a speed, the spin in case of a wheel; with speed 0 it "
             "is a brake."},
            {"motor2", "none", "Drives the second angle of a universal joint."},
            {"spring", "none",
             "Pulls the free coordinate to a rest position, or, in types without one, makes soft "
             "what the joint holds."},
            {"soft", "none: rigid",
             "Makes soft what a joint with a free coordinate holds, like a rubber bearing."},
            {"inertia", "none",
             "The inertia of a rotor without weight that turns or moves with the joint; gives a "
             "geared motor its sluggishness."},
            {"x", "\"free\"",
             "The translation of a six-dof joint along its x axis: free, locked, or a table of "
             "what acts on it."},
            {"y", "\"free\"",
             "The translation of a six-dof joint along its y axis: free, locked, or a table of "
             "what acts on it."},
            {"z", "\"free\"",
             "The translation of a six-dof joint along its z axis: free, locked, or a table of "
             "what acts on it."},
            {"rx", "\"free\"",
             "The rotation of a six-dof joint about its x axis: free, locked, or a table of what "
             "acts on it."},
            {"ry", "\"free\"",
             "The rotation of a six-dof joint about its y axis: free, locked, or a table of what "
             "acts on it."},
            {"rz", "\"free\"",
             "The rotation of a six-dof joint about its z axis: free, locked, or a table of what "
             "acts on it."},
            {"ratio", "required",
             "How often the second shaft of a gear turns for each turn of the first; below 0 they "
             "turn in opposite directions."},
            {"points", "required",
             "The points, fixed in a, that the curve of a path joint passes through, like the rail "
             "of a roller coaster."},
            {"closed", "false",
             "Continues the path from its last point to its first, for a round track."},
            {"break_at", "never",
             "A mean force of a step above this removes the joint; the strength of a rope or a "
             "glued edge."},
            {"break_torque", "never",
             "A mean torque of a step above this removes the joint; lets a beam snap where it is "
             "bent."},
        }};
}

TableTexts motorTexts() {
    return {"a motor",
            {
                {"speed", "required",
                 "The speed that the motor keeps up, of the angle or the translation; 0 makes it a "
                 "brake."},
                {"max", "no limit",
                 "The largest torque or force of the motor, beyond which it slows down; give the "
                 "value of a real motor, or the friction of a brake."},
            }};
}

TableTexts springTexts() {
    return {
        "a spring",
        {
            {"hz", "required",
             "How often the connected masses would swing in a second; higher is stiffer, whatever "
             "they weigh."},
            {"damping", "0",
             "The damping ratio: 0 swings on for ever, 1 returns without overshoot, 0.5 suits a "
             "car."},
            {"rest", "0", "The translation to which the spring pulls, counted as for `limits`."},
            {"rest_deg", "0", "The angle to which the spring pulls, from that at the start."},
        }};
}

TableTexts coordinateTexts() {
    return {"a coordinate",
            {
                {"limits", "none", "The range of the translation, as [low, high]."},
                {"limits_deg", "none", "The range of the rotation, as [low, high] from the start."},
                {"motor", "none", "Drives the coordinate at a speed; with speed 0 it is a brake."},
                {"spring", "none", "Pulls the coordinate to a rest position."},
                {"inertia", "none",
                 "The inertia of a rotor without weight that turns or moves with the coordinate."},
            }};
}

}  // namespace

KeyPart jointKeys() {
    return {kJointExamples, {jointTexts(), motorTexts(), springTexts(), coordinateTexts()}};
}

}  // namespace demos
