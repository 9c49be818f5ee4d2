#include "demos/scene/every_key.h"

namespace demos {
namespace {

constexpr const char* kBodies = R"(
[[body]]
name = "floor"
shape = { plane = [0, 1, 0] }
fixed = true
[[body]]
name = "ball"
shape = { sphere = 0.5 }
at = [0, 2, 0]
[[body]]
name = "crate"
shape = { box = [1, 1, 1] }
at = [3, 2, 0]
)";

// One row per variant: the keys that one type of a table takes and another does not.
constexpr KeyExample kExamples[] = {
    {"top", R"(
include = []
title = "a"
purpose = "b"
group = "c"
[values]
radius = 0.5
)"},
    {"settings", R"(
[world]
gravity = [0, -9.81, 0]
hz = 60
seed = 1
[solver]
preset = "steady"
type = "impulses"
sweeps = 30
min_sweeps = 2
tolerance = 0.002
substeps = 4
max_substeps = 8
depenetration_speed = 1.0
nudges = 0
baumgarte = 0.1
slop = 0.0005
order = "gravity"
joints = "direct"
block = true
lanes = true
warm_start = true
accumulate = true
threads = 1
sleeping = true
sleep_after = 0.5
)"},
    {"material", R"(
[[material]]
name = "wood"
density = 600
friction = 0.5
restitution = 0.1
rolling = 0.01
friction_rule = "larger"
priority = 1
colour = "#c89b6c"
)"},
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
sensor = true
group = "full"
ignores = ["full"]
[[body]]
name = "other"
shape = { sphere = 0.1 }
at = [0, 7, 0]
quaternion = [1, 0, 0, 0]
density = 600
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
    {"camera", R"(
[camera]
from = [8, 5, 14]
look_at = [0, 4, 0]
fov_deg = 35
orbit_deg_per_s = 0
follow = "ball"
follow_lag = 0.5
aperture = 0.1
focus = "ball"
keys = [{ at = 1, from = [4, 2, 9], look_at = [0, 2, 0], fov_deg = 30, ease = "out" }]
)"},
    {"focus", "\n[camera]\nfocus = 3\n"},
    {"look", R"(
[look]
theme = "studio"
show = ["contacts"]
colour_by = "body"
colour_max = 1
ghost_every = 0.25
plot = "energy"
trails = ["ball"]
[snapshot]
times = [0, 1]
size = [64, 36]
tolerance = { position = 0.001, angle_deg = 0.1, why = "w" }
gate = { levels = 3, window = 8, ssim = 0.9, why = "w" }
)"},
    {"section", R"(
[[section]]
at = 0
name = "start"
caption = "c"
notes = "n"
poster = "last"
slow = 0.5
pause = false
loop = false
title = "t"
text = "t"
formula = ["a", "b"]
plot = ["energy"]
table = ["measures", "expectations"]
[[section]]
at = 1
poster = 1
formula = "a"
)"},
    {"expect", R"(
[[expect]]
what = "speed"
of = ["ball"]
above = -1
below = 100
after = 0
until = 1
why = "w"
[[expect]]
what = "speed"
near = 0
within = 100
[[expect]]
what = "position"
of = "ball"
near = [0, 0, 0]
within = 100
)"},
};

}  // namespace

std::span<const KeyExample> everyKey() { return kExamples; }

std::string sceneOf(const KeyExample& example) {
    // The longest film allowed: it bounds the times in the schema.
    return std::string("format = 1\nseconds = 100000") + example.text + kBodies;
}

}  // namespace demos
