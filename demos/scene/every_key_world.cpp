// The file itself, [values], [world], [solver] and [[material]]

#include "demos/scene/description.h"
#include "demos/scene/every_key.h"
#include "demos/scene/solver_settings.h"

namespace demos {
namespace {

const std::vector<KeyExample> kWorldExamples{
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
    {"nudges", "\n[solver]\nnudges = 2\n[[material]]\nname = \"glass\"\n"},
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
look = "wood"
[[body]]
name = "sliding"
shape = { box = [1, 1, 1] }
at = [6, 0.6, 0]
velocity = [3, -1, 0]
material = "wood"
)"},
};

/// A solver setting's default, and what the other presets have instead.
std::string solverUsual(const std::string& key) {
    const auto of = [&key](const char* preset) {
        const std::string value = settingOf(presetCalled(preset), "solver." + key);
        const bool word = value.find_first_not_of("0123456789.-e") != std::string::npos;
        return word && value != "true" && value != "false" ? inToml(value) : value;
    };
    std::string usual = of("steady");
    for (const char* preset : {"fast", "seed"})
        if (of(preset) != of("steady"))
            usual += std::string("; preset ") + preset + ": " + of(preset);
    return usual;
}

TableTexts sceneTexts() {
    return {
        "a scene",
        {
            {"format", "required",
             "The number of the format, with which every file begins; this version of the program "
             "reads format 1 only."},
            {"include", "[]",
             "Files that are read before this one, relative to its folder, so that scenes can "
             "share parts; where both give a key, this file wins."},
            {"title", "the name of the scene",
             "The line in the picture until a section has a caption, and the title of slides; "
             "write one when the name of the file says too little."},
            {"purpose", R"("")",
             "What the scene shows, in one line for `impulse list` and the gallery."},
            {"group", R"("")",
             "The heading under which `impulse list` and the gallery show the scene."},
            {"seconds", inToml(SceneDescription{}.seconds),
             "The length of the run and of its film; make it long enough for the motion to come to "
             "its point."},
            {"values", "none",
             "Names for numbers, which expressions anywhere in the file may use and --set may "
             "change."},
            {"world", "its defaults",
             "What holds for the whole world: gravity, steps a second, the seed of random "
             "numbers."},
            {"solver", "its defaults",
             "How contacts and joints are solved; leave it out unless a large pile should be "
             "faster or a film should show a weaker method."},
            {"material", "none", "A surface and density that several bodies share by its name."},
            {"body", "required, unless a [[repeat]] makes bodies",
             "A rigid body: its shape, place, motion and surface."},
            {"joint", "none",
             "A connection of two bodies, or of a body and the world, that leaves only some "
             "motions free."},
            {"force", "none", "A force besides gravity, such as wind, water, springs and wings."},
            {"repeat", "none",
             "Makes many bodies, joints or forces from one table, each moved a little from the one "
             "before."},
            {"camera", "its defaults", "From where the film is seen, and how the camera moves."},
            {"look", "its defaults",
             "Theme, overlays and colours of the picture; they never change the motion."},
            {"section", "none",
             "A chapter of the film from its time on, with a caption, and a slide of its own in "
             "`impulse slides`."},
            {"expect", "none",
             "A statement about the motion that `impulse sim` and `impulse test` check, so that a "
             "change that breaks the scene is noticed."},
            {"snapshot", "none",
             "The times at which `impulse test` compares picture and state with the saved ones, "
             "and by how much they may differ."},
        }};
}

TableTexts valueTexts() {
    return {"[values]",
            {
                {"*", "required",
                 "A named number, or an expression of names above it, for use in place of any "
                 "number of the scene; --set values.NAME=VALUE changes it."},
            }};
}

TableTexts worldTexts() {
    return {"[world]",
            {
                {"gravity", inToml(SceneDescription{}.gravity),
                 "The acceleration of free fall; use [0, -1.62, 0] for the moon and [0, 0, 0] for "
                 "space."},
                {"hz", inToml(SceneDescription{}.hz),
                 "The steps of physics, a multiple of the frames per second of the film; raise it "
                 "for fast or stiff motion, at a cost in proportion."},
                {"seed", inToml(static_cast<int>(SceneDescription{}.seed)),
                 "Selects the random numbers behind every jitter; another seed gives another pile, "
                 "the same seed the same one again."},
            }};
}

TableTexts solverTexts() {
    return {
        "[solver]",
        {
            {"preset", inToml(SceneDescription{}.preset),
             "A set of defaults for all keys below: steady holds stacks still, fast is for large "
             "piles, seed is the plain textbook method for comparison."},
            {"type", solverUsual("type"),
             "The method that finds the impulses: sequential impulses, two forms of projected "
             "Gauss-Seidel to compare with, or the exact and slow direct solution."},
            {"sweeps", solverUsual("sweeps"),
             "The most sweeps per sub-step, each of which goes over all contacts and joints; raise "
             "it where stacks sag or heavy things rest on light ones."},
            {"min_sweeps", solverUsual("min_sweeps"),
             "The fewest sweeps per sub-step, even if every constraint is satisfied earlier; raise "
             "it to `sweeps` to always make all of them."},
            {"tolerance", solverUsual("tolerance"),
             "The sweeps of a sub-step end when no correction of a velocity is larger; 0 makes all "
             "of them, a larger value saves time and leaves more error."},
            {"substeps", solverUsual("substeps"),
             "The parts that a step is cut into, each solved for itself; more make stacks stiffer "
             "and joints tighter, at a cost in proportion."},
            {"max_substeps", solverUsual("max_substeps"),
             "The limit to which sub-steps are added on their own for tall columns, heavy on light "
             "bodies and fast joints, and to at most 32 with contacts or in long chains; set it to `substeps` "
             "for a constant number."},
            {"depenetration_speed", solverUsual("depenetration_speed"),
             "The highest speed at which nudges push overlapping bodies apart; raise it if bodies "
             "that start inside each other separate too slowly."},
            {"nudges", solverUsual("nudges"),
             "Sweeps per sub-step that move bodies out of each other without giving them speed; "
             "with 0 and no `baumgarte` overlaps and joint errors stay."},
            {"baumgarte", solverUsual("baumgarte"),
             "The share of a penetration or joint error that is turned into velocity in every "
             "sub-step, instead of nudges; it throws overlapping bodies apart, which is what films "
             "about it show."},
            {"slop", solverUsual("slop"),
             "The penetration that is left uncorrected so that resting contacts persist; lower it "
             "for small bodies, of a few centimetres."},
            {"order", solverUsual("order"),
             "The order of the contacts in a sweep: gravity goes from the top down, which carries "
             "weight to the floor in one sweep, pairs goes by the numbers of the bodies."},
            {"joints", solverUsual("joints"),
             "Solves trees of joints exactly (direct), or row by row like contacts (rows), where "
             "chains with a heavy end stretch."},
            {"block", solverUsual("block"),
             "Solves the points of a contact, and the rows of a joint, together instead of one "
             "after the other; turn it off to compare with the plain method."},
            {"lanes", solverUsual("lanes"),
             "Solves contacts eight at a time in single precision, which is faster; turn it off "
             "for double precision."},
            {"warm_start", solverUsual("warm_start"),
             "Starts each solution from the impulses of the last step; turn it off to see stacks "
             "sink without this memory."},
            {"accumulate", solverUsual("accumulate"),
             "Clamps the total impulse of a contact rather than every correction; turn it off only "
             "to show the wrong way, in which an excess is never taken back."},
            {"threads", inToml(engine::Settings{}.threads),
             "The threads that share large groups of contacts; the result is the same to the bit, "
             "so choose by speed alone."},
            {"sleeping", solverUsual("sleeping"),
             "Lets groups of bodies at rest fall asleep until something touches them, so that they "
             "cost next to nothing; turn it on for large scenes that settle."},
            {"sleep_after", solverUsual("sleep_after"),
             "How long a group has to be at rest before it falls asleep; if it is too short, a "
             "slow pendulum stops where it reverses."},
        }};
}

TableTexts materialTexts() {
    return {"a [[material]]",
            {
                {"name", "required", "The name by which bodies choose this material."},
                {"density", inToml(engine::Material{}.density),
                 "Mass per volume, from which a body without `mass` gets its mass; 600 is wood, "
                 "1000 water, 7800 steel."},
                {"friction", inToml(engine::Material{}.friction),
                 "The coefficient of Coulomb friction, 0 for ice and about 1 for rubber; a block "
                 "begins to slide where the slope exceeds it."},
                {"restitution", inToml(engine::Material{}.restitution),
                 "The speed after a bounce as a share of the speed before, from 0 for clay to 1 "
                 "for a perfect ball; of two surfaces the larger counts."},
                {"rolling", inToml(engine::Material{}.rolling),
                 "The lever arm of rolling resistance, which slows rolling bodies down; give a "
                 "millimetre or so to balls that should come to rest."},
                {"friction_rule", "\"geometric\"",
                 "How the coefficients of two surfaces combine, geometric being the root of their "
                 "product; of two different rules the later in the list counts."},
                {"priority", inToml(engine::Material{}.priority),
                 "A surface of higher priority alone decides friction, restitution and rolling of "
                 "a contact; use it for ice on which everything slips."},
                {"colour", "that of its look, or one of the palette",
                 "The colour of its bodies in the picture."},
                {"look", "\"plastic\"",
                 "What its bodies seem to be made of in the picture; it never changes the motion."},
            }};
}

}  // namespace

KeyPart worldKeys() {
    return {kWorldExamples,
            {sceneTexts(), valueTexts(), worldTexts(), solverTexts(), materialTexts()}};
}

}  // namespace demos
