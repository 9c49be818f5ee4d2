/// What `impulse compare` and `impulse sweep` share: runs of one scene, as a table, a film, a
/// figure.
#pragma once
#include <optional>
#include <string>

#include "demos/film/film_options.h"

namespace demos {

struct RunsOptions : FilmOptions {
    std::optional<double> time;  // s, of the figure
    std::string measure;         // to plot; empty = the command's choice
    std::string plot;            // a file; empty = none
    std::string parts;           // the folder of parts; empty = the command's choice
    bool merge = false;          // read the measures of all runs from parts
};

}  // namespace demos
