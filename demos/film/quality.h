/// The presets of -q.
#pragma once
#include <string>
#include <vector>

namespace demos {

struct Quality {
    const char* name;
    int width, height;  // pixels
    int fps;
    int samples;  // a pixel
};

const std::vector<std::string>& qualityNames();
/// One of qualityNames().
const Quality& qualityOf(const std::string& name);

}  // namespace demos
