#include "demos/play/expect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "demos/scene/pattern.h"
#include "demos/text/complaints.h"
#include "engine/base/trigonometry.h"

namespace demos {
namespace {

using What = Expectation::What;

constexpr double kMoved = 0.5;  // m: count
constexpr double kClearly = 0.01;  // of a swing's width: from farther below, a passage of its middle counts

struct KindText {
    const char *name, *unit;
    const char* which = "";  // of the values in its window
};
KindText textOf(What what) {
    switch (what) {
        case What::drift:
            return {"drift", "m", "largest "};
        case What::penetration:
            return {"penetration", "m", "deepest "};
        case What::separation:
            return {"separation", "m", "largest "};
        case What::energy:
            return {"energy change", "", "largest "};
        case What::speed:
            return {"speed", "m/s", "largest "};
        case What::position:
            return {"distance", "m"};
        case What::angle:
            return {"angle", "deg", "largest "};
        case What::period:
            return {"period", "s"};
        case What::count:
            return {"count of moved bodies", ""};
        case What::height:
            return {"height", "m", "least "};
        case What::spread:
            return {"spread", "m"};
    }
    return {"", ""};
}

/// Whether it is measured only when the window closes.
bool atClosing(What what) { return what == What::position || what == What::spread; }

bool ofWorld(What what) { return what == What::penetration || what == What::energy; }

std::vector<int> chosen(const Expectation& e, const SceneDescription& scene) {
    std::vector<int> numbers;
    if (e.what == What::separation) {
        for (int i = 0; i < static_cast<int>(scene.joints.size()); ++i)
            if (matchesAny(e.of, scene.joints[i].name)) numbers.push_back(i);
        return numbers;
    }
    for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i)
        if (matchesAny(e.of, scene.bodies[i].name) &&
            scene.bodies[i].def.kind == engine::BodyKind::dynamic)
            numbers.push_back(i);
    return numbers;
}

double tiltDegrees(const engine::Pose& pose, const Vec3& up) {
    const Vec3 axis = pose.rotation * Vec3(0, 1, 0);
    return engine::arctangent(axis.cross(up).norm(), axis.dot(up)) * (180.0 / engine::kPi);
}

std::string withUnit(const std::string& number, const std::string& unit) {
    return number + (unit.empty() ? "" : " " + unit);
}

/// Writes numbers exactly, to the last digit.
QuantityWriter exactWriter() {
    return {[](double x, const std::string& unit) { return withUnit(numberText(x), unit); },
            [](const Vec3& p, const std::string& unit) {
                return withUnit("(" + numberText(p.x()) + ", " + numberText(p.y()) + ", " +
                                    numberText(p.z()) + ")",
                                unit);
            }};
}

std::string boundText(const Expectation& e, const std::string& unit, const QuantityWriter& write) {
    const auto with = [&](double x) { return write.number(x, unit); };
    if (e.nearPoint) return "from " + write.point(*e.nearPoint, "") + " within " + with(e.within);
    if (e.near) return "near " + with(*e.near) + " within " + with(e.within);
    std::string text;
    if (e.above) text += "above " + with(*e.above);
    if (e.below) text += (text.empty() ? "below " : " and below ") + with(*e.below);
    return text;
}

std::string windowText(const Expectation& e, double until, const QuantityWriter& write) {
    if (atClosing(e.what)) return ", at " + write.number(until, "s");
    return ", " + write.number(e.after, "s") + " to " + write.number(until, "s");
}

/// The texts of a result, without its value.
ExpectationResult describe(const Expectation& e, double seconds) {
    const KindText kind = textOf(e.what);
    ExpectationResult result;
    result.what = kind.name;
    if (!ofWorld(e.what)) result.of = e.of == "*" ? "all" : e.of;
    result.asked = askedText(e, seconds, exactWriter());
    result.text = kind.which + result.what + (result.of.empty() ? "" : " of " + result.of);
    result.text += (result.asked.starts_with(',') ? "" : " ") + result.asked;
    result.unit = kind.unit;
    result.why = e.why;
    return result;
}

/// By how much the value exceeds the bound; at most 0 if it is within.
double excess(const Expectation& e, double value) {
    if (e.nearPoint) return value - e.within;
    if (e.near) return std::abs(value - *e.near) - e.within;
    double worst = -1e300;
    if (e.below) worst = std::max(worst, value - *e.below);
    if (e.above) worst = std::max(worst, *e.above - value);
    return worst;
}

bool passes(const Expectation& e, double value) {
    if (!std::isfinite(value)) return false;
    if (e.near || e.nearPoint) return excess(e, value) <= 0.0;
    return (!e.below || value < *e.below) && (!e.above || value > *e.above);
}

}  // namespace

std::string askedText(const Expectation& e, double seconds, const QuantityWriter& write) {
    return boundText(e, textOf(e.what).unit, write) +
           windowText(e, e.until.value_or(seconds), write);
}

