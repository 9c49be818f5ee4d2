/// The presets of -q.
#pragma once
#include <string>
#include <vector>

#include "render/renderer.h"

namespace demos {

struct Quality {
    const char* name;
    int width, height;  // pixels
    int fps;
    int samples;  // of a pixel with an edge
    int moments;  // pictures that a frame is the mean of
    render::Finish finish;
};

const std::vector<std::string>& qualityNames();
/// One of qualityNames().
const Quality& qualityOf(const std::string& name);

}  // namespace demos
