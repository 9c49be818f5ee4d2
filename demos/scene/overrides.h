/// --set world.hz=240: changes to a scene before it is read.
#pragma once
#include <string>
#include <vector>

#include "demos/scene/toml_value.h"

namespace demos {

/// `dotted.key=value`, put into the document as if the file had said so. A member of a list of
/// tables is called by its number or its name: `body.3.mass=5`, `body.ball.mass=5`; a [[repeat]] by
/// that of what it repeats as well: `repeat.box{i}.count=5`. A part in quotes may have dots.
void applyOverrides(const std::vector<std::string>& overrides, Value& document,
                    Complaints& complaints);

}  // namespace demos