ExpectationChecker::ExpectationChecker(const Stage& stage) : halfStep_(0.5 * stage.dt()) {
    const Vec3& gravity = stage.world.gravity();
    if (gravity.norm() > 0.0) up_ = -gravity.normalized();
    for (const engine::BodyId id : stage.bodies) start_.push_back(stage.world.pose(id).position);
    for (const BodyDescription& body : stage.scene.bodies) bodies_.push_back(body.name);
    for (const JointDescription& joint : stage.scene.joints) joints_.push_back(joint.name);
    startEnergy_ = stage.world.energy().total();
    for (const Expectation& e : stage.scene.expectations) {
        Watch watch;
        watch.expectation = e;
        watch.until = e.until.value_or(stage.scene.seconds);
        if (ofWorld(e.what)) {
            watch.watched.emplace_back();
        } else {
            for (const int number : chosen(e, stage.scene))
                watch.watched.emplace_back().number = number;
        }
        watches_.push_back(std::move(watch));
    }
}

void ExpectationChecker::look(const Stage& stage) {
    const double time = stage.world.report().time;
    largestKinetic_ = std::max(largestKinetic_, stage.world.energy().kinetic);
    for (Watch& watch : watches_) {
        watch.finished = watch.finished || time >= watch.until - halfStep_;
        if (!isOpen(watch, time)) continue;
        watch.measured = true;
        for (Watched& watched : watch.watched) measure(stage, watch, watched);
    }
}

bool ExpectationChecker::isOpen(const Watch& watch, double time) const {
    // A position also needs the step after the closing, to interpolate.
    const double late = watch.expectation.what == What::position ? 2.0 * halfStep_ : halfStep_;
    return time >= watch.expectation.after - halfStep_ && time <= watch.until + late;
}

/// The place of a body at `until`, interpolated between the steps before and after it.
Vec3 ExpectationChecker::placeAtClosing(const Watch& watch, Watched& w, double time,
                                        const Vec3& place) {
    Vec3 closing = place;
    if (w.lookedAt && time > watch.until && *w.lookedAt <= watch.until)
        closing = w.place + (watch.until - *w.lookedAt) / (time - *w.lookedAt) * (place - w.place);
    w.lookedAt = time;
    w.place = place;
    return closing;
}

void ExpectationChecker::measure(const Stage& stage, const Watch& watch, Watched& w) const {
    const Expectation& e = watch.expectation;
    const engine::World& world = stage.world;
    const double now = world.report().time;
    const auto most = [&](double value) {
        if (!w.lookedAt || value > w.value) w.value = value, w.time = now;
        w.lookedAt = now;
    };
    if (e.what == What::penetration) return most(world.errors().penetration);
    if (e.what == What::energy) return most(std::abs(world.energy().total() - startEnergy_));
    if (e.what == What::separation) {
        const engine::JointState joint = world.joint(stage.joints[w.number]);
        w.broken = joint.broken;
        return most(joint.separation);
    }
    const engine::BodyId id = stage.bodies[w.number];
    const engine::Pose& pose = world.pose(id);
    const Vec3 moved = pose.position - start_[w.number];
    switch (e.what) {
        case What::drift:
            return most(horizontalMove(stage, w.number));
        case What::speed:
            return most(world.velocity(id).norm());
        case What::angle:
            return most(tiltDegrees(pose, up_));
        case What::count:
            return most(moved.norm() > kMoved ? 1.0 : 0.0);
        case What::position:
            w.value = (placeAtClosing(watch, w, now, pose.position) - *e.nearPoint).norm();
            return;
        case What::height:
            if (const double height = pose.position.dot(up_); !w.lookedAt || height < w.value)
                w.value = height, w.time = now;
            w.lookedAt = now;
            return;
        case What::spread:
            w.value = pose.position.x();
            return;
        case What::period:
            w.swings.push_back({now, pose.position.x(), pose.position.z()});
            return;
        default:
            return;
    }
}

double ExpectationChecker::horizontalMove(const Stage& stage, int body) const {
    const Vec3 moved = stage.world.pose(stage.bodies[body]).position - start_[body];
    return (moved - up_ * moved.dot(up_)).norm();
}

std::optional<double> ExpectationChecker::period(const std::vector<Swing>& swings) {
    const auto ends = [&](double Swing::*along) {
        const auto [low, high] = std::ranges::minmax(swings, {}, along);
        return std::pair<double, double>(low.*along, high.*along);
    };
    if (swings.empty()) return {};
    const auto x = ends(&Swing::x), z = ends(&Swing::z);
    const bool alongX = x.second - x.first >= z.second - z.first;
    const auto [low, high] = alongX ? x : z;
    double first = 0.0, last = 0.0, before = 0.0;
    int passages = 0;  // upwards only: counting both directions would need the exact middle
    bool wasBelow = false;  // clearly: a start in the middle is not a passage, whatever its rounding
    for (std::size_t i = 0; i < swings.size(); ++i) {
        const double now = (alongX ? swings[i].x : swings[i].z) - 0.5 * (low + high);
        wasBelow = wasBelow || now < -kClearly * (high - low);
        if (wasBelow && now >= 0.0) {
            const double share = before / (before - now);  // of the step, until the middle
            last = swings[i - 1].time + share * (swings[i].time - swings[i - 1].time);
            if (passages++ == 0) first = last;
            wasBelow = false;
        }
        before = now;
    }
    if (passages < 2) return {};
    return (last - first) / (passages - 1);
}

