#include "demos/film/event_log.h"

#include <nlohmann/json.hpp>

namespace demos {
namespace {

using Json = nlohmann::ordered_json;

Json listOf(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

Json jsonOf(const engine::TouchEvent& event, const Stage& stage) {
    const bool begins = event.kind == engine::TouchEvent::Kind::begin;
    Json json;
    json["event"] = begins ? "begin" : "end";
    json["step"] = event.step;
    json["time"] = event.time;
    json["a"] = stage.nameOf(event.a);
    json["b"] = stage.nameOf(event.b);
    json["sensor"] = event.sensor;
    json["position"] = listOf(event.position);
    json["normal"] = listOf(event.normal);
    if (begins) json["speed"] = event.speed;
    json["impulse"] = event.impulse;
    return json;
}

}  // namespace

void EventLog::look(const Stage& stage) {
    if (steps_ > 0 && seen_++ % steps_ == 0) events_.clear();
    const auto touches = stage.world.touches();
    events_.insert(events_.end(), touches.begin(), touches.end());
}

/// A line each, so that a text tool finds them.
std::string eventsJson(const std::vector<engine::TouchEvent>& events, const Stage& stage) {
    std::string text = "[";
    for (const engine::TouchEvent& event : events) {
        text += &event == events.data() ? "\n " : ",\n ";
        text += jsonOf(event, stage).dump(-1, ' ', false, Json::error_handler_t::replace);
    }
    return text + (events.empty() ? "]" : "\n]");
}

}  // namespace demos
