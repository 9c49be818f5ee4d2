/// Makes the frame of a picture from a stage.
#pragma once
#include "demos/look/overlays.h"
#include "demos/play/stage.h"
#include "demos/snapshot/history.h"
#include "render/frame.h"

namespace demos {

/// `frameTime`: s, for captions and the camera.
render::Frame snapshot(const Stage& stage, const Overlays& overlays, double frameTime,
                       const History& history = {});

}  // namespace demos
