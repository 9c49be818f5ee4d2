/// The camera at a given time: from its keys, the body it follows, its orbit or its move.
#pragma once
#include <optional>
#include <string>

#include "demos/scene/description.h"
#include "demos/snapshot/frame_parts.h"

namespace demos {

struct CameraView {
    Vec3 from, lookAt;  // m
    double fovDegrees;
};

/// The view by the keys alone; `time`: s. Up to the first key the camera moves from its own view at
/// 0 s; after the last key it stays.
CameraView viewAt(const CameraDescription& camera, double time);

/// The same with its orbit or its move over a film of `seconds` (s), without what it follows.
CameraView movedAt(const CameraDescription& camera, double time, double seconds);

/// The number of cuts so far: pictures with the same number belong to one shot.
int shotAt(const CameraDescription& camera, double time);

/// The position of the body's centre in m; nothing if no body has this name.
std::optional<Vec3> placeOf(const Stage& stage, const std::string& body);

/// Towards the key light, unit: the scene's own, else beside its camera.
render::Vec3 lightOf(const SceneDescription& scene);

/// The camera with what it follows, orbit or move, and lens.
render::Camera cameraOf(const Moment& moment);

}  // namespace demos
