#include "demos/film/data_pass.h"

#include <algorithm>

namespace demos {
namespace {

constexpr PassText kPasses[] = {
    {Pass::depth, "depth", ".pfm", "PFM: 32-bit floats, little-endian, bottom row first", "m",
     "distance of the surface at the pixel's centre along the view axis; inf: only sky"},
    {Pass::depth16, "depth16", ".png", "PNG: 16-bit grey", "depth_unit_m",
     "the same in units of depth_unit_m, rounded; 65534: at least that far; 65535: only sky"},
    {Pass::normal, "normal", ".png", "PNG: 16-bit RGB", "1",
     "unit normal in world axes, towards the viewer: n = value / 32767.5 - 1 for x, y, z; "
     "0 0 0: only sky"},
    {Pass::id, "id", ".png", "PNG: 16-bit grey", "1",
     "number of the body or joint seen at the pixel's centre, see ids; 0: only sky"},
    {Pass::flow, "flow", ".flo", "Middlebury .flo: 32-bit floats, little-endian, top row first",
     "pixels",
     "position in the next frame of the point at the pixel's centre, minus its position in this "
     "one, x right, y down, visible or hidden; the sky is infinitely far away; 1e10: unknown. The "
     "last frame's flow leads to the frame that would follow"},
    {Pass::camera, "camera", ".json", "JSON", "m, pixels",
     "view: world to eye axes (x right, y up, z towards the viewer); projection: eye axes to "
     "OpenGL's clip space; matrices are stored by rows and multiply column vectors. K: a point p "
     "= (x right, y down, z ahead of the eye) is seen at pixel (K p) / z; the centre of the top "
     "left pixel is (0.5, 0.5)"},
    {Pass::poses, "poses", ".json", "JSON", "m, m/s, rad/s",
     "of every body: position of the centre of mass, rotation from body to world axes as a "
     "quaternion w x y z, velocity, spin in world axes"},
    {Pass::contacts, "contacts", ".json", "JSON", "m, N s",
     "every touching point of every step since the previous frame: position half way between the "
     "surfaces, unit normal from a to b, penetration (negative: apart), impulse along the normal "
     "and friction on b over the step. event: begin: the pair of bodies did not touch in the "
     "previous step; persist: it did; end: it no longer touches. Touching: penetration >= 0, or an "
     "impulse > 0"},
    {Pass::events, "events", ".json", "JSON", "m, m/s, N s, N, N m",
     "begin and end of every contact since the previous frame, in the order of steps and pairs: "
     "position amid the touching points, unit normal from a to b; begin: the speed at which the "
     "two approached and the impulse of that step; end: the impulse since it began. sensor: one of "
     "the two is a sensor, which gets no impulse. break: a joint that exceeded its limits and was "
     "removed: position of its anchor on b, force (N) and torque (N m, about that anchor) on b, "
     "mean over that step"},
};

}  // namespace

std::span<const PassText> passTexts() { return kPasses; }

const PassText& textOf(Pass pass) {
    return *std::find_if(std::begin(kPasses), std::end(kPasses),
                         [pass](const PassText& text) { return text.pass == pass; });
}

std::vector<std::string> passNames() {
    std::vector<std::string> names;
    for (const PassText& text : kPasses) names.emplace_back(text.name);
    return names;
}

std::vector<std::string> passNamesOf(const std::vector<Pass>& passes) {
    std::vector<std::string> names;
    for (const Pass pass : passes) names.emplace_back(textOf(pass).name);
    return names;
}

std::vector<Pass> passesCalled(const std::vector<std::string>& names) {
    std::vector<Pass> passes;
    for (const PassText& text : kPasses)
        if (std::find(names.begin(), names.end(), text.name) != names.end())
            passes.push_back(text.pass);
    return passes;
}

}  // namespace demos
