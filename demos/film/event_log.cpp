#include "demos/film/event_log.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "demos/film/json_list.h"

namespace demos {
namespace {

using Json = nlohmann::ordered_json;

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

Json jsonOf(const JointBreak& event, const Stage& stage) {
    const JointDescription& joint = stage.scene.joints[static_cast<std::size_t>(event.joint)];
    Json json;
    json["event"] = "break";
    json["step"] = event.step;
    json["time"] = event.time;
    json["joint"] = joint.name;
    const engine::JointState state = stage.world.joint(stage.joints[event.joint]);
    json["a"] = stage.nameOf(state.def.a);
    json["b"] = stage.nameOf(state.def.b);
    json["position"] = listOf(event.position);
    json["force"] = listOf(event.force);
    json["torque"] = listOf(event.torque);
    return json;
}

JointBreak breakOf(engine::JointId id, const Stage& stage) {
    const engine::JointState state = stage.world.joint(id);
    const engine::StepReport& report = stage.world.report();
    return {report.step, report.time, id.index, state.worldB, state.force, state.torque};
}

}  // namespace

void EventLog::look(const Stage& stage) {
    const auto touches = stage.world.touches();
    events_.touches.insert(events_.touches.end(), touches.begin(), touches.end());
    for (const engine::JointId id : stage.world.report().broken)
        events_.breaks.push_back(breakOf(id, stage));
}

/// One event per line, for text tools.
std::string eventsJson(const StageEvents& events, const Stage& stage) {
    std::string text = "[";
    const auto add = [&](const Json& json) {
        text += text.size() == 1 ? "\n " : ",\n ";
        text += json.dump(-1, ' ', false, Json::error_handler_t::replace);
    };
    std::size_t broken = 0;
    const auto addBreaksBefore = [&](long long step) {
        for (; broken < events.breaks.size() && events.breaks[broken].step < step; ++broken)
            add(jsonOf(events.breaks[broken], stage));
    };
    for (const engine::TouchEvent& event : events.touches) {
        addBreaksBefore(event.step);
        add(jsonOf(event, stage));
    }
    addBreaksBefore(std::numeric_limits<long long>::max());
    return text + (events.size() == 0 ? "]" : "\n]");
}

}  // namespace demos
