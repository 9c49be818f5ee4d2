// Words as of MuJoCo 3.3 (its documentation, 'XML reference'), and those of 2.x removed since.
#include "demos/mjcf/vocabulary.h"

#include <array>
#include <charconv>
#include <span>

#include "demos/text/nearest.h"

namespace demos::mjcf {
namespace {

/// How an element in a valid position is treated.
enum class Fate {
    read,    // with its attributes and children
    unseen,  // viewer, sensors or bookkeeping: left out, one note for all
    silent,  // left out without a note: has no effect by itself
    lacking  // changes the motion, but is not supported: a note
};

/// Lists of words, separated by spaces. `lacking`: attributes that need a note, unless they have
/// the value after '=', whose numbers are separated by commas.
struct Kind {
    std::string_view in;  // the parent element; "*": worldbody, body or frame
    std::string_view name;
    Fate fate = Fate::read;
    std::string_view read, silent, lacking;
};

// clang-format off
constexpr std::array kKinds{
    Kind{"", "mujoco", Fate::read, "model", "", ""},

    Kind{"mujoco", "compiler", Fate::read,
         "autolimits coordinate angle eulerseq meshdir assetdir inertiafromgeom",
         "texturedir discardvisual fitaabb usethread fusestatic exactmeshinertia alignfree "
         "saveinertial conflict",
         "boundmass=0 boundinertia=0 settotalmass=-1 balanceinertia=false strippath=false "
         "convexhull=true inertiagrouprange=0,5"},
    Kind{"mujoco", "option", Fate::read, "timestep gravity",
         "apirate tolerance ls_tolerance noslip_tolerance mpr_tolerance ccd_tolerance "
         "sleep_tolerance magnetic integrator cone jacobian solver iterations ls_iterations "
         "noslip_iterations mpr_iterations ccd_iterations sdf_iterations sdf_initpoints "
         "actuatorgroupdisable",
         "wind=0,0,0 density=0 viscosity=0 impratio=1 o_margin=0 o_solref o_solimp o_friction "
         "collision=all"},
    Kind{"mujoco", "statistic", Fate::read, "extent center", "meaninertia meanmass meansize", ""},
    Kind{"mujoco", "default", Fate::read, "class", "", ""},
    Kind{"mujoco", "asset", Fate::read, "", "", ""},
    Kind{"mujoco", "worldbody", Fate::read, "", "", ""},
    Kind{"mujoco", "contact", Fate::read, "", "", ""},
    Kind{"mujoco", "equality", Fate::read, "", "", ""},
    Kind{"mujoco", "tendon", Fate::read, "", "", ""},
    Kind{"mujoco", "actuator", Fate::read, "", "", ""},
    Kind{"mujoco", "keyframe", Fate::read, "", "", ""},
    Kind{"mujoco", "deformable", Fate::lacking, "", "", ""},
    Kind{"mujoco", "extension", Fate::lacking, "", "", ""},
    Kind{"mujoco", "sensor", Fate::unseen, "", "", ""},
    Kind{"mujoco", "visual", Fate::unseen, "", "", ""},
    Kind{"mujoco", "custom", Fate::unseen, "", "", ""},
    Kind{"mujoco", "size", Fate::silent, "", "", ""},

    Kind{"compiler", "lengthrange", Fate::silent, "", "", ""},
    Kind{"option", "flag", Fate::read, "contact gravity actuation",
         "warmstart refsafe sensor midphase nativeccd eulerdamp autoreset "
         "island energy fwdinv invdiscrete sensornoise multiccd sleep",
         "constraint=enable equality=enable frictionloss=enable limit=enable passive=enable "
         "spring=enable damper=enable filterparent=enable override=disable "
         "clampctrl=enable"},

    Kind{"default", "default", Fate::read, "class", "", ""},
    Kind{"default", "mesh", Fate::read, "scale", "maxhullvert", "inertia=convex"},
    Kind{"default", "material", Fate::read, "rgba",
         "texture emission specular shininess reflectance metallic roughness texrepeat texuniform",
         ""},
    Kind{"default", "joint", Fate::read,
         "type pos axis limited range ref springref stiffness damping frictionloss "
         "armature",
         "group user actuatorfrclimited actuatorgravcomp",
         "springdamper=0,0 solreflimit solimplimit solreffriction solimpfriction margin=0 actuatorfrcrange"},
    Kind{"default", "geom", Fate::read,
         "type size fromto pos quat axisangle xyaxes zaxis euler contype conaffinity condim friction "
         "priority mass density rgba material mesh hfield "
         "group",
         "user",
         "shellinertia=false solmix=1 solref solimp margin=0 gap=0 fitscale=1 "
         "fluidshape=none fluidcoef"},
    Kind{"default", "equality", Fate::read, "active", "", "solref solimp"},
    Kind{"default", "site", Fate::silent, "", "", ""},
    Kind{"default", "camera", Fate::silent, "", "", ""},
    Kind{"default", "light", Fate::silent, "", "", ""},
    Kind{"default", "pair", Fate::silent, "", "", ""},
    Kind{"default", "tendon", Fate::silent, "", "", ""},
    Kind{"default", "general", Fate::silent, "", "", ""},
    Kind{"default", "motor", Fate::silent, "", "", ""},
    Kind{"default", "position", Fate::silent, "", "", ""},
    Kind{"default", "velocity", Fate::silent, "", "", ""},
    Kind{"default", "intvelocity", Fate::silent, "", "", ""},
    Kind{"default", "damper", Fate::silent, "", "", ""},
    Kind{"default", "cylinder", Fate::silent, "", "", ""},
    Kind{"default", "muscle", Fate::silent, "", "", ""},
    Kind{"default", "adhesion", Fate::silent, "", "", ""},

    Kind{"asset", "mesh", Fate::read, "name class file vertex face scale refpos refquat",
         "normal texcoord smoothnormal content_type maxhullvert material",
         "inertia=convex builtin=none params"},
    Kind{"asset", "material", Fate::read, "name class rgba",
         "texture emission specular shininess reflectance metallic roughness texrepeat texuniform",
         ""},
    Kind{"asset", "texture", Fate::unseen, "", "", ""},
    Kind{"asset", "skin", Fate::unseen, "", "", ""},
    Kind{"asset", "hfield", Fate::silent, "", "", ""},
    Kind{"asset", "model", Fate::lacking, "", "", ""},
    Kind{"mesh", "plugin", Fate::lacking, "", "", ""},
    Kind{"material", "layer", Fate::silent, "", "", ""},

    Kind{"*", "body", Fate::read, "name childclass mocap pos quat axisangle xyaxes zaxis euler",
         "user sleep", "gravcomp=0"},
    Kind{"*", "frame", Fate::read, "name childclass pos quat axisangle xyaxes zaxis euler", "", ""},
    Kind{"body", "inertial", Fate::read,
         "mass diaginertia fullinertia pos quat axisangle xyaxes zaxis euler", "", ""},
    Kind{"body", "joint", Fate::read,
         "name class type pos axis limited range ref springref stiffness damping frictionloss "
         "armature",
         "group user actuatorfrclimited actuatorgravcomp",
         "springdamper=0,0 solreflimit solimplimit solreffriction solimpfriction margin=0 actuatorfrcrange"},
    Kind{"body", "freejoint", Fate::read, "name", "group align", ""},
    Kind{"*", "geom", Fate::read,
         "name class type size fromto pos quat axisangle xyaxes zaxis euler contype conaffinity "
         "condim friction priority mass density rgba material mesh hfield "
         "group",
         "user",
         "shellinertia=false solmix=1 solref solimp margin=0 gap=0 fitscale=1 "
         "fluidshape=none fluidcoef"},
    Kind{"*", "site", Fate::silent, "", "", ""},
    Kind{"*", "camera", Fate::unseen, "", "", ""},
    Kind{"*", "light", Fate::unseen, "", "", ""},
    Kind{"*", "composite", Fate::lacking, "", "", ""},
    Kind{"*", "flexcomp", Fate::lacking, "", "", ""},
    Kind{"*", "replicate", Fate::lacking, "", "", ""},
    Kind{"*", "attach", Fate::lacking, "", "", ""},
    Kind{"*", "plugin", Fate::lacking, "", "", ""},
    Kind{"geom", "plugin", Fate::lacking, "", "", ""},

    Kind{"tendon", "spatial", Fate::read,
         "name class limited range stiffness damping springlength frictionloss armature",
         "group user width rgba material actuatorfrclimited",
         "margin=0 solreflimit solimplimit solreffriction solimpfriction actuatorfrcrange"},
    Kind{"tendon", "fixed", Fate::read,
         "name class limited range stiffness damping springlength frictionloss armature",
         "group user actuatorfrclimited",
         "margin=0 solreflimit solimplimit solreffriction solimpfriction actuatorfrcrange"},
    Kind{"fixed", "joint", Fate::read, "joint coef", "", ""},
    Kind{"spatial", "site", Fate::read, "site", "", ""},
    Kind{"spatial", "geom", Fate::silent, "", "", ""},
    Kind{"spatial", "pulley", Fate::silent, "", "", ""},

    Kind{"actuator", "general", Fate::read,
         "name class joint jointinparent tendon gear ctrllimited ctrlrange forcelimited "
         "forcerange gaintype biastype dyntype gainprm biasprm",
         "dynprm actlimited actrange actearly group user lengthrange refsite slidersite cranklength",
         "site body cranksite delay=0"},
    Kind{"actuator", "motor", Fate::read,
         "name class joint jointinparent tendon gear ctrllimited ctrlrange forcelimited "
         "forcerange", "group user lengthrange refsite slidersite cranklength",
         "site body cranksite delay=0"},
    Kind{"actuator", "position", Fate::read,
         "name class joint jointinparent tendon gear ctrllimited ctrlrange forcelimited "
         "forcerange kp kv", "group user lengthrange refsite slidersite cranklength",
         "dampratio=0 timeconst=0 inheritrange=0 site cranksite delay=0"},
    Kind{"actuator", "velocity", Fate::read,
         "name class joint jointinparent tendon gear ctrllimited ctrlrange forcelimited "
         "forcerange kv", "group user lengthrange refsite slidersite cranklength",
         "site body cranksite delay=0"},
    Kind{"actuator", "damper", Fate::read,
         "name class joint jointinparent tendon gear ctrllimited ctrlrange forcelimited "
         "forcerange kv", "group user lengthrange refsite slidersite cranklength",
         "site body cranksite delay=0"},
    Kind{"actuator", "intvelocity", Fate::lacking, "", "", ""},
    Kind{"actuator", "cylinder", Fate::lacking, "", "", ""},
    Kind{"actuator", "muscle", Fate::lacking, "", "", ""},
    Kind{"actuator", "adhesion", Fate::lacking, "", "", ""},
    Kind{"actuator", "plugin", Fate::lacking, "", "", ""},
    Kind{"keyframe", "key", Fate::read, "name ctrl", "time",
         "qpos qvel act mpos mquat"},

    Kind{"contact", "pair", Fate::lacking, "", "", ""},
    Kind{"contact", "exclude", Fate::read, "name body1 body2", "", ""},

    Kind{"equality", "connect", Fate::read, "name class body1 body2 anchor active", "",
         "solref solimp site1 site2"},
    Kind{"equality", "weld", Fate::read, "name class body1 body2 active", "anchor",
         "relpose=0,1,0,0,0,0,0 torquescale=1 solref solimp site1 site2"},
    Kind{"equality", "joint", Fate::lacking, "", "", ""},
    Kind{"equality", "tendon", Fate::lacking, "", "", ""},
    Kind{"equality", "distance", Fate::lacking, "", "", ""},
    Kind{"equality", "flex", Fate::lacking, "", "", ""},
    Kind{"equality", "flexvert", Fate::lacking, "", "", ""},
    Kind{"equality", "flexstrain", Fate::lacking, "", "", ""},
};
// clang-format on

std::vector<std::string> wordsOf(std::string_view list) {
    std::vector<std::string> words;
    while (!list.empty()) {
        const std::size_t end = std::min(list.find(' '), list.size());
        if (end > 0) words.emplace_back(list.substr(0, end));
        list.remove_prefix(std::min(end + 1, list.size()));
    }
    return words;
}

bool isIn(std::string_view list, std::string_view name) {
    for (const std::string& word : wordsOf(list))
        if (word == name) return true;
    return false;
}

/// Everything that may hold geoms and joints.
bool holdsBodies(std::string_view element) {
    return element == "worldbody" || element == "body" || element == "frame";
}

bool mayStandIn(const Kind& kind, std::string_view around) {
    return kind.in == "*" ? holdsBodies(around) : kind.in == around;
}

const Kind* kindOf(std::string_view around, std::string_view name) {
    for (const Kind& kind : kKinds)
        if (kind.name == name && mayStandIn(kind, around)) return &kind;
    return nullptr;
}

/// Whether "0 0.0", as written, and "0,0" are the same numbers, or both the same word.
bool saysTheSame(std::string_view written, std::string_view neutral) {
    const auto next = [](std::string_view& text, std::string_view gaps) {
        text.remove_prefix(std::min(text.find_first_not_of(gaps), text.size()));
        const std::string_view piece = text.substr(0, text.find_first_of(gaps));
        text.remove_prefix(piece.size());
        return piece;
    };
    const auto valueOf = [](std::string_view piece, double& value) {
        const char* end = piece.data() + piece.size();
        const std::from_chars_result read = std::from_chars(piece.data(), end, value);
        return read.ec == std::errc() && read.ptr == end;
    };
    while (true) {
        const std::string_view a = next(written, " \t\r\n"), b = next(neutral, ",");
        if (a.empty() || b.empty()) return a.empty() && b.empty();
        double x = 0.0, y = 0.0;
        const bool numbers = valueOf(a, x) && valueOf(b, y);
        if (numbers ? x != y : a != b) return false;
    }
}

class WordCheck {
public:
    explicit WordCheck(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

    void element(const Element& element, const Kind& kind) {
        for (const Attribute& attribute : element.attributes) check(attribute, element, kind);
        for (const Element& child : element.children) {
            const Kind* inner = kindOf(element.name, child.name);
            if (!inner)
                unknown(child, element);
            else
                inside(child, *inner, element);
        }
    }

private:
    void inside(const Element& child, const Kind& kind, const Element& around) {
        const bool empty = child.children.empty() && child.attributes.empty();
        switch (kind.fate) {
            case Fate::read:
                return element(child, kind);
            case Fate::silent:
                return;
            case Fate::unseen:
                return diagnostics_.unseen(child.spot, child.name);
            case Fate::lacking:
                if (!empty)
                    diagnostics_.note(
                        child.spot,
                        "<" + child.name + ">" +
                            (around.name == "mujoco" ? "" : " in <" + around.name + ">") +
                            " is not supported; left out");
        }
    }

    void unknown(const Element& child, const Element& around) {
        std::vector<std::string> names;
        for (const Kind& kind : kKinds)
            if (mayStandIn(kind, around.name)) names.emplace_back(kind.name);
        diagnostics_.wrong(child.spot, "there is no <" + child.name.substr(0, 64) + "> in <" +
                                           around.name + ">" + suggestion(child.name, names));
    }

    void check(const Attribute& attribute, const Element& element, const Kind& kind) {
        const std::string& name = attribute.name;
        if (isIn(kind.read, name) || isIn(kind.silent, name)) return;
        std::vector<std::string> known = wordsOf(kind.read);
        for (const std::string& word : wordsOf(kind.silent)) known.push_back(word);
        for (const std::string& word : wordsOf(kind.lacking)) {
            const std::size_t equals = std::min(word.find('='), word.size());
            known.push_back(word.substr(0, equals));
            if (known.back() != name) continue;
            const bool changes =
                equals == word.size() || !saysTheSame(attribute.value, word.substr(equals + 1));
            if (changes)
                diagnostics_.note(attribute.spot,
                                  "<" + element.name + " " + name + "> is not supported; left out");
            return;
        }
        diagnostics_.wrong(attribute.spot, "unknown attribute '" + name.substr(0, 64) + "' of <" +
                                               element.name + ">" + suggestion(name, known));
    }

    Diagnostics& diagnostics_;
};

}  // namespace

void checkWords(const Element& root, Diagnostics& diagnostics) {
    if (root.name != "mujoco")
        return diagnostics.wrong(root.spot, "the root element is <" + root.name.substr(0, 64) +
                                                ">; it should be <mujoco>");
    WordCheck(diagnostics).element(root, kKinds[0]);
}

}  // namespace demos::mjcf
