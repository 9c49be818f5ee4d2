/// The camera: a model at most states its centre and extent.
#pragma once
#include "demos/mjcf/compiler.h"

namespace demos::mjcf {

/// From <statistic>, or from the bounds of the moving bodies: a three-quarter view from a little
/// above.
CameraDescription readView(const Element& root, const Defaults& defaults,
                           const SceneDescription& scene);

}  // namespace demos::mjcf
