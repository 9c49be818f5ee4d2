#include "demos/regression/report_views.h"

#include <nlohmann/json.hpp>
#include <set>

#include "demos/snapshot/camera.h"
#include "demos/text/rounded.h"

namespace demos {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kViews = 60;  // straight segments: they look like an arc

/// Times in s: evenly spaced, and those of the keys, where the camera turns or cuts.
std::set<double> timesOf(const CameraDescription& camera, double end) {
    const bool turns = camera.orbitDegreesPerSecond != 0.0 || camera.move == CameraMove::push ||
                       camera.move == CameraMove::orbit;
    if (camera.keys.empty() && !turns) return {0.0};
    std::set<double> times;
    for (int i = 0; i <= kViews; ++i) times.insert(end * i / kViews);
    for (const CameraKey& key : camera.keys)
        if (key.at < end) times.insert(key.at);
    return times;
}

}  // namespace

Json viewsJson(const CameraDescription& camera, double end) {
    Json rows = Json::array();
    for (const double time : timesOf(camera, end)) {
        const CameraView view = movedAt(camera, time, end);
        Json row{rounded(time, 6), shotAt(camera, time)};
        for (const Vec3& place : {view.from, view.lookAt})
            for (const double metres : place) row.push_back(rounded(metres, 5));
        row.push_back(rounded(view.fovDegrees, 5));
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace demos
