/// The scenes of a gallery and the names of its files.
#pragma once
#include <string>
#include <vector>

#include "demos/options/options.h"

namespace demos {

struct GalleryChoice {
    std::string scene;  // as loadScene takes it
    std::string name;   // of its files; unique
    bool builtin = false;
};

/// `all`, or an empty list, is every built-in scene by group. Does not read files yet. Throws Stop
/// (usage) if two scenes have the same name.
std::vector<GalleryChoice> chooseGallery(const std::vector<std::string>& words);

}  // namespace demos
