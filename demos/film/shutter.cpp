#include "demos/film/shutter.h"

#include <algorithm>
#include <cmath>

namespace demos {
namespace {

render::Vec3 mixed(const render::Vec3& a, const render::Vec3& b, float share) {
    return a + share * (b - a);
}

float mixed(float a, float b, float share) { return a + share * (b - a); }

}  // namespace

bool Shutter::sees(int stepsBefore) const {
    return stepsBefore < std::ceil(openSteps() - 1e-9) + 1;
}

std::vector<render::Frame> Shutter::moments(const std::vector<render::Frame>& seen) const {
    std::vector<render::Frame> result;
    const int newest = static_cast<int>(seen.size()) - 1;
    for (int i = 0; i < settings_.moments; ++i) {
        const double before = openSteps() * (settings_.moments - 1 - i) / settings_.moments;
        const double place = std::max(newest - before, 0.0);
        const int lower = std::min(static_cast<int>(place), newest);
        const int upper = std::min(lower + 1, newest);
        result.push_back(between(seen[lower], seen[upper], static_cast<float>(place - lower)));
    }
    return result;
}

render::Frame between(const render::Frame& a, const render::Frame& b, float share) {
    render::Frame frame = b;
    if (a.solids.size() == b.solids.size())
        for (std::size_t i = 0; i < b.solids.size(); ++i) {
            frame.solids[i].position = mixed(a.solids[i].position, b.solids[i].position, share);
            frame.solids[i].rotation = a.solids[i].rotation.slerp(share, b.solids[i].rotation);
        }
    if (a.rods.size() == b.rods.size())
        for (std::size_t i = 0; i < b.rods.size(); ++i) {
            frame.rods[i].from = mixed(a.rods[i].from, b.rods[i].from, share);
            frame.rods[i].to = mixed(a.rods[i].to, b.rods[i].to, share);
        }
    frame.camera.from = mixed(a.camera.from, b.camera.from, share);
    frame.camera.lookAt = mixed(a.camera.lookAt, b.camera.lookAt, share);
    frame.camera.fovDegrees = mixed(a.camera.fovDegrees, b.camera.fovDegrees, share);
    frame.camera.focus = mixed(a.camera.focus, b.camera.focus, share);
    return frame;
}

}  // namespace demos
