/// Where a scene's camera is while a report's film plays.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "demos/scene/description.h"

namespace demos {

/// Rows of its keys and its orbit from 0 to `end` (s), in the order of time: s, cuts so far, from
/// (3 m), look_at (3 m), vertical field of view (deg). Between rows of one take it goes straight
/// on; one row: it stays. What the camera follows is the page's to add.
nlohmann::ordered_json viewsJson(const CameraDescription& camera, double end);

}  // namespace demos
