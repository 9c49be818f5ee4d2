#include "demos/text/synonyms.h"

#include <algorithm>
#include <vector>

namespace demos {
namespace {

/// A line per meaning. A word may have several; names that come first are preferred.
constexpr std::string_view kMeanings[] = {
    // shapes
    "sphere ball orb globe",
    "box cube cuboid block brick rectangle rect square",
    "capsule pill",
    "cylinder disc disk tube",
    "plane ground floor halfspace",
    "hull convex convexhull polyhedron",
    "mesh trimesh triangles",
    "heightfield heightmap terrain",
    "compound parts children union",
    // bodies
    "body bodies object objects entity rigidbody",
    "at from position pos location place xyz coordinates translation origin centre center",
    "turndeg rotation rot rotate turn angle angles angledeg rotationdeg orientation orient euler rpy",
    "quaternion quat",
    "velocity speed vel v linearvelocity",
    "speed velocity",
    "spin angularvelocity rotationalvelocity angvel omega spindeg",
    "mass weight",
    "density rho",
    "inertia moment momentofinertia",
    "fixed static isstatic immovable immobile frozen pinned anchored dynamic movable",
    "kinematic animated scripted",
    "shape geometry geom collider size type kind",
    "sensor trigger",
    "ignores nocollide excludes",
    "group layer layers collisiongroup category",
    "name id label",
    "colour color rgb rgba paint",
    "colourby colorby colourmap colormap",
    "colourmax colormax",
    "look appearance finish texture surface",
    "friction mu frictioncoefficient frictioncoeff",
    "restitution bounce bouncy bounciness elasticity elastic",
    "rolling rollingfriction rollingresistance",
    // world and solver
    "gravity g",
    "hz fps rate frequency timestep dt stepspersecond",
    "seed randomseed random",
    "seconds duration length time runtime",
    "sweeps iterations iters velocityiterations",
    "warmstart warmstarting",
    "sleeping sleep allowsleep cansleep",
    "threads cores jobs",
    "tolerance epsilon eps",
    "steady accurate precise quality",
    "fast quick",
    // joints
    "hinge revolute pin rotational",
    "slider prismatic linear piston",
    "weld fixed rigid glue lock",
    "ball socket spherical sphere ballsocket ballandsocket point",
    "distance rope rod link stick cord",
    "sixdof 6dof d6 generic",
    "universal cardan",
    "wheel suspension",
    "anchor pivot at position",
    "axis direction",
    "a bodya body1 parent",
    "b bodyb body2 child",
    "limits limit range",
    "motor drive actuator",
    "breakat breakforce maxforce",
    "stiffness k springconstant",
    "damping damper",
    // forces
    "on body bodies target targets",
    "of body bodies joint joints target targets",
    "medium water fluid liquid buoyancy",
    "wind air",
    "pointgravity attractor planet",
    "nbodygravity gravitation",
    // camera, look and sections
    "from eye position pos location at",
    "lookat target focuspoint aim",
    "fovdeg fov fieldofview zoom",
    "orbitdegpers orbit orbitspeed",
    "follow track chase",
    "theme style background",
    "show overlays overlay",
    "trails trail paths",
    "studio light white default",
    "dark black night",
    "caption subtitle",
    "at time start",
    "from start begin after",
    "until end stop to",
    "linear constant",
    "smooth easeinout inout",
    "cut jump",
    "contacts contactpoints points",
    "com centreofmass centerofmass",
    "bounds aabb aabbs boundingbox boundingboxes",
    "ids names labels",
    "stats statistics info hud",
    "plot chart graph",
    "joints constraints",
    // expectations and repeats
    "below max maximum most lessthan under atmost smallerthan",
    "above min minimum least greaterthan over atleast largerthan",
    "near equals equal value",
    "within tolerance",
    "after from start since",
    "why reason because",
    "what measure quantity kind type",
    "drift displacement shift",
    "penetration overlap depth",
    "separation gap",
    "angledeg angle tilt lean turndeg rotation",
    "position place pos at",
    "height y altitude",
    "count n times number",
    "step offset spacing",
    "jitter noise",
    "smaller min minimum",
    "larger max maximum",
    "average mean",
    "product multiply",
};

bool isBetween(char c) { return c == '_' || c == '-' || c == ' '; }

std::string lettersOf(std::string_view word) {
    std::string letters;
    for (const char c : word)
        if (!isBetween(c)) letters += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return letters;
}

std::vector<std::string_view> wordsOf(std::string_view line) {
    std::vector<std::string_view> words;
    while (!line.empty()) {
        const std::size_t end = std::min(line.find(' '), line.size());
        words.push_back(line.substr(0, end));
        line.remove_prefix(std::min(end + 1, line.size()));
    }
    return words;
}

std::string named(std::string_view letters, std::span<const std::string> names) {
    for (const std::string& name : names)
        if (lettersOf(name) == letters) return name;
    return {};
}

}  // namespace

bool sameLetters(std::string_view a, std::string_view b) { return lettersOf(a) == lettersOf(b); }

std::string sameMeaning(std::string_view word, std::span<const std::string> names) {
    const std::string letters = lettersOf(word);
    if (letters.empty()) return {};
    if (const std::string same = named(letters, names); !same.empty()) return same;
    for (const std::string_view line : kMeanings) {
        if (line.find(letters) == line.npos) continue;
        const std::vector<std::string_view> words = wordsOf(line);
        if (std::find(words.begin(), words.end(), letters) == words.end()) continue;
        for (const std::string_view other : words)
            if (const std::string name = named(other, names); !name.empty()) return name;
    }
    return {};
}

}  // namespace demos
