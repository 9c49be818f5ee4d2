#include "demos/film/data_files.h"

#include <algorithm>
#include <cmath>

#include "demos/film/data_json.h"
#include "demos/text/stop.h"
#include "render/data_images.h"
#include "render/encode/float_files.h"
#include "render/encode/png16.h"

namespace demos {
namespace {

render::DataPasses imagesFor(const std::vector<Pass>& passes) {
    render::DataPasses images;
    for (const Pass pass : passes) {
        images.depth = images.depth || pass == Pass::depth || pass == Pass::depth16;
        images.normal = images.normal || pass == Pass::normal;
        images.id = images.id || pass == Pass::id;
        images.flow = images.flow || pass == Pass::flow;
    }
    return images;
}

std::vector<std::uint16_t> quantised(const std::vector<float>& depths, double unit) {
    constexpr double kFarthest = 65534.0;
    constexpr std::uint16_t kSky = 65535;
    std::vector<std::uint16_t> values;
    values.reserve(depths.size());
    for (const float depth : depths) {
        const double steps = std::round(static_cast<double>(depth) / unit);
        values.push_back(depth == render::kNoDepth
                             ? kSky
                             : static_cast<std::uint16_t>(std::clamp(steps, 0.0, kFarthest)));
    }
    return values;
}

/// n = value / 32767.5 - 1
std::vector<std::uint16_t> quantised(const std::vector<render::Vec3>& normals) {
    std::vector<std::uint16_t> values;
    values.reserve(3 * normals.size());
    for (const render::Vec3& n : normals) {
        const bool sky = n == render::Vec3(0, 0, 0);
        for (const float c : {n.x(), n.y(), n.z()}) {
            const double value = (static_cast<double>(c) + 1.0) * 32767.5;
            values.push_back(static_cast<std::uint16_t>(sky ? 0.0 : std::round(value)));
        }
    }
    return values;
}

Bytes bytesOf(const std::string& text) { return {text.begin(), text.end()}; }

bool isText(Pass pass) {
    return pass == Pass::camera || pass == Pass::poses || pass == Pass::contacts ||
           pass == Pass::events;
}

}  // namespace

DataFiles::DataFiles(const FilmPlan& plan, Composite& composite)
    : plan_(plan),
      composite_(composite),
      images_(imagesFor(plan.passes)),
      depthUnit_(depthUnitOf(plan.scene())) {
    watch();
}

void DataFiles::watch() {
    const auto isWanted = [this](Pass pass) {
        return std::find(plan_.passes.begin(), plan_.passes.end(), pass) != plan_.passes.end();
    };
    const bool contacts = isWanted(Pass::contacts), events = isWanted(Pass::events);
    if (!contacts && !events) return;
    if (events) composite_.watchTouches();
    composite_.watchSteps([this, contacts, events](const Stage& stage) {
        if (contacts) log_.look(stage);
        if (events) eventLog_.look(stage);
    });
}

void DataFiles::advance(bool drawn) {
    if (!ahead_) advanceOnce(drawn);
    ahead_ = false;
}

/// The logs keep the events of one frame.
void DataFiles::advanceOnce(bool drawn) {
    log_.clear(), eventLog_.clear();
    composite_.advance(drawn);
}

std::vector<Bytes> DataFiles::make(int frame, render::Renderer& renderer) {
    std::vector<Bytes> files(plan_.passes.size());
    if (files.empty()) return files;
    const render::Frame now = composite_.plainFrame(frame);
    for (std::size_t i = 0; i < files.size(); ++i)
        if (isText(plan_.passes[i])) files[i] = textOf(plan_.passes[i], frame, now.camera);
    if (!images_.any()) return files;
    const render::SurfaceMap map = renderer.surfaces(now);
    render::Frame next;
    if (images_.flow) ahead_ = goOn(frame + 1, next);
    const render::DataImages images =
        render::dataImages(now, ahead_ ? &next : nullptr, map, images_);
    for (std::size_t i = 0; i < files.size(); ++i)
        if (!isText(plan_.passes[i])) files[i] = imageOf(plan_.passes[i], images);
    return files;
}

/// False if the simulation diverges: the flow is then unknown, and drawing the next frame reports
/// why.
bool DataFiles::goOn(int frame, render::Frame& next) {
    try {
        advanceOnce(true);  // the next frame may be this worker's too
    } catch (const Stop&) {
        return false;
    }
    next = composite_.plainFrame(frame);
    return true;
}

Bytes DataFiles::textOf(Pass pass, int frame, const render::Camera& camera) const {
    if (pass == Pass::camera) return bytesOf(cameraJson(plan_, frame, camera));
    if (pass == Pass::poses) return bytesOf(posesJson(plan_, frame, composite_.stage()));
    if (pass == Pass::events)
        return bytesOf(eventsJson(plan_, frame, composite_.stage(), eventLog_.events()));
    return bytesOf(contactsJson(plan_, frame, composite_.stage(), log_.events()));
}

Bytes DataFiles::imageOf(Pass pass, const render::DataImages& images) const {
    const int width = images.width, height = images.height;
    if (pass == Pass::depth) return render::encodePfm(images.depth, width, height);
    if (pass == Pass::flow) return render::encodeFlo(images.flow, width, height);
    if (pass == Pass::id) return render::encodePng16(images.id, width, height, 1);
    if (pass == Pass::normal)
        return render::encodePng16(quantised(images.normal), width, height, 3);
    return render::encodePng16(quantised(images.depth, depthUnit_), width, height, 1);
}

}  // namespace demos
