/// Where the camera is at a time: its keys, the body that it follows, and its orbit.
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

/// By the keys alone; `time`: s. Before the first key it comes from the camera's own view at 0 s,
/// after the last it stays.
CameraView viewAt(const CameraDescription& camera, double time);

/// The same on its orbit, where it has one.
CameraView orbitAt(const CameraDescription& camera, double time);

/// The cuts so far: pictures of the same number are of one take.
int shotAt(const CameraDescription& camera, double time);

/// m: of the body's centre; none where no body is called so.
std::optional<Vec3> placeOf(const Stage& stage, const std::string& body);

/// With what it follows, its orbit and its lens.
render::Camera cameraOf(const Moment& moment);

}  // namespace demos
