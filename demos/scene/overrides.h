/// --set world.hz=240: changes to a scene before it is read.
#pragma once
#include <string>
#include <vector>

#include "demos/scene/toml_value.h"

namespace demos {

/// Puts `dotted.key=value` into the document as if it were written in the file. A table in a list
/// is addressed by its number or its name: `body.3.mass=5`, `body.ball.mass=5`; a [[repeat]] also
/// by the name of what it repeats: `repeat.box{i}.count=5`. A part in quotes may contain dots.
void applyOverrides(const std::vector<std::string>& overrides, Value& document,
                    Complaints& complaints);

}  // namespace demos
