// A scene file is read strictly: errors are reported with their place and what would be right.

#include <gtest/gtest.h>

#include "tests/demos/reading.h"

namespace demos::test {
namespace {

const std::string kForce = kBall + "[[force]]\n";  // at line 6
const std::string kWind = kForce + "type = 'wind'\nvelocity = [3, 0, 0]\n";
const std::string kMover = "[[body]]\nname = 'cart'\nshape = { box = [1, 1, 1] }\nkinematic = ";
const std::string kPath = "{ path = [[0, 1, 0], [1, 1, 0]], times = [0, 1]";

struct BadScene {
    const char* what;
    std::string text;  // after "format = 1\n"
    const char* place;
    const char* message;
};

std::ostream& operator<<(std::ostream& out, const BadScene& bad) { return out << bad.what; }

class BadScenes : public testing::TestWithParam<BadScene> {};

TEST_P(BadScenes, AreReportedWithTheirPlace) {
    const BadScene& bad = GetParam();
    const std::vector<std::string> lines = errorsOf("format = 1\n" + bad.text);
    EXPECT_TRUE(tells(lines, std::string("a.toml:") + bad.place + ": ", bad.message))
        << bad.what << "\n"
        << listed(lines);
}

INSTANTIATE_TEST_SUITE_P(
    Top, BadScenes,
    testing::Values(BadScene{"unknown key", "secods = 3\n" + kBall, "2:1",
                             "unknown key 'secods' in a scene; did you mean 'seconds'?"},
                    BadScene{"wrong type", "seconds = true\n" + kBall, "2:11",
                             "seconds is true; it should be a number from 0.01 to 100000 s"},
                    BadScene{
                        "text", "seconds = \"five\"\n" + kBall, "2:11",
                        "seconds is the text \"five\": there is no value 'five'; known are: pi"},
                    BadScene{"not a number", "seconds = nan\n" + kBall, "2:11", "seconds is nan"},
                    BadScene{"infinite", "seconds = inf\n" + kBall, "2:11", "seconds is inf"},
                    BadScene{"not TOML", "seconds = = 3\n", "2:11", "not TOML"},
                    BadScene{"cut in a number", "seconds = 3.", "2:13", "not TOML"},
                    BadScene{"key twice", "title = 'a'\ntitle = 'b'\n", "3:9", "not TOML"},
                    BadScene{"no body", "title = 'a'\n", "1:1", "the scene has no body"},
                    BadScene{"a table that is none", kBall + "[camera]\n[world.hz]\n", "7:1",
                             "hz is a table; it should be a whole number from 10 to 100000"}));

/// If `seconds` is wrong, times are not checked against the default length as well.
TEST(SceneLength, AMistakeIsReportedOnce) {
    for (const std::string length : {"secnds = 7\n", "seconds = true\n"}) {
        const std::vector<std::string> lines =
            errorsOf("format = 1\n" + length + kBall + "[[section]]\nat = 6\n");
        EXPECT_EQ(lines.size(), 1u) << listed(lines);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Settings, BadScenes,
    testing::Values(
        BadScene{"hz", "[world]\nhz = 5\n" + kBall, "3:6", "hz is 5; it should be a whole number"},
        BadScene{"hz of 60.5", "[world]\nhz = 60.5\n" + kBall, "3:6", "hz is 60.5"},
        BadScene{"gravity", "[world]\ngravity = 9.81\n" + kBall, "3:11", "three numbers"},
        BadScene{"seed", "[world]\nseed = -1\n" + kBall, "3:8", "seed is -1"},
        BadScene{"preset", "[solver]\npreset = 'stedy'\n" + kBall, "3:10",
                 "did you mean 'steady'?"},
        BadScene{"lanes", "[solver]\nlanes = 8\n" + kBall, "3:9", "true or false"},
        BadScene{"type", "[solver]\ntype = 'pg'\n" + kBall, "3:8", "did you mean 'pgs'?"},
        BadScene{"both corrections", "[solver]\nbaumgarte = 0.2\n" + kBall, "3:1",
                 "write nudges = 0 or baumgarte = 0"},
        BadScene{"sweeps", "[solver]\nsweeps = 5\nmin_sweeps = 6\n" + kBall, "4:1",
                 "it should be at most sweeps, 5"},
        BadScene{"substeps", "[solver]\nsubsteps = 0\n" + kBall, "3:12", "from 1 to 1000"},
        BadScene{"max_substeps", "[solver]\nmax_substeps = 2\n" + kBall, "3:1",
                 "at least substeps"},
        BadScene{"threads", "[solver]\nthreads = 0\n" + kBall, "3:11", "from 1 to 64"},
        BadScene{"sleeping", "[solver]\nsleeping = 0.5\n" + kBall, "3:12", "true or false"},
        BadScene{"sleep_after", "[solver]\nsleep_after = 0\n" + kBall, "3:15",
                 "sleep_after is 0; it should be a number from 0.1 to 3600 s"},
        BadScene{"block", "[solver]\nblock = 1\n" + kBall, "3:9", "true or false"}));

INSTANTIATE_TEST_SUITE_P(
    Forces, BadScenes,
    testing::Values(
        BadScene{"no type", kForce + "on = 'ball'\n", "6:1", "a [[force]] has no type"},
        BadScene{"type", kForce + "type = 'wnd'\n", "7:8", "did you mean 'wind'?"},
        BadScene{"no body", kWind + "on = ['bal']\n", "9:1",
                 "no body is called 'bal'; did you mean 'ball'?"},
        BadScene{"no body fits", kWind + "on = 'box*'\n", "9:1", "no body is called 'box*'"},
        BadScene{"on what is fixed", kFloor + kWind + "on = 'floor'\n", "13:1",
                 "no body called 'floor' can be moved"},
        BadScene{"wind without", kForce + "type = 'wind'\n", "7:1",
                 "a wind has no velocity; write velocity = [3, 0, 0]"},
        BadScene{"density", kWind + "density = 0\n", "9:11",
                 "density is 0; it should be a number from 1e-06 to 1000000 kg/m^3"},
        BadScene{"unknown key", kWind + "dragg = 1\n", "9:1", "did you mean 'drag'?"},
        BadScene{"key of another type", kWind + "stiffness = 1\n", "9:1",
                 "unknown key 'stiffness' in a [[force]]"},
        BadScene{"times", kWind + "from = 2\nuntil = 1\n", "10:1",
                 "until is 1; it should be later than from, 2 s"},
        BadScene{"within", kWind + "within = { from = [0, 0, 0], to = [1, 0, 1] }\n", "9:1",
                 "within should be a box"},
        BadScene{"medium without", kForce + "type = 'medium'\n", "7:1",
                 "a force of type medium has no density; write density = 1000"},
        BadScene{"drag of nothing", kForce + "type = 'drag'\n", "7:1", "a drag has neither"},
        BadScene{"no centre", kForce + "type = 'point-gravity'\nstrength = 1\n", "7:1",
                 "write at = [0, 0, 0]"},
        BadScene{"spring without end", kForce + "type = 'spring'\na = 'ball'\nstiffness = 1\n",
                 "6:1", "a spring has no b"},
        BadScene{"spring to itself",
                 kForce + "type = 'spring'\na = 'ball'\nb = 'ball'\nstiffness = 1\n", "9:1",
                 "a spring of a body with itself"},
        BadScene{"spring of walls",
                 kFloor + kForce + "type = 'spring'\na = 'floor'\nb = 'world'\nstiffness = 1\n",
                 "13:1", "neither end of the spring can be moved"},
        BadScene{"constant nothing", kForce + "type = 'constant'\n", "7:1",
                 "a constant force has neither force nor torque"},
        BadScene{"chord", kForce + "type = 'airfoil'\narea = 1\nnormal = [2, 0, 0]\n", "9:1",
                 "chord and normal should be two directions"},
        BadScene{"stall", kForce + "type = 'airfoil'\narea = 1\nstall_deg = 91\n", "9:13",
                 "from 0 to 90 deg"}));

INSTANTIATE_TEST_SUITE_P(
    Meetings, BadScenes,
    testing::Values(
        BadScene{"ignores nobody", kBall + "group = 'wheels'\nignores = 'whels'\n", "7:1",
                 "no body is in the group 'whels'; did you mean 'wheels'?"},
        BadScene{"bad group", kBall + "group = 'a b'\n", "6:1", "group is 'a b'"},
        BadScene{"sensor", kBall + "sensor = 1\n", "6:10", "true or false"},
        BadScene{"path of one", kMover + "{ path = [[0, 1, 0]], times = [0] }\n", "5:15",
                 "at least two points"},
        BadScene{"path of no points", kMover + "{ path = [[0, 1], [1, 1]], times = [0, 1] }\n",
                 "5:23", "three numbers [x, y, z]"},
        BadScene{"no times", kMover + "{ path = [[0, 1, 0], [1, 1, 0]] }\n", "5:15",
                 "a path has no times"},
        BadScene{"times fall", kMover + "{ path = [[0, 1, 0], [1, 1, 0]], times = [0, 0] }\n",
                 "5:46", "begin with 0 and rise"},
        BadScene{"loop", kMover + kPath + ", loop = true }\n", "5:62", "should end where it began"},
        BadScene{"at", kMover + kPath + " }\nat = [0, 1, 0]\n", "6:1",
                 "leave it out: the path begins at its first point"},
        BadScene{"orbit", kMover + "{ orbit = { centre = [0, 1, 0] } }\n", "5:25",
                 "an orbit needs centre and deg_per_s"},
        BadScene{"velocity on a path", kMover + kPath + ", velocity = [1, 0, 0] }\n", "5:62",
                 "velocity of a body on a path; leave it out"}));

INSTANTIATE_TEST_SUITE_P(
    Bodies, BadScenes,
    testing::Values(
        BadScene{"no name", "[[body]]\nshape = { sphere = 1 }\n", "2:1", "has no name"},
        BadScene{"bad name", "[[body]]\nname = 'a b'\nshape = { sphere = 1 }\n", "3:1",
                 "1 to 64 of A-Z a-z 0-9"},
        BadScene{"world", "[[body]]\nname = 'world'\nshape = { sphere = 1 }\n", "3:1", "'world'"},
        BadScene{"two of one name", kBall + kBall, "6:1", "two bodies are called 'ball'"},
        BadScene{"no shape", "[[body]]\nname = 'a'\n", "2:1", "has no shape"},
        BadScene{"two shapes", "[[body]]\nname = 'a'\nshape = { sphere = 1, box = [1, 1, 1] }\n",
                 "4:9", "two shapes in one"},
        BadScene{"size 0", "[[body]]\nname = 'a'\nshape = { sphere = 0 }\n", "4:20",
                 "sphere is 0; it should be a number from 0.001 to 1000 m"},
        BadScene{"capsule",
                 "[[body]]\nname = 'a'\nshape = { capsule = { radius = 1, height = 1 } }\n", "4:35",
                 "at least twice the radius, 2"},
        BadScene{"a cylinder that is a number", "[[body]]\nname = 'a'\nshape = { cylinder = 1 }\n",
                 "4:22", "a cylinder is 1; it should be a table"},
        BadScene{"moving plane", "[[body]]\nname = 'a'\nshape = { plane = [0, 1, 0] }\n", "4:1",
                 "write fixed = true"},
        BadScene{"normal 0", "[[body]]\nname = 'a'\nshape = { plane = [0, 0, 0] }\nfixed = true\n",
                 "4:11", "direction out of the solid"},
        BadScene{"mass 0", kBall + "mass = 0\n", "6:8", "mass is 0; it should be a number from"},
        BadScene{"mass twice", kBall + "mass = 1\ndensity = 1\n", "7:1", "give one of them"},
        BadScene{"mass of a floor", kFloor + "mass = 1\n", "6:1", "that is fixed; leave it out"},
        BadScene{"light", "[[body]]\nname = 'a'\nshape = { sphere = 0.001 }\ndensity = 0.01\n",
                 "4:1", "give a mass"},
        BadScene{"material", kBall + "material = 'wod'\n[[material]]\nname = 'wood'\n", "6:1",
                 "no material is called 'wod'; did you mean 'wood'?"},
        BadScene{"inertia", kBall + "inertia = [1, 1, -1]\n", "6:1", "positive definite"},
        BadScene{"quaternion", kBall + "quaternion = [0, 0, 0, 0]\n", "6:1", "not all zero"},
        BadScene{"colour", kBall + "colour = 'red'\n", "6:10", "like \"#c89b6c\""},
        BadScene{"position", kBall + "velocity = [1, nan, 0]\n", "6:16", "velocity is nan"},
        BadScene{"restitution", kBall + "[[material]]\nname = 'm'\nrestitution = 1.5\n", "8:15",
                 "from 0 to 1"},
        BadScene{"rolling", kBall + "[[material]]\nname = 'm'\nrolling = -0.5\n", "8:11",
                 "rolling is -0.5; it should be a number from 0 to 10 m"}));

const std::string kJoint = kFloor + kBall + "[[joint]]\n";  // line 10

INSTANTIATE_TEST_SUITE_P(
    Joints, BadScenes,
    testing::Values(
        BadScene{"no type", kJoint + "a = 'world'\nb = 'ball'\n", "10:1", "has no type"},
        BadScene{"type", kJoint + "type = 'slidr'\na = 'world'\nb = 'ball'\n", "11:8",
                 "wheel or path; did you mean 'slider'?"},
        BadScene{"no body", kJoint + "type = 'ball'\na = 'world'\nb = 'bal'\nanchor = [0, 0, 0]\n",
                 "13:1", "no body is called 'bal'; did you mean 'ball'?"},
        BadScene{"itself", kJoint + "type = 'ball'\na = 'ball'\nb = 'ball'\nanchor = [0, 0, 0]\n",
                 "13:1", "with itself"},
        BadScene{"two fixed",
                 kJoint + "type = 'ball'\na = 'world'\nb = 'floor'\nanchor = [0, 0, 0]\n", "13:1",
                 "should be dynamic"},
        BadScene{"no anchor", kJoint + "type = 'ball'\na = 'world'\nb = 'ball'\n", "11:1",
                 "give either anchor"},
        BadScene{"no axis",
                 kJoint + "type = 'hinge'\na = 'world'\nb = 'ball'\nanchor = [0, 0, 0]\n", "11:1",
                 "write axis = [0, 0, 1]"},
        BadScene{"axis 0",
                 kJoint + "type = 'hinge'\na = 'world'\nb = 'ball'\nanchor = [0, 0, 0]\n"
                          "axis = [0, 0, 0]\n",
                 "15:1", "should be a direction"},
        BadScene{"axis of a weld",
                 kJoint + "type = 'weld'\na = 'world'\nb = 'ball'\n"
                          "anchor = [0, 0, 0]\naxis = [0, 0, 1]\n",
                 "15:1", "a weld joint has no axis; leave it out, or make it ball, hinge"},
        BadScene{"length 0",
                 kJoint + "type = 'distance'\na = 'world'\nb = 'ball'\n"
                          "anchor_a = [0, 2, 0]\n",
                 "11:1", "or use a ball"},
        BadScene{"world's end", kJoint + "type = 'distance'\na = 'world'\nb = 'ball'\n", "11:1",
                 "give anchor_a"},
        BadScene{"spring",
                 kJoint + "type = 'ball'\na = 'world'\nb = 'ball'\nanchor = [0, 0, 0]\n"
                          "spring = { damping = 1 }\n",
                 "15:10", "has no frequency"},
        BadScene{"strength",
                 kJoint + "type = 'ball'\na = 'world'\nb = 'ball'\nanchor = [0, 0, 0]\n"
                          "break_at = 0\n",
                 "15:12", "break_at is 0; it should be a number from"}));

INSTANTIATE_TEST_SUITE_P(
    Films, BadScenes,
    testing::Values(
        BadScene{"fov", kBall + "[camera]\nfov_deg = 180\n", "7:11", "from 1 to 170 deg"},
        BadScene{"eye", kBall + "[camera]\nfrom = [1, 1, 1]\nlook_at = [1, 1, 1]\n", "7:1",
                 "the same point"},
        BadScene{"theme", kBall + "[look]\ntheme = 'darc'\n", "7:9", "did you mean 'dark'?"},
        BadScene{"overlay", kBall + "[look]\nshow = ['contact']\n", "7:1",
                 "did you mean 'contacts'?"},
        BadScene{"overlay", kBall + "[look]\nshow = ['contacts', 'ghosts']\n", "7:1",
                 "did you mean 'ghost'?"},
        BadScene{"coloring", kBall + "[look]\ncolour_by = 'sped'\n", "7:13",
                 "did you mean 'speed'?"},
        BadScene{"color max", kBall + "[look]\ncolour_max = 0\n", "7:14", "m/s or N s"},
        BadScene{"light", kBall + "[look]\nlight = [1, 0.1, 0]\n", "7:1",
                 "light is [1, 0.1, 0]; it should point from the ground to the light, at least 10 degrees"},
        BadScene{"ghosts", kBall + "[look]\nghost_every = 0\n", "7:15", "0.001"},
        BadScene{"plot", kBall + "[look]\nplot = 'energie'\n", "7:8", "did you mean 'energy'?"},
        BadScene{"poster", kBall + "[[section]]\nat = 0\nposter = 'lst'\n", "8:10",
                 "did you mean 'last'?"},
        BadScene{"poster at", kBall + "[[section]]\nat = 0\nposter = 99\n", "8:10",
                 "from 0 to 5 s"},
        BadScene{"trails", kBall + "[look]\ntrails = ['box']\n", "7:1", "no body is called 'box'"},
        BadScene{"section", kBall + "[[section]]\nat = 99\n", "7:6", "from 0 to 5 s"},
        BadScene{"snapshot", kBall + "[snapshot]\nsize = [640, 16385]\n", "7:14", "16384"},
        BadScene{"what", kBall + "[[expect]]\nwhat = 'drit'\nbelow = 1\n", "7:8",
                 "did you mean 'drift'?"},
        BadScene{"no bound", kBall + "[[expect]]\nwhat = 'drift'\n", "7:1", "needs a bound"},
        BadScene{"near alone", kBall + "[[expect]]\nwhat = 'speed'\nnear = 1\n", "8:1",
                 "go together"},
        BadScene{"of whom", kBall + "[[expect]]\nwhat = 'speed'\nbelow = 1\nof = ['box*']\n", "9:1",
                 "no body is called 'box*'"},
        BadScene{"window", kBall + "[[expect]]\nwhat = 'speed'\nbelow = 1\nafter = 2\nuntil = 1\n",
                 "10:1", "should not be earlier than after, 2"}));

INSTANTIATE_TEST_SUITE_P(
    Cameras, BadScenes,
    testing::Values(
        BadScene{"keys", kBall + "[camera]\nkeys = 3\n", "7:8", "one or more tables"},
        BadScene{"no table", kBall + "[camera]\nkeys = [3]\n", "7:9",
                 "a key of the camera is 3; it should be a table"},
        BadScene{"no time", kBall + "[camera]\nkeys = [{ fov_deg = 30 }]\n", "7:9",
                 "a key of the camera has no time"},
        BadScene{"same time", kBall + "[camera]\nkeys = [{ at = 1 }, { at = 1 }]\n", "7:23",
                 "at is 1 s; it should be later than the key before, which is at 1 s"},
        BadScene{"too late", kBall + "[camera]\nkeys = [{ at = 5.1 }]\n", "7:16", "from 0 to 5 s"},
        BadScene{"ease", kBall + "[camera]\nkeys = [{ at = 1, ease = 'liner' }]\n", "7:26",
                 "smooth, linear, in, out or cut; did you mean 'linear'?"},
        BadScene{"upright", kBall + "[camera]\nkeys = [{ at = 1, from = [0, 9, 0] }]\n", "7:19",
                 "straight up or down"},
        BadScene{"in itself", kBall + "[camera]\nkeys = [{ at = 1, look_at = [8, 5, 14] }]\n",
                 "7:9", "the same point"},
        BadScene{"overhead",
                 kBall + "[camera]\nfrom = [0, 9, 5]\nlook_at = [0, 0, 0]\n"
                         "keys = [{ at = 1, from = [0, 9, -5] }]\n",
                 "9:11", "lead it around with a key in between"},
        BadScene{"follow", kBall + "[camera]\nfollow = 'bll'\n", "7:1", "did you mean 'ball'?"},
        BadScene{"lag", kBall + "[camera]\nfollow = 'ball'\nfollow_lag = -1\n", "8:14",
                 "from 0 to 100 s"},
        BadScene{"lag alone", kBall + "[camera]\nfollow_lag = 1\n", "7:1", "write follow"},
        BadScene{"aperture", kBall + "[camera]\naperture = 11\n", "7:12", "from 0 to 10 m"},
        BadScene{"focus on", kBall + "[camera]\nfocus = 'bal'\n", "7:1", "did you mean 'ball'?"},
        BadScene{"focus at", kBall + "[camera]\nfocus = 0\n", "7:9", "from 0.01 to 100000 m"},
        BadScene{"focus", kBall + "[camera]\nfocus = [1]\n", "7:1",
                 "it should be a body's name or a distance in m"}));

INSTANTIATE_TEST_SUITE_P(
    Repeats, BadScenes,
    testing::Values(
        BadScene{"no count", "[[repeat]]\nbody = { name = 'a', shape = { sphere = 1 } }\n", "2:1",
                 "has no count"},
        BadScene{"nothing", "[[repeat]]\ncount = 3\n", "2:1", "an empty [[repeat]]"},
        BadScene{"one name",
                 "[[repeat]]\ncount = 3\nbody = { name = 'a', shape = { sphere = 1 } }\n", "4:8",
                 "in a [[repeat]] with {i}"},
        BadScene{"too many",
                 "[[repeat]]\ncount = 10001\nbody = { name = 'a{i}', shape = { sphere = 1 } }\n",
                 "3:9", "from 1 to 10000"},
        BadScene{"far too many",
                 "[[repeat]]\ncount = 10000\n[[repeat.repeat]]\ncount = 10000\n"
                 "body = { name = 'a{i}.{j}', shape = { sphere = 1 } }\n",
                 "6:8", "more than 10000 bodies"},
        BadScene{"four deep",
                 "[[repeat]]\ncount = 1\n[[repeat.repeat]]\ncount = 1\n[[repeat.repeat.repeat]]\n"
                 "count = 1\n[[repeat.repeat.repeat.repeat]]\ncount = 1\n",
                 "8:24", "[[repeat]]s can be nested at most three deep"}));

INSTANTIATE_TEST_SUITE_P(
    ManyTurns, BadScenes,
    testing::Values(
        BadScene{"turns of nothing",
                 "[[repeat]]\ncount = 10000\n[[repeat.repeat]]\ncount = 10000\n"
                 "[[repeat.repeat.repeat]]\ncount = '0 * i'\nbody = { name = 'a' }\n",
                 "4:1", "more than 100000 turns of [[repeat]]s"}));

TEST(Reader, ReportsSeveralErrorsInTheOrderOfTheFile) {
    const std::vector<std::string> lines =
        errorsOf("format = 1\nx = 1\n" + kBall + "mass = 0\n[camera]\nfov_deg = 0\n");
    ASSERT_EQ(lines.size(), 3u) << listed(lines);
    EXPECT_TRUE(lines[0].starts_with("a.toml:2:1: "));
    EXPECT_TRUE(lines[1].starts_with("a.toml:7:8: "));
    EXPECT_TRUE(lines[2].starts_with("a.toml:9:11: "));
}

/// Consequences of an error are not reported as well.
TEST(Reader, ReportsOneCauseOnce) {
    const std::string cause[] = {
        "[[body]]\nname = 'a'\nshape = { plane = [0, 1, 0] }\n",
        "[[body]]\nname = 'a'\nshape = { mesh = { points = [[0, 0, 0], [1, 0, 0], [0, 0, 1]], "
        "triangles = [[0, 1, 2]] } }\n",
        "[[repeat]]\ncount = 1\n[[repeat.repeat]]\ncount = 1\n[[repeat.repeat.repeat]]\n"
        "count = 1\n[[repeat.repeat.repeat.repeat]]\ncount = 1\n",
        "[[repeat]]\ncount = 1\nbody = 3\n"};
    for (const std::string& text : cause) {
        const std::vector<std::string> lines = errorsOf("format = 1\n" + text);
        EXPECT_EQ(lines.size(), 1u) << text << listed(lines);
    }
}

TEST(Reader, ReportsTwentyErrorsAndHowManyMore) {
    std::string text = "format = 1\n" + kBall;
    for (int i = 0; i < 30; ++i)
        text += std::string(static_cast<std::size_t>(i) + 1, 'x') + " = 1\n";
    const std::vector<std::string> lines = errorsOf(text);
    ASSERT_EQ(lines.size(), 21u);
    EXPECT_EQ(lines.back(), "and 10 more");
}

TEST(Reader, AsksForTheFormat) {
    EXPECT_TRUE(tells(errorsOf(""), "a.toml:1:1: ", "begin it with format = 1"));
    EXPECT_TRUE(tells(errorsOf("format = 2\n" + kBall), "a.toml:1:1: ", "reads format 1"));
}

TEST(Reader, ReportsAListWhereATableShouldBe) {
    for (const char* key : {"material", "body", "joint", "repeat", "section", "expect"})
        EXPECT_TRUE(
            tells(errorsOf(std::string(key) + " = ['oak']\n"), "a.toml:1:", "it should be a table"))
            << key;
}

}  // namespace
}  // namespace demos::test
