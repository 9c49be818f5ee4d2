/// The camera of a scene in a picture of a given shape, with what is written on it.
#pragma once
#include "render/frame.h"

namespace demos {

/// Scenes are framed for pictures of 4:3 and wider: in a narrower one the camera sees more above
/// and below instead of less at the sides. Beside a tall plate on the right (statistics), which
/// takes a large part of a small wide picture, the camera moves to the right, so that its subject
/// stays free. Depends on which plates there are, not on what they say: it does not move while a
/// film plays. width, height: pixels.
void fitCamera(int width, int height, render::Frame& frame);

}  // namespace demos
