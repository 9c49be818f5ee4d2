/// Where the camera stands: a model says of its pictures at most how large it is.
#pragma once
#include "demos/mjcf/compiler.h"

namespace demos::mjcf {

/// From <statistic>, or from the bounds of what moves: three quarters from the front, a little
/// above.
CameraDescription readView(const Element& root, const Defaults& defaults,
                           const SceneDescription& scene);

}  // namespace demos::mjcf
