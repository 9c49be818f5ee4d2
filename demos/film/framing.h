/// Fits a scene's camera to a picture's shape and to the texts on it.
#pragma once
#include "render/frame.h"

namespace demos {

/// Scenes are framed for pictures of 4:3 and wider: in a narrower one the camera sees more above
/// and below instead of less at the sides. A tall plate on the right (statistics) covers a large
/// part of a small wide picture: the camera then moves to the right, so that its subject stays
/// visible. Depends on which plates there are, not on their text, so that it does not move during a
/// film. width, height: pixels.
void fitCamera(int width, int height, render::Frame& frame);

}  // namespace demos
