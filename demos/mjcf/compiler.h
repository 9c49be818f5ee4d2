/// <compiler> and <option>: how the rest of a model is read, and the settings of its world.
#pragma once
#include "demos/mjcf/axes.h"
#include "demos/mjcf/defaults.h"

namespace demos::mjcf {

struct Rules {
    AngleRules angles;
    bool autoLimits = true;                // a range is a limit, unless limited="false"
    std::string inertiaFromGeom = "auto";  // auto: if a body has no <inertial>
    std::string meshFolder;                // relative to the model's folder
    bool contacts = true;                  // <flag contact>
    bool weight = true;                    // <flag gravity>
    bool actuation = true;                 // <flag actuation>
};

/// Later <compiler>s and <option>s add to earlier ones. Gravity and hz are set in the scene.
Rules readRules(const Element& root, const Defaults& defaults, SceneDescription& scene,
                Diagnostics& diagnostics);

}  // namespace demos::mjcf
