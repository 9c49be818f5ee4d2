/// Light, background and ink of a picture, by the theme's name.
#pragma once
#include <string>
#include <vector>

#include "render/frame.h"
#include "render/palette.h"

namespace demos {

/// studio, dark, print, transparent, lab
const std::vector<std::string>& themeNames();

/// Sets the frame's look, and the ink of texts that do not define a colour.
void applyTheme(const std::string& theme, render::Frame& frame);

/// plastic, wood, brick ...; in the order of render::Material.
const std::vector<std::string>& materialNames();

inline render::Color nudgeColor() { return render::fromHex(0x7b3fb5); }

}  // namespace demos
