/// The path of a scene's camera during a report's film.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "demos/scene/description.h"

namespace demos {

/// Rows of the camera's keys and orbit from 0 to `end` (s), by time: time (s), cuts so far, from
/// (3 numbers, m), look_at (3 numbers, m), vertical field of view (deg). Between rows with the same
/// number of cuts the camera moves in a straight line; with a single row it stands still. The page
/// adds the motion of the followed body.
nlohmann::ordered_json viewsJson(const CameraDescription& camera, double end);

}  // namespace demos
