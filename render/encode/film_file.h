/// Whether a film file is complete, by its container alone.
#pragma once
#include "render/encode/video_format.h"

namespace render {

/// True when the open `file` begins as this kind of film does and ends where it says that it ends.
/// What is in between is not decoded.
bool filmIsWhole(const VideoFormat& format, int file);

}  // namespace render
