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
    int samples;  // per pixel with an edge
    int moments;  // pictures averaged into one frame
    render::Finish finish;
};

const std::vector<std::string>& qualityNames();
/// `name`: one of qualityNames().
const Quality& qualityOf(const std::string& name);

}  // namespace demos
