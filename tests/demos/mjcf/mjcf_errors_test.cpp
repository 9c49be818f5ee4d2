// Errors of a MuJoCo model are reported with their place; unsupported features give a note, never
// silence.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "demos/load/load_scene.h"
#include "tests/demos/mjcf/mjcf_reading.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace demos::test {
namespace {

using support::repeated;

const std::string kGeom = "<worldbody><geom size='1'/></worldbody>\n";
const std::string kFree = "<worldbody>\n<body><freejoint/>";  // ends in line 3
const std::string kEnd = "</body></worldbody>\n";

struct BadModel {
    const char* what;
    std::string text;  // between <mujoco> and </mujoco>, from line 2 on
    const char* place;
    const char* message;
};

std::ostream& operator<<(std::ostream& out, const BadModel& bad) { return out << bad.what; }

class BadModels : public testing::TestWithParam<BadModel> {};

TEST_P(BadModels, AreReportedWithTheirPlace) {
    const BadModel& bad = GetParam();
    const std::vector<std::string> lines = modelErrors("<mujoco>\n" + bad.text + "</mujoco>\n");
    EXPECT_TRUE(tells(lines, std::string("a.xml:") + bad.place + ": ", bad.message))
        << bad.what << "\n"
        << listed(lines);
}

std::string deep(int levels) {
    std::string text;
    for (int i = 0; i < levels; ++i) text += "<body>";
    for (int i = 0; i < levels; ++i) text += "</body>";
    return text;
}

std::string attributes(int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += " a" + std::to_string(i) + "='1'";
    return text;
}

INSTANTIATE_TEST_SUITE_P(
    Files, BadModels,
    testing::Values(
        BadModel{"no XML", "<worldbody>\n<geom size=1/>\n", "3:12", "this is not XML: "},
        BadModel{"tags that do not match", "<worldbody>\n</body>", "3:3",
                 "this is not XML: Start-end tags mismatch"},
        BadModel{"attribute twice", "<worldbody><geom size='1' size='2'/></worldbody>", "2:27",
                 "two attributes 'size' in one <geom>; leave one out"},
        BadModel{"too many attributes",
                 "<worldbody><geom size='1'" + attributes(300) + "/></worldbody>", "2:2212",
                 "more than 256 attributes in one <geom>"},
        BadModel{"too deep", "<worldbody>" + deep(70) + "</worldbody>", "2:384",
                 "elements nested more than 64 deep; nest them less deeply"},
        BadModel{"too many", "<worldbody>" + repeated("<geom/>", 200'001) + "</worldbody>",
                 "2:1399998", "more than 200000 elements"},
        BadModel{"too many bodies",
                 "<worldbody>" + repeated("<geom size='1'/>", 10'001) + "</worldbody>", "1:1",
                 "more than 10000 bodies; a model should have fewer"},
        BadModel{"include of nothing", "<include/>", "2:1", "an <include> has no file"},
        BadModel{"include from anywhere", "<include file='/etc/passwd'/>", "2:10",
                 "file is '/etc/passwd'; it should be relative to the model's folder"},
        BadModel{"include of what is not there", "<include file='b.xml'/>", "2:10",
                 "b.xml: there is no such file"},
        BadModel{"no geom", "", "1:1", "the model has no <geom>; give it some"},
        BadModel{"no geom but copies",
                 "<worldbody><replicate count='2'><geom size='1'/></replicate></worldbody>", "1:1",
                 "the model has no <geom>; give it some: its <replicate> is not supported"}));

INSTANTIATE_TEST_SUITE_P(
    Words, BadModels,
    testing::Values(
        BadModel{"element", "<worldbdy/>" + kGeom, "2:1",
                 "there is no <worldbdy> in <mujoco>; did you mean 'worldbody'?"},
        BadModel{"element in its wrong place", "<worldbody><joint/></worldbody>", "2:12",
                 "there is no <joint> in <worldbody>"},
        BadModel{"attribute", "<worldbody><geom sise='1'/></worldbody>", "2:18",
                 "unknown attribute 'sise' of <geom>; did you mean 'size'?"},
        BadModel{"attribute in a default", "<default>\n<geom fricton='1'/></default>" + kGeom, "3:7",
                 "did you mean 'friction'?"},
        BadModel{"class", "<default><default class='wheel'/></default>\n<worldbody>"
                          "<geom class='weel' size='1'/></worldbody>", "3:18",
                 "no default class is called 'weel'; did you mean 'wheel'?"},
        BadModel{"class twice", "<default><default class='w'/><default class='w'/></default>" + kGeom,
                 "2:39", "two classes are called 'w'; rename one"},
        BadModel{"class without a name", "<default><default/></default>" + kGeom, "2:10",
                 "an inner <default> has no class; write class=\"NAME\""},
        BadModel{"mesh", "<worldbody><geom type='mesh' mesh='cup'/></worldbody>", "2:30",
                 "no mesh is called 'cup'"},
        BadModel{"material", "<worldbody><geom size='1' material='red'/></worldbody>", "2:27",
                 "no material is called 'red'"},
        BadModel{"body of exclude", kGeom + "<contact><exclude body1='a' body2='b'/></contact>", "3:19",
                 "no body is called 'a'"},
        BadModel{"body of connect", kGeom + "<equality><connect body1='a' anchor='0 0 0'/></equality>",
                 "3:20", "no body is called 'a'"},
        BadModel{"two bodies", "<worldbody><geom size='1'/><body name='a'/><body name='a'/></worldbody>",
                 "2:50", "two bodies are called 'a'; rename one"}));

INSTANTIATE_TEST_SUITE_P(
    Values, BadModels,
    testing::Values(
        BadModel{"letters", "<worldbody><geom size='big'/></worldbody>", "2:18",
                 "size is 'big'; it should be 1 to 3 numbers from 0 to 10000 m"},
        BadModel{"nan", "<worldbody><geom size='nan'/></worldbody>", "2:18", "size is 'nan'"},
        BadModel{"infinite", "<worldbody><geom size='1' pos='0 0 1e999'/></worldbody>", "2:27",
                 "pos is '0 0 1e999'; it should be 3 numbers from -100000 to 100000 m"},
        BadModel{"too few", "<worldbody><geom type='box' size='1 1'/></worldbody>", "2:29",
                 "size is '1 1'; it should be 3 numbers"},
        BadModel{"nothing", "<worldbody><geom size='0'/></worldbody>", "2:18",
                 "size is '0'; each should be at least 0.00001 m"},
        BadModel{"no size", "<worldbody><geom type='capsule'/></worldbody>", "2:12",
                 "a <geom> of type capsule has no size; write size=\"0.1 0.2\" (m; half lengths)"},
        BadModel{"type", "<worldbody><geom type='cube' size='1'/></worldbody>", "2:18",
                 "type is 'cube'; it should be"},
        BadModel{"one end", "<worldbody><geom type='capsule' size='1' fromto='1 1 1 1 1 1'/></worldbody>",
                 "2:42", "the two ends are the same point; move one of them"},
        BadModel{"fromto of a sphere", "<worldbody><geom size='1' fromto='0 0 0 1 1 1'/></worldbody>",
                 "2:27", "fromto is given for a sphere; give pos instead"},
        BadModel{"truth", "<compiler autolimits='yes'/>" + kGeom, "2:11",
                 "autolimits is 'yes'; it should be true or false"},
        BadModel{"global", "<compiler coordinate='global'/>" + kGeom, "2:11", "coordinate is 'global'"},
        BadModel{"sequence", "<compiler eulerseq='xyw'/>" + kGeom, "2:11",
                 "eulerseq is 'xyw'; it should be three of x, y, z, or three of X, Y, Z"},
        BadModel{"timestep", "<option timestep='0'/>" + kGeom, "2:9",
                 "timestep is '0'; it should be 1 number from 0.00001 to 1 s"},
        BadModel{"bits", "<worldbody><geom size='1' contype='1.5'/></worldbody>", "2:27",
                 "contype is 1.5; it should be a whole number"},
        BadModel{"colour", "<worldbody><geom size='1' rgba='1 1 1'/></worldbody>", "2:27",
                 "rgba is '1 1 1'; it should be 4 numbers from 0 to 1"},
        BadModel{"quaternion", "<worldbody><geom size='1' quat='0 0 0 0'/></worldbody>", "2:27",
                 "quat is 0 0 0 0; it should be a rotation, like 1 0 0 0"},
        BadModel{"axes", "<worldbody><geom size='1' xyaxes='1 0 0 2 0 0'/></worldbody>", "2:27",
                 "xyaxes should be two directions that are not parallel"},
        BadModel{"z axis", "<worldbody><geom size='1' zaxis='0 0 0'/></worldbody>", "2:27",
                 "zaxis is 0 0 0; it should be a direction, like 0 0 1"},
        BadModel{"axis and angle", "<worldbody><geom size='1' axisangle='0 0 0 1'/></worldbody>", "2:27",
                 "axisangle should be an axis that is not zero"},
        BadModel{"two orientations",
                 "<worldbody><geom size='1' quat='1 0 0 0' euler='0 0 0'/></worldbody>", "2:12",
                 "two orientations in one <geom>; give one of quat, axisangle, xyaxes, zaxis, euler"}));

INSTANTIATE_TEST_SUITE_P(
    Bodies, BadModels,
    testing::Values(
        BadModel{"no mass", kFree + kEnd, "3:1",
                 "a <body> with a joint has no mass to move, or no inertia (mass 0 kg); it should "
                 "have <geom>s, or an <inertial>"},
        BadModel{"no mass but a composite", kFree + "<composite type='rope'/>" + kEnd, "3:1",
                 "its <composite> is not supported"},
        BadModel{"inertia of nothing",
                 kFree + "<inertial pos='0 0 0' mass='1' diaginertia='1 0 1'/>" + kEnd, "3:1",
                 "has no mass to move, or no inertia"},
        BadModel{"inertial without a mass", kFree + "<inertial pos='0 0 0' diaginertia='1 1 1'/>" + kEnd,
                 "3:19", "an <inertial> has no mass; write mass=\"1\" (kg)"},
        BadModel{"inertial without inertia", kFree + "<inertial pos='0 0 0' mass='1'/>" + kEnd, "3:19",
                 "an <inertial> has no inertia; write diaginertia or fullinertia"},
        BadModel{"inertial that is asked for",
                 "<compiler inertiafromgeom='false'/>" + kFree + "<geom size='1'/>" + kEnd, "3:1",
                 "a <body> that moves has no <inertial>, and inertiafromgeom is 'false'; write one"},
        BadModel{"plane that moves", kFree + "<geom type='plane' size='1 1 1'/>" + kEnd, "3:19",
                 "a plane in a <body> that moves; it should be in <worldbody>, or a box"},
        BadModel{"free inside", "<worldbody><body><joint/><geom size='1'/>\n<body><freejoint/>"
                                "<geom size='1'/></body></body></worldbody>", "3:1",
                 "a free joint with other joints, or in a moving <body>"},
        BadModel{"free twice", kFree + "<joint type='free'/><geom size='1'/>" + kEnd, "3:1",
                 "a free joint with other joints, or in a moving <body>"},
        BadModel{"free twice by name", kFree + "<freejoint/><geom size='1'/>" + kEnd, "3:1",
                 "a free joint with other joints, or in a moving <body>"},
        BadModel{"moments of no mass",
                 kFree + "<inertial pos='0 0 0' mass='1' diaginertia='1 1 9'/>" + kEnd, "3:50",
                 "diaginertia is '1 1 9'; no moment should be larger than the sum of the others"},
        BadModel{"negative moments",
                 kFree + "<inertial pos='0 0 0' mass='1' diaginertia='1 1 -1'/>" + kEnd, "3:50",
                 "diaginertia is '1 1 -1'; it should not be negative"},
        BadModel{"moments of no mass, turned",
                 kFree + "<inertial pos='0 0 0' mass='1' fullinertia='5 5 1 4 0 0'/>" + kEnd, "3:50",
                 "fullinertia is '5 5 1 4 0 0'; no moment should be larger than the sum of the others"},
        BadModel{"inertia not positive",
                 kFree + "<inertial pos='0 0 0' mass='1' fullinertia='1 1 1 2 0 0'/>" + kEnd, "3:50",
                 "fullinertia is '1 1 1 2 0 0'; it should be positive definite (xx yy zz xy xz yz)"},
        BadModel{"far away", kFree + "<geom size='1' pos='9e4 0 0'/><body pos='9e4 0 0'>"
                                     "<joint/><geom size='1' pos='9e4 0 0'/></body>" + kEnd, "3:49",
                 "a body more than 100000 m from the origin; it should be nearer"}));

std::string jointed(const std::string& joints) {
    return "<worldbody>\n<body>" + joints + "<geom size='1'/></body></worldbody>\n";
}

INSTANTIATE_TEST_SUITE_P(
    Joints, BadModels,
    testing::Values(
        BadModel{"range", jointed("<joint range='20 10'/>"), "3:14",
                 "a limited joint has no valid range; it should be two numbers, the lower one first"},
        BadModel{"no range", jointed("<joint limited='true'/>"), "3:7", "a limited joint has no valid range"},
        BadModel{"axis", jointed("<joint axis='0 0 0'/>"), "3:14",
                 "axis is 0 0 0; it should be a direction, like 0 0 1"},
        BadModel{"damping", jointed("<joint damping='-1'/>"), "3:14", "damping is '-1'"},
        BadModel{"hinges askew", jointed("<joint axis='1 0 0'/><joint axis='1 1 0'/>"), "3:7",
                 "the 2 joints of this <body> cannot be one joint here (axes that are not at right "
                 "angles); put them in separate <body>s, each with some mass"},
        BadModel{"slide after hinge", jointed("<joint/><joint type='slide'/>"), "3:7",
                 "(a slide after a hinge)"},
        BadModel{"the same twice", jointed("<joint type='slide'/><joint type='slide'/>"), "3:7",
                 "(two along the same axis)"},
        BadModel{"balls", jointed("<joint type='ball'/><joint type='ball'/>"), "3:7",
                 "(a ball with another ball or a hinge)"},
        BadModel{"connect without an anchor",
                 jointed("<joint/>") + "<equality><connect body1='world'/></equality>", "4:11",
                 "a <connect> has no anchor"}));

INSTANTIATE_TEST_SUITE_P(
    Meshes, BadModels,
    testing::Values(
        BadModel{"flat", "<asset><mesh name='m' vertex='0 0 0 1 0 0 0 1 0 1 1 0'/></asset>" + kGeom,
                 "2:8", "mesh 'm' has no convex hull; its corners should not lie in one plane"},
        BadModel{"not three", "<asset><mesh name='m' vertex='0 0 0 1 0 0 0 1 0 1 1 0 3'/></asset>",
                 "2:23", "vertex has 13 numbers; it should be three for each corner"},
        BadModel{"no corners", "<asset><mesh name='m'/></asset>", "2:8",
                 "a <mesh> should have vertex, or a file in the model's folder"},
        BadModel{"no file", "<asset><mesh file='m.obj'/></asset>", "2:14",
                 "m.obj: there is no such file"},
        BadModel{"twice", "<asset><mesh name='m' vertex='0 0 0 1 0 0 0 1 0 0 0 1'/>\n"
                          "<mesh name='m' vertex='0 0 0 1 0 0 0 1 0 0 0 1'/></asset>", "3:1",
                 "two meshes are called 'm'; rename one"},
        BadModel{"reference", "<asset><mesh name='m' vertex='0 0 0 1 0 0 0 1 0 0 0 1' "
                              "refquat='0 0 0 0'/></asset>", "2:56", "refquat is 0 0 0 0"},
        BadModel{"fitted", "<asset><mesh name='m' vertex='0 0 0 1 0 0 0 1 0 0 0 1'/></asset>\n"
                           "<worldbody><geom type='box' mesh='m'/></worldbody>", "3:29",
                 "mesh in a <geom> of type box, which MuJoCo would fit to it; write type=\"mesh\""}));

TEST(MujocoErrors, OfFilesNameTheFile) {
    const std::string text = "<mujoco><asset><mesh file='m.obj'/><mesh file='n.stl'/>"
                             "<mesh file='o.msh'/></asset></mujoco>";
    const std::vector<std::string> lines =
        modelErrors(text, {{"m.obj", "v 1 2 3\nv 1 x 3\n"}, {"n.stl", "solid"}, {"o.msh", ""}});
    EXPECT_TRUE(tells(lines, "a.xml:1:22: ", "m.obj: line 2 should be 'v' and three numbers"));
    EXPECT_TRUE(tells(lines, "a.xml:1:42: ", "n.stl: its size is not that of a binary STL file"));
    EXPECT_TRUE(tells(lines, "a.xml:1:62: ", "o.msh: its format is not supported; it should be OBJ or"))
        << listed(lines);
}

TEST(MujocoErrors, OfContinuedLinesNameTheFirst) {
    const std::vector<std::string> lines =
        modelErrors("<mujoco><asset><mesh file='m.obj'/></asset></mujoco>",
                    {{"m.obj", "v 1 \\\r\n2 3\nv 1 2 3\nv 1 \\\n x 3\n"}});
    EXPECT_TRUE(tells(lines, "a.xml:1:22: ", "m.obj: line 4 should be 'v' and three numbers"))
        << listed(lines);
}

TEST(MujocoErrors, AnIncludedFileHasItsOwnPlacesAndIsReadOnce) {
    const std::vector<std::string> lines =
        modelErrors("<mujoco>\n<include file='b.xml'/>\n<include file='b.xml'/></mujoco>",
                    {{"b.xml", "<mujoco>\n<worldbody>\n<geom sise='1'/></worldbody></mujoco>"}});
    EXPECT_TRUE(tells(lines, "b.xml:3:7: ", "unknown attribute 'sise'") ||
                tells(lines, "a.xml:3:10: ", "'b.xml' is included twice"));
    EXPECT_TRUE(tells(lines, "a.xml:3:10: ", "'b.xml' is included twice; include it only once"))
        << listed(lines);
    const std::vector<std::string> circle = modelErrors(
        "<mujoco><include file='b.xml'/></mujoco>", {{"b.xml", "<mujoco><include file='b.xml'/></mujoco>"}});
    EXPECT_TRUE(tells(circle, "b.xml:1:18: ", "included twice")) << listed(circle);
    const std::vector<std::string> inside =
        modelErrors("<mujoco><include file='b.xml'/></mujoco>",
                    {{"b.xml", "<mujoco>\n<worldbody>\n<geom sise='1'/></worldbody></mujoco>"}});
    EXPECT_TRUE(tells(inside, "b.xml:3:7: ", "unknown attribute 'sise'")) << listed(inside);
}

TEST(MujocoErrors, OfAPartAreNotReportedAgainOfTheMass) {
    for (const char* part : {"<geom type='box' size='1'/>", "<geom type='plane' size='1 1 1'/>",
                             "<geom type='mesh' mesh='none'/>",
                             "<inertial pos='0 0 0' mass='1' fullinertia='1 1 1 2 0 0'/>",
                             "<body><geom size='big'/></body>"}) {
        const auto lines = modelErrors("<mujoco>\n" + kFree + part + kEnd + "</mujoco>");
        EXPECT_EQ(lines.size(), 1u) << part << "\n" << listed(lines);
        EXPECT_EQ(listed(lines).find("no mass to move"), std::string::npos) << part;
    }
    // A geom that is left out with a note is not an error, but the missing mass is.
    EXPECT_TRUE(tells(modelErrors("<mujoco>\n" + kFree + "<geom type='hfield'/>" + kEnd + "</mujoco>"),
                      "a.xml:3:1: ", "has no mass to move"));
}

TEST(MujocoErrors, AThinDiscIsNone) {  // A + B = C, written with six digits
    for (const char* inertia : {"diaginertia='0.333333 0.166667 0.166667'", "diaginertia='2 1 1'",
                                "fullinertia='1.5 1.5 1 0.5 0 0'"})
        EXPECT_EQ(modelErrors("<mujoco>" + kFree + "<inertial pos='0 0 0' mass='1' " + inertia + "/>" +
                              kEnd + "</mujoco>"),
                  std::vector<std::string>{})
            << inertia;
}

TEST(MujocoErrors, OfFoldersDoNotSpeakOfScenes) {
    const support::TemporaryFolder folder;
    std::filesystem::create_directory(folder / "m.obj");
    std::ofstream(folder / "a.xml") << "<mujoco><asset><mesh file='m.obj'/></asset></mujoco>";
    try {
        loadScene((folder / "a.xml").string());
        FAIL();
    } catch (const SceneError& error) {
        EXPECT_TRUE(tells(error.lines(), (folder / "a.xml:1:22: ").string(),
                          "m.obj: is a directory; it should be a file of the model"))
            << listed(error.lines());
    }
}

TEST(MujocoErrors, AnotherRootIsReported) {
    EXPECT_TRUE(tells(modelErrors("<robot/>"), "a.xml:1:1: ",
                      "the root element is <robot>; it should be <mujoco>"));
    EXPECT_TRUE(tells(modelErrors(""), "a.xml:1:1: ", "this is not XML: "));
    EXPECT_TRUE(tells(modelErrors("<mujoco/><mujoco/>"), "a.xml:1:1", "a second root element"));
}

TEST(MujocoErrors, MoreThanThirtyTwoGroupsAreReported) {
    std::string geoms;
    for (int i = 0; i < 40; ++i)
        geoms += "<geom size='1' conaffinity='0' contype='" + std::to_string(i + 1) + "'/>";
    const auto lines = modelErrors("<mujoco><worldbody>" + geoms + "</worldbody></mujoco>");
    EXPECT_TRUE(tells(lines, "a.xml:1:1: ", "more than 32 groups of bodies")) << listed(lines);
}

std::vector<std::string> notesOf(const std::string& inside) { return readMujoco(inside).notes; }

TEST(MujocoNotes, NameWhatChangesTheMotionAndIsNotHad) {
    const std::vector<std::string> notes = notesOf(
        "<option wind='1 0 0' integrator='RK4' viscosity='0'/>\n"
        "<default>\n<geom solref='0.02 1' condim='3'/><joint margin='0.1' armature='0'/></default>\n"
        "<worldbody>\n<geom size='1' condim='6'/><geom size='1' condim='4'/>\n"
        "<geom type='hfield' hfield='h'/>\n"
        "<body><joint type='ball' damping='1' range='0 10'/><geom size='1'/></body></worldbody>\n"
        "<tendon><spatial/></tendon>\n<actuator><muscle joint='j'/></actuator><keyframe/>\n"
        "<contact><pair geom1='a' geom2='b'/></contact>\n");
    const std::vector<std::string> expected{
        "a.xml:2:9: <option wind> is not supported; left out",
        "a.xml:4:7: <geom solref> is not supported; left out",
        "a.xml:4:42: <joint margin> is not supported; left out",
        "a.xml:6:16: torsional friction is not supported; left out (2 places)",
        "a.xml:7:7: a <geom> of type hfield is not supported; left out",
        "a.xml:8:26: damping of a ball joint is not supported; left out",
        "a.xml:8:38: range of a ball joint is not supported; left out",
        "a.xml:9:9: a <spatial> tendon that is not straight between two <site>s is not supported; "
        "left out",
        "a.xml:10:11: <muscle> in <actuator> is not supported; left out",
        "a.xml:11:10: <pair> in <contact> is not supported; left out"};
    EXPECT_EQ(notes, expected);
}

TEST(MujocoNotes, PutWhatIsForMujocosWindowInOne) {
    EXPECT_EQ(notesOf("<visual/><sensor/><custom/>\n<worldbody><light/><camera/><site/><light/>"
                      "<geom size='1'/></worldbody>"),
              std::vector<std::string>{"a.xml:2:1: <visual>, <sensor>, <custom>, <light>, <camera>: "
                                       "for MuJoCo's viewer and sensors; left out"});
    EXPECT_EQ(notesOf("<size njmax='9'/><option solver='CG'/><asset/><tendon/>" + kGeom),
              std::vector<std::string>{});
}

TEST(MujocoNotes, TellWhatIsApproximate) {
    const auto said = [](const std::string& inside, const std::string& text) {
        const std::vector<std::string> notes = notesOf(inside);
        return tells(notes, "a.xml:", text);
    };
    EXPECT_TRUE(said("<option timestep='0.003'/>" + kGeom,
                     "timestep is 0.003 s; replaced by 360 steps a second, a multiple of 60"));
    EXPECT_TRUE(said("<worldbody><body><freejoint/><geom size='1'/><geom size='1' friction='2'/>" + kEnd,
                     "friction, condim or priority differ between the <geom>s of a body"));
    EXPECT_TRUE(said("<worldbody><body><freejoint/><geom size='1'/><geom size='1' contype='2'/>" + kEnd,
                     "contype or conaffinity differ between the <geom>s of a body"));
    EXPECT_TRUE(said(jointed("<joint axis='1 0 0' pos='0 0 1'/><joint axis='0 1 0'/>"),
                     "the hinges of a <body> are at different points, 1 m apart"));
    EXPECT_TRUE(said("<worldbody><geom type='ellipsoid' size='1 2 3'/></worldbody>",
                     "an ellipsoid is replaced by a convex hull of 120 corners"));
    EXPECT_TRUE(said("<worldbody><body name='a'><freejoint/><geom size='1'/></body></worldbody>"
                     "<equality><connect body1='a' anchor='0 0 3'/></equality>",
                     "bodies held by a <connect> are held rigidly"));
    EXPECT_TRUE(said("<worldbody><body name='a'><geom size='1'/></body></worldbody>"
                     "<equality><weld body1='a'/></equality>",
                     "<weld> within one rigid body has no effect; left out"));
    EXPECT_TRUE(said("<worldbody><geom size='1'/><body name='a'><freejoint/><geom size='1'/></body>"
                     "</worldbody><contact><exclude body1='a' body2='world'/></contact>",
                     "<exclude> with a <body> that stands still is not supported; left out"));
}

}  // namespace
}  // namespace demos::test
