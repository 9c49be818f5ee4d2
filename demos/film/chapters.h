/// A scene's sections as the chapters of its film.
#pragma once
#include <vector>

#include "demos/scene/description.h"
#include "render/encode/chapters.h"

namespace demos {

/// `chosen`: which frames of the scene the film has. A chapter has its section's name, else its
/// caption, else a number; what comes before the first section is a chapter with the scene's title.
/// None without sections.
std::vector<render::Chapter> chaptersOf(const SceneDescription& scene, int fps,
                                        const std::vector<bool>& chosen);

}  // namespace demos
