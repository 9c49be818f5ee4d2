#include "demos/mjcf/compiler.h"

#include <cmath>

namespace demos::mjcf {
namespace {

constexpr int kFramesASecond = 60;  // hz should be a multiple of it, for films of 60 and 30 fps
constexpr int kLeastHz = 60, kMostHz = 99'960;

/// A step at most as long as MuJoCo's.
int hzFor(double timestep) {
    const double frames = std::ceil(std::round(1.0 / timestep) / kFramesASecond);
    return static_cast<int>(engine::clamped<double>(frames * kFramesASecond, kLeastHz, kMostHz));
}

bool isSequence(const std::string& text) {
    if (text.size() != 3) return false;
    const auto among = [&](std::string_view letters) {
        return text.find_first_not_of(letters) == std::string::npos;
    };
    return among("xyz") || among("XYZ");
}

void readCompiler(Attributes attributes, Rules& rules) {
    if (const auto angle = attributes.word("angle", {"degree", "radian"}))
        rules.angles.degrees = *angle == "degree";
    if (attributes.has("eulerseq")) {
        const std::string sequence = attributes.text("eulerseq");
        if (isSequence(sequence))
            rules.angles.eulerSequence = sequence;
        else
            attributes.wrong("eulerseq",
                             "eulerseq is '" + sequence.substr(0, 40) +
                                 "'; it should be three of x, y, z, or three of X, Y, Z");
    }
    if (attributes.text("coordinate") == "global")
        attributes.wrong("coordinate",
                         "coordinate is 'global', which MuJoCo no longer supports; "
                         "it should be 'local': MuJoCo 2.3.3 converts such models");
    else
        attributes.word("coordinate", {"local"});
    rules.autoLimits = attributes.truth("autolimits").value_or(rules.autoLimits);
    rules.inertiaFromGeom = attributes.word("inertiafromgeom", {"false", "true", "auto"})
                                .value_or(rules.inertiaFromGeom);
    for (const char* folder : {"assetdir", "meshdir"})
        if (attributes.has(folder)) rules.meshFolder = attributes.text(folder);
}

void readFlags(Attributes attributes, Rules& rules) {
    const std::vector<std::string> words{"enable", "disable"};
    if (const auto contact = attributes.word("contact", words))
        rules.contacts = *contact == "enable";
    if (const auto actuation = attributes.word("actuation", words))
        rules.actuation = *actuation == "enable";
    if (const auto gravity = attributes.word("gravity", words)) rules.weight = *gravity == "enable";
}

void readOption(Attributes attributes, SceneDescription& scene) {
    if (const auto gravity = attributes.vector("gravity", {-1e4, 1e4, "m/s^2"}))
        scene.gravity = yUp(*gravity);
    const std::optional<double> timestep = attributes.number("timestep", {1e-5, 1.0, "s"});
    if (!timestep) return;
    scene.hz = hzFor(*timestep);
    if (std::abs(scene.hz * *timestep - 1.0) > 1e-9)
        attributes.note("timestep", "timestep is " + numberText(*timestep) + " s; replaced by " +
                                        std::to_string(scene.hz) +
                                        " steps a second, a multiple of 60");
}

}  // namespace

Rules readRules(const Element& root, const Defaults& defaults, SceneDescription& scene,
                Diagnostics& diagnostics) {
    constexpr double kTimestep = 0.002;  // MuJoCo's own
    scene.hz = hzFor(kTimestep);
    Rules rules;
    for (const Element& element : root.children) {
        if (element.name == "compiler") readCompiler(defaults.of(element, ""), rules);
        if (element.name != "option") continue;
        readOption(defaults.of(element, ""), scene);
        for (const Element& flag : element.children)
            if (flag.name == "flag") readFlags({flag, {}, diagnostics}, rules);
    }
    if (!rules.weight) scene.gravity = Vec3::Zero();
    return rules;
}

}  // namespace demos::mjcf
