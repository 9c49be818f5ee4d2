/// Checks whether a film file is complete, by its container only.
#pragma once
#include "render/encode/video_format.h"

namespace render {

/// True if the open `file` begins and ends as this kind of film does. The content is not decoded.
bool filmIsWhole(const VideoFormat& format, int file);

}  // namespace render
