#include "demos/film/run_record.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "demos/film/film_plan.h"
#include "demos/text/hex_text.h"
#include "demos/text/json_limits.h"
#include "demos/text/json_whole.h"

namespace demos {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void RunRecord::addIncident(const std::string& line, int frame) {
    if (line.empty()) return;
    incidentFrame = incident.empty() ? frame : std::min(incidentFrame, frame);
    if (line.size() > incident.size()) incident = line;  // a later one counts more incidents
}

std::string RunRecord::incidentUntil(int frame) const {
    return frame >= incidentFrame ? incident : "";
}

std::string jsonOf(const RunRecord& record) {
    Json json;
    json["impulse"] = record.version;
    json["fingerprint"] = hexText(record.fingerprint);
    json["scene"] = record.scene;
    json["command"] = record.command;
    json["renderer"] = record.renderer;
    json["pixels"] = record.pixels;
    if (!record.ffmpeg.empty()) json["ffmpeg"] = record.ffmpeg;
    json["pattern"] = record.pattern;
    json["quality"] = record.quality;
    json["theme"] = record.theme;
    json["show"] = record.show;
    json["set"] = record.settings;
    json["size"] = {record.width, record.height};
    json["samples"] = record.samples;
    json["fps"] = record.fps;
    json["hz"] = record.hz;
    if (!record.passes.empty()) json["passes"] = record.passes;
    if (!record.shard.empty()) json["shard"] = record.shard, json["poster"] = record.poster;
    if (!record.shard.empty() && !record.captions.empty()) json["captions"] = record.captions;
    if (record.film != 0) json["film"] = hexText(record.film);
    for (const render::Chapter& chapter : record.chapters)
        json["chapters"].push_back(
            {{"first", chapter.first}, {"end", chapter.end}, {"name", chapter.name}});
    if (!record.incident.empty()) {
        json["incident"] = record.incident;
        json["incident_frame"] = record.incidentFrame;
    }
    json["finished"] = record.finished;
    Json& frames = json["frames"] = Json::array();
    for (const FrameRecord& frame : record.frames) {
        if (!frame.written) {
            frames.push_back(nullptr);
            continue;
        }
        frames.push_back({{"state", hexText(frame.state)}, {"png", hexText(frame.png)}});
        if (frame.data != 0) frames.back()["data"] = hexText(frame.data);
    }
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<RunRecord> recordFromJson(const std::string& text) try {
    checkJson(text, kRunJson);
    const Json json = Json::parse(text);
    RunRecord record;
    record.version = json.at("impulse").get<std::string>();
    record.fingerprint = fromHex(json.at("fingerprint").get<std::string>()).value();
    record.pattern = json.at("pattern").get<std::string>();
    record.finished = json.at("finished").get<bool>();
    record.scene = json.value("scene", "");
    record.command = json.value("command", "");
    record.renderer = json.value("renderer", "");
    record.pixels = json.value("pixels", "");
    record.quality = json.value("quality", "");
    record.theme = json.value("theme", "");
    record.show = json.value("show", std::vector<std::string>{});
    record.settings = json.value("set", std::vector<std::string>{});
    if (json.contains("size")) wholeTo(json["size"].at(0), record.width);
    if (json.contains("size")) wholeTo(json["size"].at(1), record.height);
    record.samples = wholeIn<int>(json.value("samples", Json(0)));
    record.fps = wholeIn<int>(json.value("fps", Json(0)));
    record.hz = wholeIn<int>(json.value("hz", Json(0)));
    record.shard = json.value("shard", "");
    record.poster = wholeIn<int>(json.value("poster", Json(0)));
    record.captions = json.value("captions", "");
    record.incident = json.value("incident", "");
    record.incidentFrame = wholeIn<int>(json.value("incident_frame", Json(0)));
    if (json.contains("film"))
        record.film = fromHex(json["film"].get<std::string>()).value();
    for (const Json& chapter : json.value("chapters", Json::array()))
        record.chapters.push_back({wholeIn<int>(chapter.at("first")), wholeIn<int>(chapter.at("end")),
                                   chapter.at("name").get<std::string>()});
    if (json.contains("passes")) record.passes = json["passes"].get<std::vector<std::string>>();
    const Json& frames = json.at("frames");
    if (!frames.is_array() || frames.size() > kMostFrames) return std::nullopt;
    for (const Json& frame : frames) {
        FrameRecord entry;
        if (!frame.is_null()) {
            entry.written = true;
            entry.state = fromHex(frame.at("state").get<std::string>()).value();
            entry.png = fromHex(frame.at("png").get<std::string>()).value();
            if (frame.contains("data"))
                entry.data = fromHex(frame["data"].get<std::string>()).value();
        }
        record.frames.push_back(entry);
    }
    return record;
} catch (const std::exception&) {
    return std::nullopt;
}

}  // namespace demos
