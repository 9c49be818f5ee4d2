// [[body]] with its shapes, and [[repeat]]

#include "demos/scene/every_key.h"

namespace demos {
namespace {

const std::vector<KeyExample> kBodyExamples{
    {"body", R"(
[[body]]
name = "full"
shape = { capsule = { radius = 0.1, height = 0.5 } }
material = "wood"
at = [0, 5, 0]
turn_deg = [0, 0, 30]
velocity = [0, 0, 0]
spin = [0, 0, 0]
mass = 1
inertia = [1, 1, 1]
colour = "#c89b6c"
look = "wood"
sensor = true
group = "full"
ignores = ["full"]
[[body]]
name = "other"
shape = { sphere = 0.1 }
at = [0, 7, 0]
quaternion = [1, 0, 0, 0]
density = 600
group = "others"
[[material]]
name = "wood"
)"},
    {"kinematic", R"(
[[body]]
name = "told"
shape = { sphere = 0.1 }
kinematic = { velocity = [0, 0, 0], spin = [0, 0, 0] }
[[body]]
name = "on-a-path"
shape = { sphere = 0.1 }
kinematic = { path = [[0, 9, 0], [0, 9, 1], [0, 9, 0]], times = [0, 1, 2], loop = true, smooth = true }
[[body]]
name = "on-an-orbit"
shape = { sphere = 0.1 }
at = [9, 9, 0]
kinematic = { orbit = { centre = [0, 9, 0], axis = [0, 1, 0], deg_per_s = 60, turn = true } }
)"},
    {"repeat", R"(
[[repeat]]
count = 1
step = [1, 0, 0]
turn_step_deg = [0, 0, 0]
about = [0, 0, 0]
jitter = [0, 0, 0]
body = { name = "a{i}", shape = { sphere = 0.1 } }
joint = { type = "ball", a = "world", b = "ball", anchor = [0, 3, 0] }
force = { type = "constant", force = [0, 0, 0] }
[[repeat.repeat]]
count = 1
count_step = 0
body = { name = "b{i}.{j}", shape = { sphere = 0.1 } }
)"},
    {"shapes", R"(
[[body]]
name = "cylinder"
shape = { cylinder = { radius = 0.1, height = 0.5 } }
[[body]]
name = "cone"
shape = { cone = { radius = 0.1, height = 0.5 } }
fixed = true
[[body]]
name = "hull"
shape = { hull = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], scale = 0.5, turn_deg = [0, 0, 30] }
[[body]]
name = "mesh"
fixed = true
shape = { mesh = { points = [[0, 0, 0], [0, 0, 1], [1, 0, 0]], triangles = [[0, 1, 2]] }, scale = [1, 1, 2] }
[[body]]
name = "hills"
fixed = true
shape = { height_field = { columns = 2, rows = 2, spacing = 1, heights = [0, 0, 0, 1] } }
[[body]]
name = "compound"
shape = { compound = [{ shape = { sphere = 0.1 }, at = [1, 0, 0], turn_deg = [0, 0, 0], density = 600 }, { shape = { sphere = 0.1 } }] }
)"},
    {"shapes from files", R"(
[[body]]
name = "hull"
shape = { hull = "claw.obj" }
[[body]]
name = "mesh"
fixed = true
shape = { mesh = "hills.glb" }
)",
     true},
};

