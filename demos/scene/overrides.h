/// --set world.hz=240: changes to a scene before it is read.
#pragma once
#include <deque>
#include <string>
#include <vector>

#include "demos/scene/key_path.h"
#include "demos/scene/repeat.h"
#include "demos/scene/toml_value.h"

namespace demos {

/// body.box[3].mass=5: a change to one of the bodies, joints or forces whose names begin with
/// `box`, in the order of the scene. It has to wait until the [[repeat]]s are unrolled.
struct ItemOverride {
    std::string list;  // body, joint or force
    IndexedPart item;
    std::vector<std::string> path;  // of the key in its table
    std::string value;
    Place place;
};

/// Puts `dotted.key=value` into the document as if it were written in the file. A table in a list
/// is addressed by its number or its name: `body.3.mass=5`, `body[3].mass=5`, `body.ball.mass=5`; a
/// [[repeat]] also by the name of what it repeats: `repeat.box{i}.count=5`. A part in quotes may
/// contain dots. Returns those that have to wait.
[[nodiscard]] std::vector<ItemOverride> applyOverrides(const std::vector<std::string>& overrides,
                                                       Value& document, Complaints& complaints);

/// Gives the items that are meant tables of their own, in `own`, with the change.
void applyToItems(const std::vector<ItemOverride>& overrides, Instances& instances,
                  std::deque<Value>& own, Complaints& complaints);

}  // namespace demos
