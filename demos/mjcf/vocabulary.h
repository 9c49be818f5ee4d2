/// The words of MJCF: which elements and attributes there are, and which of them are supported. One
/// pass over a model tells of all that is misspelt and of all that is left out; the readers beside
/// it then ask for what they know.
#pragma once
#include "demos/mjcf/xml_tree.h"

namespace demos::mjcf {

/// Errors: words that MJCF does not have. Notes: words that change the motion and are not
/// supported, unless they say what holds without them. `root`: <mujoco>.
void checkWords(const Element& root, Diagnostics& diagnostics);

}  // namespace demos::mjcf