TableTexts bodyTexts() {
    return {
        "a [[body]]",
        {
            {"name", "required",
             "The name by which joints, forces, the camera and expectations refer to the body; in "
             "a [[repeat]] with {i}."},
            {"shape", "required",
             "The form for collisions, mass and picture, as a table with one kind of shape."},
            {"material", "none: the defaults of a material",
             "The name of the [[material]] that gives density, friction, bounce and colour."},
            {"at", "[0, 0, 0]",
             "The place at the start: the centre of mass, or the origin of the points or parts of "
             "a hull or compound."},
            {"turn_deg", "[0, 0, 0]",
             "The rotation at the start, about x, then y, then z of the world."},
            {"quaternion", "[1, 0, 0, 0]",
             "The rotation at the start as [w, x, y, z], instead of `turn_deg`, for values from "
             "another program."},
            {"velocity", "[0, 0, 0]",
             "The velocity of the centre of mass at the start; throw a ball with it."},
            {"spin", "[0, 0, 0]",
             "The angular velocity at the start, along the axis of rotation; let a top turn with "
             "it."},
            {"mass", "density times volume",
             "The mass, which decides how much a push moves the body; give it when the size in the "
             "picture should not decide."},
            {"density", "that of the material",
             "Mass per volume, from which the mass follows, instead of `mass`."},
            {"inertia", "that of the shape for this mass",
             "The resistance to rotation about the axes of the body, as xx, yy, zz or with xy, xz, "
             "yz; give it for bodies whose mass is not spread evenly."},
            {"fixed", "false", "Makes the body immovable, like a floor; planes have to be fixed."},
            {"kinematic", "none",
             "Moves the body as prescribed, whatever hits it, like a lift or a mill."},
            {"sensor", "false",
             "Lets everything pass through the body, which then only reports in --events what is "
             "inside it."},
            {"group", "[]",
             "Names of collision groups to which the body belongs, for `ignores` of others; 32 in "
             "a scene at most."},
            {"ignores", "[]",
             "Names of groups whose bodies this one passes through; use it where parts of a "
             "machine overlap on purpose."},
            {"colour", "that of the material, or one of the palette",
             "The colour of the body in the picture."},
            {"look", "that of the material",
             "What the body seems to be made of in the picture."},
        }};
}

TableTexts kinematicTexts() {
    return {
        "kinematic",
        {
            {"velocity", "[0, 0, 0]",
             "The constant velocity with which the body moves on for ever."},
            {"spin", "[0, 0, 0]", "The constant angular velocity, also while it follows a path."},
            {"path", "required for a motion along points",
             "The points that the origin of the body passes through, the first of them at the "
             "start."},
            {"times", "required with path",
             "The time at each point of the path, from 0 and rising; closer times mean a faster "
             "motion."},
            {"loop", "false",
             "Begins the path again at its end, for which the last point has to be the first."},
            {"smooth", "false",
             "Leads the path around its points in curves instead of corners, starting and ending "
             "at rest."},
            {"orbit", "none", "Leads the body around a point at a constant rate."},
        }};
}

TableTexts orbitTexts() {
    return {"an orbit",
            {
                {"centre", "required",
                 "The point about which the body circles, at the distance it starts from."},
                {"axis", "[0, 1, 0]",
                 "The direction of the axis of the circle, about which it turns right-handed."},
                {"deg_per_s", "required", "How fast it circles; below 0 the other way round."},
                {"turn", "true",
                 "Turns the body as it circles, like the hand of a clock; false keeps its "
                 "rotation, like a cabin of a big wheel."},
            }};
}

TableTexts repeatTexts() {
    return {
        "a [[repeat]]",
        {
            {"count", "required",
             "The number of turns, each of which adds everything the table holds; an expression of "
             "the outer indices makes triangles and pyramids."},
            {"count_step", "0",
             "What an inner count grows by with each turn around it; -1 makes a pyramid."},
            {"step", "[0, 0, 0]", "How far each turn is moved from the one before."},
            {"turn_step_deg", "[0, 0, 0]",
             "How far each turn is rotated from the one before, about x, then y, then z of the "
             "world; makes rings and spirals."},
            {"about", "each where it is",
             "The point about which the turns are rotated, the centre of a ring."},
            {"jitter", "[0, 0, 0]",
             "A random displacement of each body, up to this much in both directions, from "
             "`world.seed`; makes piles look natural."},
            {"body", "none",
             "The bodies that each turn adds; {i} in a name gives every turn a name of its own."},
            {"joint", "none",
             "The joints that each turn adds, for example between link{i} and link{i+1}."},
            {"force", "none", "The forces that each turn adds."},
            {"repeat", "none",
             "A repetition within each turn, over j, and within that over k; makes walls and "
             "grids."},
        }};
}

