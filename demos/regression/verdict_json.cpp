#include "demos/regression/verdict_json.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "demos/text/complaints.h"
#include "demos/text/hex_text.h"
#include "demos/text/json_limits.h"
#include "demos/text/json_whole.h"
#include "demos/text/stop.h"
#include "demos/text/version.h"

namespace demos {
namespace {

using Json = nlohmann::ordered_json;
constexpr int kVerdictFormat = 1;

template <class Enum, std::size_t size>
Enum enumFrom(const std::string& name, const Enum (&all)[size]) {
    for (const Enum value : all)
        if (name == nameOf(value)) return value;
    throw std::invalid_argument("'" + name + "'");
}

constexpr SceneVerdict::State kStates[] = {
    SceneVerdict::State::passed, SceneVerdict::State::failed, SceneVerdict::State::added,
    SceneVerdict::State::updated, SceneVerdict::State::error};
constexpr PictureVerdict::Kind kPictures[] = {
    PictureVerdict::Kind::same, PictureVerdict::Kind::within, PictureVerdict::Kind::changed,
    PictureVerdict::Kind::added, PictureVerdict::Kind::broken};
constexpr PhysicsVerdict::Kind kPhysics[] = {
    PhysicsVerdict::Kind::unknown, PhysicsVerdict::Kind::same, PhysicsVerdict::Kind::bits,
    PhysicsVerdict::Kind::changed};

Json jsonOf(const PhysicsVerdict& physics) {
    return {{"kind", nameOf(physics.kind)},   {"first_bits", physics.firstBits},
            {"step", physics.step},           {"every", physics.every},
            {"body", physics.body},           {"field", physics.field},
            {"difference", physics.difference}, {"constraint", physics.constraint},
            {"before", physics.before},       {"after", physics.after},
            {"used", physics.used},           {"lines", physics.lines}};
}

PhysicsVerdict physicsFrom(const Json& json) {
    PhysicsVerdict physics;
    physics.kind = enumFrom(json.at("kind").get<std::string>(), kPhysics);
    wholeTo(json.at("first_bits"), physics.firstBits);
    wholeTo(json.at("step"), physics.step);
    wholeTo(json.at("every"), physics.every);
    json.at("body").get_to(physics.body);
    json.at("field").get_to(physics.field);
    json.at("difference").get_to(physics.difference);
    json.at("constraint").get_to(physics.constraint);
    json.at("before").get_to(physics.before);
    json.at("after").get_to(physics.after);
    json.at("used").get_to(physics.used);
    json.at("lines").get_to(physics.lines);
    return physics;
}

Json jsonOf(const render::Difference& difference) {
    return {{"differing", difference.differing},   {"largest", difference.largest},
            {"window", difference.worstWindow},    {"window_at", {difference.windowX, difference.windowY}},
            {"shift", difference.worstShift},      {"ssim", difference.worstSsim}};
}

render::Difference differenceFrom(const Json& json) {
    render::Difference difference;
    difference.sameSize = true;
    wholeTo(json.at("differing"), difference.differing);
    wholeTo(json.at("largest"), difference.largest);
    wholeTo(json.at("window"), difference.worstWindow);
    wholeTo(json.at("window_at").at(0), difference.windowX);
    wholeTo(json.at("window_at").at(1), difference.windowY);
    json.at("shift").get_to(difference.worstShift);
    json.at("ssim").get_to(difference.worstSsim);
    return difference;
}

Json jsonOf(const PictureVerdict& picture) {
    Json json{{"time", picture.time},
              {"kind", nameOf(picture.kind)},
              {"state", hexText(picture.state)},
              {"baseline_state", hexText(picture.baselineState)},
              {"baseline", picture.baseline},
              {"actual", picture.actual}};
    if (!picture.problem.empty()) json["problem"] = picture.problem;
    if (picture.difference.sameSize) json["difference"] = jsonOf(picture.difference);
    return json;
}

PictureVerdict pictureFrom(const Json& json) {
    PictureVerdict picture;
    json.at("time").get_to(picture.time);
    picture.kind = enumFrom(json.at("kind").get<std::string>(), kPictures);
    picture.state = fromHex(json.at("state").get<std::string>()).value();
    picture.baselineState = fromHex(json.at("baseline_state").get<std::string>()).value();
    json.at("baseline").get_to(picture.baseline);
    json.at("actual").get_to(picture.actual);
    picture.problem = json.value("problem", "");
    if (json.contains("difference")) picture.difference = differenceFrom(json["difference"]);
    return picture;
}

/// A value that was never measured is null in JSON.
Json jsonOf(const ExpectationResult& result) {
    return {{"text", result.text},
            {"value", std::isfinite(result.value) ? Json(result.value) : Json(nullptr)},
            {"unit", result.unit},
            {"passed", result.passed},
            {"worst", result.worst},
            {"why", result.why}};
}

ExpectationResult expectationFrom(const Json& json) {
    ExpectationResult result;
    json.at("text").get_to(result.text);
    result.value = json.at("value").is_null() ? std::nan("") : json["value"].get<double>();
    json.at("unit").get_to(result.unit);
    json.at("passed").get_to(result.passed);
    result.worst = json.value("worst", "");
    json.at("why").get_to(result.why);
    return result;
}

Json jsonOf(const Snapshot& snapshot) {
    return {{"size", {snapshot.width, snapshot.height}},
            {"tolerance",
             {{"position", snapshot.tolerance.position},
              {"angle_deg", snapshot.tolerance.angleDegrees},
              {"load", snapshot.tolerance.load},
              {"why", snapshot.tolerance.why}}},
            {"gate",
             {{"levels", snapshot.gate.levels},
              {"window", snapshot.gate.windowPixels},
              {"ssim", snapshot.gate.ssim},
              {"why", snapshot.gate.why}}}};
}

Snapshot snapshotFrom(const Json& json) {
    Snapshot snapshot;
    wholeTo(json.at("size").at(0), snapshot.width);
    wholeTo(json.at("size").at(1), snapshot.height);
    const Json& tolerance = json.at("tolerance");
    tolerance.at("position").get_to(snapshot.tolerance.position);
    tolerance.at("angle_deg").get_to(snapshot.tolerance.angleDegrees);
    tolerance.at("load").get_to(snapshot.tolerance.load);
    tolerance.at("why").get_to(snapshot.tolerance.why);
    const Json& gate = json.at("gate");
    wholeTo(gate.at("levels"), snapshot.gate.levels);
    wholeTo(gate.at("window"), snapshot.gate.windowPixels);
    gate.at("ssim").get_to(snapshot.gate.ssim);
    gate.at("why").get_to(snapshot.gate.why);
    return snapshot;
}

Json jsonOf(const TestPart& part) {
    return {{"shard", part.shard.name()},
            {"scenes", part.scenes},
            {"run", hexText(part.run)},
            {"program", part.program},
            {"settings", part.settings}};
}

TestPart partFrom(const Json& json) {
    TestPart part;
    part.shard = shardNamed(json.at("shard").get<std::string>()).value();
    wholeTo(json.at("scenes"), part.scenes);
    part.run = fromHex(json.at("run").get<std::string>()).value();
    json.at("program").get_to(part.program);
    json.at("settings").get_to(part.settings);
    return part;
}

}  // namespace

Json jsonOf(const SceneVerdict& scene) {
    Json json{{"name", scene.name},     {"scene", scene.scene},     {"title", scene.title},
              {"state", nameOf(scene.state)}, {"cached", scene.cached},
              {"folder", scene.folder}, {"snapshot", jsonOf(scene.snapshot)},
              {"physics", jsonOf(scene.physics)}};
    if (!scene.problem.empty()) json["problem"] = scene.problem;
    Json& expectations = json["expectations"] = Json::array();
    for (const ExpectationResult& result : scene.expectations)
        expectations.push_back(jsonOf(result));
    Json& pictures = json["pictures"] = Json::array();
    for (const PictureVerdict& picture : scene.pictures) pictures.push_back(jsonOf(picture));
    Json& settings = json["settings"] = Json::array();
    for (const SettingChange& change : scene.settings)
        settings.push_back(
            {{"key", change.key}, {"baseline", change.baseline}, {"actual", change.actual}});
    json["orphans"] = scene.orphans;
    return json;
}

SceneVerdict sceneVerdictFrom(const Json& json) {
    SceneVerdict scene;
    json.at("name").get_to(scene.name);
    json.at("scene").get_to(scene.scene);
    json.at("title").get_to(scene.title);
    scene.state = enumFrom(json.at("state").get<std::string>(), kStates);
    json.at("cached").get_to(scene.cached);
    json.at("folder").get_to(scene.folder);
    scene.snapshot = snapshotFrom(json.at("snapshot"));
    scene.physics = physicsFrom(json.at("physics"));
    scene.problem = json.value("problem", "");
    for (const Json& result : json.at("expectations"))
        scene.expectations.push_back(expectationFrom(result));
    for (const Json& picture : json.at("pictures")) scene.pictures.push_back(pictureFrom(picture));
    for (const Json& change : json.at("settings"))
        scene.settings.push_back({change.at("key").get<std::string>(),
                                  change.at("baseline").get<std::string>(),
                                  change.at("actual").get<std::string>()});
    json.at("orphans").get_to(scene.orphans);
    return scene;
}

std::string jsonOf(const TestVerdict& verdict) {
    Json json{{"format", kVerdictFormat},     {"impulse", kVersion},
              {"command", verdict.command},   {"baselines", verdict.baselines},
              {"renderer", verdict.renderer}, {"pixels", verdict.pixels}};
    if (verdict.part) json["part"] = jsonOf(*verdict.part);
    Json& counts = json["counts"];
    for (const SceneVerdict::State state : kStates) counts[nameOf(state)] = verdict.count(state);
    json["passed"] = verdict.passed();
    json["orphans"] = verdict.orphans;
    Json& scenes = json["scenes"] = Json::array();
    for (const SceneVerdict& scene : verdict.scenes) scenes.push_back(jsonOf(scene));
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

TestVerdict testVerdictFrom(const std::string& text, const std::string& name) try {
    checkJson(text, kReportJson);
    const Json json = Json::parse(text);
    if (const int format = wholeIn<int>(json.at("format")); format != kVerdictFormat)
        throw Stop(Exit::environment,
                   fmt::format("'{}' has format {}, but this program reads {}; run impulse test "
                               "again",
                               printable(name), format, kVerdictFormat));
    TestVerdict verdict;
    json.at("command").get_to(verdict.command);
    json.at("baselines").get_to(verdict.baselines);
    json.at("renderer").get_to(verdict.renderer);
    json.at("pixels").get_to(verdict.pixels);
    json.at("orphans").get_to(verdict.orphans);
    if (json.contains("part")) verdict.part = partFrom(json["part"]);
    for (const Json& scene : json.at("scenes")) verdict.scenes.push_back(sceneVerdictFrom(scene));
    return verdict;
} catch (const Stop&) {
    throw;
} catch (const std::exception&) {
    throw Stop(Exit::environment,
               fmt::format("'{}' is not a report of impulse test, or was edited; run impulse test "
                           "again",
                           printable(name)));
}

}  // namespace demos
