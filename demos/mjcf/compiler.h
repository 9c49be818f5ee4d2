/// <compiler> and <option>: how the rest of a model is to be read, and in what world it moves.
#pragma once
#include "demos/mjcf/axes.h"
#include "demos/mjcf/defaults.h"

namespace demos::mjcf {

struct Rules {
    AngleRules angles;
    bool autoLimits = true;                // a range is a limit, unless limited="false"
    std::string inertiaFromGeom = "auto";  // auto: where a body has no <inertial>
    std::string meshFolder;                // beside the model
    bool contacts = true;                  // <flag contact>
    bool weight = true;                    // <flag gravity>
    bool actuation = true;                 // <flag actuation>
};

/// Later <compiler>s and <option>s add to the earlier. Gravity and hz go to the scene.
Rules readRules(const Element& root, const Defaults& defaults, SceneDescription& scene,
                Diagnostics& diagnostics);

}  // namespace demos::mjcf
