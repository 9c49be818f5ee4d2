/// The words of MJCF: which elements and attributes exist, and which of them are supported. One
/// pass over a model reports all unknown and all unsupported words; the other readers then read
/// only the words that they support.
#pragma once
#include "demos/mjcf/xml_tree.h"

namespace demos::mjcf {

/// Errors: words that MJCF does not have. Notes: unsupported words that change the motion, unless
/// their values are the defaults. `root`: <mujoco>.
void checkWords(const Element& root, Diagnostics& diagnostics);

}  // namespace demos::mjcf
