/// Which scenes a gallery shows, and what its files are called.
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

/// `all` is every built-in scene, by group; so is an empty list. Files are not read yet. Throws Stop
/// (usage) where two have one name.
std::vector<GalleryChoice> chooseGallery(const std::vector<std::string>& words);

}  // namespace demos
