#include "tests/benchmark/peer_report.h"

#include <cmath>
#include <numbers>

#include "tests/benchmark/peer_text.h"

namespace peers {

namespace {

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

/// A flat object. No string here needs escaping.
class JsonLine {
public:
    void add(const char* name, const std::string& value) { append(name, "\"" + value + "\""); }
    void add(const char* name, int value) { append(name, std::to_string(value)); }
    void add(const char* name, double value) {  // JSON has no infinity
        append(name, std::isfinite(value) ? text("%.6g", value) : "null");
    }
    std::string line() const { return "{" + members_ + "}"; }

private:
    void append(const char* name, const std::string& value) {
        members_ += text("%s\"%s\":", members_.empty() ? "" : ",", name) + value;
    }
    std::string members_;
};

void addRun(JsonLine& json, const Scene& scene, const Quality& q) {
    json.add("verdict", verdict(scene, q));
    json.add("quality_steps", q.steps);
    if (scene.shouldStand) json.add("fall_time", q.fallTime);
    json.add("gave_up_time", q.gaveUpTime);
    json.add("drift", q.drift.total);
    json.add("drift_horizontal", q.drift.horizontal);
    json.add("drift_vertical", q.drift.vertical);
    json.add("fastest", q.fastest);
    json.add("lost", q.lost);
    if (scene.ground) json.add("sunk", q.sunk);
    json.add("hash", text("%016llx", static_cast<unsigned long long>(q.hash)));
}

void addContacts(JsonLine& json, const Quality& q) {
    json.add("penetration_worst", q.worstPenetration);
    json.add("penetration_end", q.penetration.worst);
    json.add("penetration_end_mean", q.penetration.mean);
    json.add("points", q.points);
    json.add("points_most", q.mostPoints);
}

void addJoints(JsonLine& json, const Quality& q) {
    json.add("separation_worst", q.worstSeparation);
    json.add("separation_rms", q.rmsSeparation);
    json.add("separation_end", q.separation.worst);
    json.add("axis_degrees", degrees(q.worstAxisAngle));
}

void addConserved(JsonLine& json, const Scene& scene, const Quality& q) {
    if (scene.watchEnergy) {
        json.add("energy_low", q.energyLow);
        json.add("energy_high", q.energyHigh);
        json.add("energy_end", q.energyEnd);
    }
    if (scene.watchMomentum) {
        json.add("momentum_error", q.momentumError);
        json.add("momentum_degrees", degrees(q.momentumAngle));
    }
}

/// With joints in the scene, a step's time is not spent on contact points.
bool countsPoints(const Result& result) {
    return result.cost->points > 0.0 && result.scene.joints.empty();
}

void addCost(JsonLine& json, const Result& result) {
    const Cost& cost = *result.cost;
    json.add("cost_steps", cost.steps);
    json.add("cpu_first_ms", 1e3 * cost.first);
    json.add("cpu_last_ms", 1e3 * cost.last);
    json.add("wall_first_ms", 1e3 * cost.wallFirst);
    json.add("wall_last_ms", 1e3 * cost.wallLast);
    if (countsPoints(result)) json.add("ns_per_point", 1e9 * cost.perPoint());
}

}  // namespace

std::string json(const Result& result) {
    const Scene& scene = result.scene;
    JsonLine json;
    json.add("engine", engineName());
    json.add("scene", scene.name);
    json.add("preset", result.preset);
    json.add("threads", result.threads);
    json.add("bodies", static_cast<int>(scene.bodies.size()));
    json.add("joints", static_cast<int>(scene.joints.size()));
    json.add("steps", scene.stepCount());
    if (result.quality) {
        addRun(json, scene, *result.quality);
        if (scene.watchPenetration) addContacts(json, *result.quality);
        if (!scene.joints.empty()) addJoints(json, *result.quality);
        addConserved(json, scene, *result.quality);
    }
    if (result.cost) addCost(json, result);
    return json.line();
}

std::string tableLine(const Result& result) {
    std::string line = text("%-5s %-8s %-10s", result.scene.name.c_str(), engineName().c_str(),
                            result.preset.c_str());
    if (result.cost) {
        line += text(" %9.4f ms at first %9.4f ms at last", 1e3 * result.cost->first,
                     1e3 * result.cost->last);
        if (countsPoints(result)) line += text(" %6.0f ns/point", 1e9 * result.cost->perPoint());
    }
    if (result.quality) line += "  " + verdict(result.scene, *result.quality);
    return line;
}

}  // namespace peers