TableTexts shapeTexts() {
    return {
        "a shape",
        {
            {"sphere", "required: one kind of shape", "A ball of this radius, the cheapest shape."},
            {"box", "required: one kind of shape", "A box of these full sizes along x, y and z."},
            {"capsule", "required: one kind of shape",
             "A cylinder along y with half balls as ends; rolls well and costs little, for limbs "
             "and links."},
            {"cylinder", "required: one kind of shape",
             "A cylinder along y, for wheels, coins and rollers."},
            {"cone", "required: one kind of shape",
             "A cone along y with its tip up, whose base lies a quarter of the height below the "
             "centre of mass."},
            {"plane", "required: one kind of shape",
             "An endless flat ground with this normal out of the solid, only for fixed bodies."},
            {"hull", "required: one kind of shape",
             "The convex hull of points, or of the vertices of a file; for stones, wedges and "
             "tools."},
            {"mesh", "required: one kind of shape",
             "Triangles as a one-sided surface, from a file or a table, for terrain and halls; not "
             "for dynamic bodies."},
            {"height_field", "required: one kind of shape",
             "A terrain of heights on a regular grid; not for dynamic bodies."},
            {"compound", "required: one kind of shape",
             "Several solids as one rigid body, for hammers, chairs and dumbbells."},
            {"scale", "1",
             "Multiplies all coordinates of a hull or mesh, all axes alike or each its own; 0.001 "
             "reads a file in mm."},
            {"turn_deg", "[0, 0, 0]",
             "Rotates the points of a hull or mesh after `scale`, about x, then y, then z; [-90, "
             "0, 0] puts up a file whose z is up."},
        }};
}

TableTexts capsuleTexts() {
    return {"a capsule",
            {
                {"radius", "required",
                 "The radius of the round ends and of the cylinder between them."},
                {"height", "required", "The length from tip to tip, at least twice the radius."},
            }};
}

TableTexts cylinderTexts() {
    return {"a cylinder",
            {
                {"radius", "required", "The radius of the two flat ends."},
                {"height", "required",
                 "The length along y, which is the thickness of a wheel or coin."},
            }};
}

TableTexts coneTexts() {
    return {"a cone",
            {
                {"radius", "required", "The radius of the base."},
                {"height", "required", "The distance from the base to the tip."},
            }};
}

TableTexts meshTexts() {
    return {"a mesh",
            {
                {"points", "required",
                 "The corners of the surface, which triangles name by their number from 0."},
                {"triangles", "required",
                 "Three numbers of points for each triangle, counter-clockwise as seen from the "
                 "side that holds."},
            }};
}

TableTexts heightFieldTexts() {
    return {"a height_field",
            {
                {"columns", "required", "The number of heights along x."},
                {"rows", "required", "The number of heights along z."},
                {"spacing", "required", "The distance of neighbouring heights along x and z."},
                {"heights", "required",
                 "The heights above `at`, row after row with x running fastest, as many as columns "
                 "times rows."},
            }};
}

TableTexts partTexts() {
    return {"a part",
            {
                {"shape", "required", "The form of the part: any solid, also another compound."},
                {"at", "[0, 0, 0]", "The place of the origin of the part in the compound."},
                {"turn_deg", "[0, 0, 0]",
                 "The rotation of the part, about x, then y, then z of the compound."},
                {"density", "that of the body",
                 "Mass per volume of this part; gives a hammer its heavy head."},
            }};
}

}  // namespace

KeyPart bodyKeys() {
    return {
        kBodyExamples,
        {bodyTexts(), kinematicTexts(), orbitTexts(), repeatTexts(), shapeTexts(), capsuleTexts(),
         cylinderTexts(), coneTexts(), meshTexts(), heightFieldTexts(), partTexts()}};
}

}  // namespace demos
