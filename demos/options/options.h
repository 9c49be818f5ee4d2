/// The options that commands share, as plain values: the scene, its picture, the output. Options of
/// a single command are in a struct derived from this one, next to the command or in the folder that
/// does its work.
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
    std::optional<int> blur;        // number of moments averaged for a frame
    std::optional<double> shutter;  // open for this share of a frame, 0..1
    std::vector<std::string> show;  // overlays, added to the scene's
    std::string theme;              // empty = the scene's
    std::string colorBy;            // empty = the scene's
    bool clean = false;             // no text
    bool reproducible = false;
    bool wholeFrames = false;  // keep nothing of the picture before
    std::string context = "auto";  // of OpenGL: auto, osmesa, egl
    bool anyStep = false;          // pictures of any step, also where a film has no frame
    bool plotBelow = true;         // if the scene requests a plot with a cursor

    std::vector<std::string> outputs;  // patterns; empty = the default
    bool overwrite = false;
    int jobs = 0;  // 0 = a worker per core

    std::optional<double> width;  // mm on paper: a figure
    int dpi = 300;                // pixels per inch, with a width
    std::string caption;          // a file; empty = next to the figure if it has a width

    bool quiet = false, json = false;
    std::string commandLine;  // quoted for a shell, to resume after an interruption

    const std::string& scene() const { return scenes.front(); }
};

}  // namespace demos