double ExpectationChecker::valueOf(const Expectation& e, const Watched& w) const {
    if (e.what == What::period) return period(w.swings).value_or(0.0);
    // A share of the total energy would depend on where y is 0; kinetic energy does not.
    if (e.what == What::energy)
        return w.value == 0.0 ? 0.0 : w.value / std::max(largestKinetic_, 1e-12);
    return w.value;
}

double ExpectationChecker::spreadOf(const std::vector<Watched>& watched) {
    if (watched.empty()) return 0.0;
    double sum = 0.0, squares = 0.0;
    for (const Watched& w : watched) sum += w.value;
    const double mean = sum / static_cast<double>(watched.size());
    for (const Watched& w : watched) squares += (w.value - mean) * (w.value - mean);
    return std::sqrt(squares / static_cast<double>(watched.size()));
}

double ExpectationChecker::worstOf(const Watch& watch, const Watched*& worst) const {
    const Expectation& e = watch.expectation;
    if (e.what == What::spread) return spreadOf(watch.watched);
    double worstValue = 0.0, worstExcess = 0.0, sum = 0.0;
    for (const Watched& w : watch.watched) {
        const double value = valueOf(e, w);
        sum += value;
        const double beyond = excess(e, value);
        if (!worst || beyond > worstExcess) worst = &w, worstValue = value, worstExcess = beyond;
    }
    return e.what == What::count ? sum : worstValue;
}

std::string ExpectationChecker::worstText(const Watch& watch, const Watched* worst,
                                          double value) const {
    const Expectation& e = watch.expectation;
    if (!worst || e.what == What::spread) return {};
    const std::vector<std::string>& names = e.what == What::separation ? joints_ : bodies_;
    if (e.what == What::count) return countText(watch, value);
    const std::string name = worst->number >= 0 ? "'" + names[worst->number] + "'" : "";
    if (atClosing(e.what) || e.what == What::period) return name;
    return fmt::format("{}{}at {:.4g} s", name, name.empty() ? "" : " ", worst->time);
}

std::string ExpectationChecker::countText(const Watch& watch, double value) const {
    constexpr std::size_t kMost = 3;
    const Expectation& e = watch.expectation;
    const bool tooFew = (e.above && value <= *e.above) || (e.near && value < *e.near);
    std::vector<std::string> names;
    for (const Watched& w : watch.watched)
        if ((w.value == 0.0) == tooFew) names.push_back("'" + bodies_[w.number] + "'");
    const std::size_t more = names.size() - std::min(names.size(), kMost);
    names.resize(names.size() - more);
    return fmt::format("{}{} {}", fmt::join(names, ", "),
                       more > 0 ? fmt::format(" and {} more", more) : "",
                       tooFew ? "did not move" : "moved");
}

std::string cameOut(const ExpectationResult& result) {
    return fmt::format("{:.6g}{}{}{}", result.value, result.unit.empty() ? "" : " ", result.unit,
                       result.worst.empty() ? "" : " (" + result.worst + ")");
}

std::string failedLine(const std::vector<ExpectationResult>& results) {
    const ExpectationResult* first = nullptr;
    std::size_t failed = 0;
    for (const ExpectationResult& result : results) {
        if (result.passed || !result.finished) continue;
        if (failed++ == 0) first = &result;
    }
    if (failed == 0) return {};
    const std::string head =
        results.size() == 1 ? "the expectation failed"
                            : fmt::format("{} of {} expectations failed{}", failed, results.size(),
                                          failed > 1 ? ", the first" : "");
    return fmt::format("{}: {}: {}", head, first->text, cameOut(*first));
}

std::string ExpectationChecker::unmeasured(const Watch& watch) {
    const What what = watch.expectation.what;
    if (!watch.measured) return "never reached";
    if (watch.watched.empty()) return "nothing that moves";
    if (atClosing(what) && !watch.finished) return "the run ended before";
    if (std::ranges::any_of(watch.watched, &Watched::broken)) return "a joint broke";
    const auto hasNone = [](const Watched& w) { return !period(w.swings); };
    if (what == What::period && std::ranges::any_of(watch.watched, hasNone)) return "not one full swing";
    return {};
}

std::vector<ExpectationResult> ExpectationChecker::results() const {
    std::vector<ExpectationResult> list;
    for (const Watch& watch : watches_) {
        const Expectation& e = watch.expectation;
        ExpectationResult result = describe(e, watch.until);
        const std::string none = unmeasured(watch);
        if (!none.empty()) result.text += " (" + none + ")";
        const Watched* worst = nullptr;
        result.value = worstOf(watch, worst);
        result.finished = watch.finished;
        result.passed = none.empty() && passes(e, result.value);
        if (!result.passed && none.empty())
            result.worst = worstText(watch, worst, result.value);
        list.push_back(std::move(result));
    }
    return list;
}

}  // namespace demos
