/// What commands share of the command line, as plain values: the scene, its picture, where that
/// goes. What one command alone takes stands beside it, in a struct made from this one.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "demos/look/paper.h"

namespace demos {

struct Options {
    std::vector<std::string> scenes;     // built-in names or paths
    std::vector<std::string> overrides;  // "world.hz=240"
    std::optional<double> seconds;       // length

    std::string quality = "medium";
    std::optional<PictureSize> size;
    std::optional<int> fps;
    std::optional<int> samples;
    std::optional<int> blur;        // moments a frame is the mean of
    std::optional<double> shutter;  // open for so much of a frame, 0..1
    std::vector<std::string> show;  // overlays, added to the scene's
    std::string theme;              // empty = the scene's
    std::string colorBy;            // empty = the scene's
    bool clean = false;             // no text
    bool reproducible = false;
    std::string context = "auto";  // of OpenGL: auto, osmesa, egl
    bool anyStep = false;          // pictures of steps, whether or not a film has frames there
    bool plotBelow = true;         // where the scene asks for a plot with a cursor

    std::vector<std::string> outputs;  // patterns; empty = the default
    bool overwrite = false;
    int jobs = 0;  // 0 = a worker per core

    std::optional<double> width;  // mm on paper: a figure
    int dpi = 300;                // pixels an inch, with a width
    std::string caption;          // a file; empty = beside the figure where that has a width

    bool quiet = false, json = false;
    std::string commandLine;  // as a shell takes it, to resume after an interruption

    const std::string& scene() const { return scenes.front(); }
};

}  // namespace demos
