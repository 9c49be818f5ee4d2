#include "demos/scene/read_freedom.h"

#include "demos/scene/ranges.h"
#include "engine/base/trigonometry.h"

namespace demos {
namespace {

engine::Spring readHzAndDamping(Keys& keys) {
    if (!keys.has("hz"))
        keys.complain("hz", "a spring has no frequency; write spring = { hz = 2, damping = 0.5 }");
    return {keys.number("hz", {1e-3, 1e3, "hz"}).value_or(1.0),
            keys.number("damping", {0.0, 100.0}).value_or(0.0)};
}

}  // namespace

std::optional<engine::Limits> readLimits(Keys& keys, const char* key, Way way) {
    const bool turns = way == Way::about;
    const auto numbers = keys.numbers(key, turns ? kDegrees : kMeters);
    if (!numbers) return std::nullopt;
    if (numbers->size() == 2 && (*numbers)[0] <= (*numbers)[1]) {
        const double low = (*numbers)[0], high = (*numbers)[1];
        return turns ? engine::Limits{engine::radians(low), engine::radians(high)}
                     : engine::Limits{low, high};
    }
    keys.complain(key, std::string(key) + " should be two numbers, the lower one first, like " +
                           (turns ? "[-45, 45] (deg)" : "[-0.5, 0.5] (m)"));
    return std::nullopt;
}

std::optional<engine::Motor> readMotor(Keys& keys, const char* key, Way way) {
    const Value* table = keys.any(key);
    if (!table) return std::nullopt;
    const bool turns = way == Way::about;
    Keys motor = keys.inner(*table, "a motor");
    if (!motor.has("speed"))
        motor.complain("speed", std::string("a motor has no speed; write motor = { speed = 2, "
                                            "max = 50 } in ") +
                                    (turns ? "rad/s and N m" : "m/s and N"));
    const double speed = motor.number("speed", {-1e4, 1e4, turns ? "rad/s" : "m/s"}).value_or(0.0);
    const std::optional<double> most = motor.number("max", {1e-9, 1e12, turns ? "N m" : "N"});
    motor.done();
    return engine::Motor{speed, most.value_or(engine::kUnlimited)};
}

std::optional<engine::Spring> readSpring(Keys& keys, const char* key) {
    const Value* table = keys.any(key);
    if (!table) return std::nullopt;
    Keys spring = keys.inner(*table, "a spring");
    const engine::Spring read = readHzAndDamping(spring);
    spring.done();
    return read;
}

void readRestingSpring(Keys& keys, const char* key, Way way, engine::Freedom& freedom) {
    const Value* table = keys.any(key);
    if (!table) return;
    Keys spring = keys.inner(*table, "a spring");
    freedom.spring = readHzAndDamping(spring);
    if (way == Way::along)
        freedom.rest = spring.number("rest", kMeters).value_or(0.0);
    else
        freedom.rest = engine::radians(spring.number("rest_deg", kDegrees).value_or(0.0));
    spring.done();
}

std::optional<double> readInertia(Keys& keys, const char* key, Way way) {
    return keys.number(key, {1e-12, 1e9, way == Way::about ? "kg m^2" : "kg"});
}

engine::Freedom readFreedom(Keys& keys, const char* key, Way way) {
    engine::Freedom freedom;
    const Value* value = keys.any(key);
    if (!value) return freedom;
    if (value->kind != Value::Kind::table) {
        const auto word = value->kind == Value::Kind::text ? keys.word(key, {"free", "locked"})
                                                           : std::optional<std::string>();
        if (value->kind != Value::Kind::text)
            keys.complain(key, std::string(key) + " is " + describe(*value) +
                                   "; it should be \"free\", \"locked\" or a table of limits, "
                                   "motor, spring and inertia");
        freedom.locked = word == "locked";
        return freedom;
    }
    Keys inner = keys.inner(*value, "a coordinate");
    const char* limits = way == Way::along ? "limits" : "limits_deg";
    freedom.limits = readLimits(inner, limits, way).value_or(engine::Limits{});
    freedom.motor = readMotor(inner, "motor", way).value_or(engine::Motor{});
    readRestingSpring(inner, "spring", way, freedom);
    freedom.inertia = readInertia(inner, "inertia", way).value_or(0.0);
    inner.done();
    return freedom;
}

}  // namespace demos
