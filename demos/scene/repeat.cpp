#include "demos/scene/repeat.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "demos/scene/keys.h"
#include "demos/scene/ranges.h"
#include "engine/base/trigonometry.h"

namespace demos {
namespace {

constexpr int kMostTurns = 100'000;  // of all [[repeat]]s together: a turn may add nothing

/// One [[repeat]] as written, for one turn of the [[repeat]]s around it.
struct Repeat {
    int count = 0, countStep = 0;
    Vec3 step{0, 0, 0};      // m
    Vec3 turnStep{0, 0, 0};  // rad
    std::optional<Vec3> about;
    Vec3 jitter{0, 0, 0};  // m
    std::vector<const Value*> bodies, joints, forces, inner;

    Motion motion(int i) const { return {engine::turnAboutXyz(turnStep * i), about, step * i}; }
};

void readMoves(Keys& keys, Repeat& r) {
    r.step = keys.vector("step", kMeters).value_or(Vec3(0, 0, 0));
    const Vec3 degrees = keys.vector("turn_step_deg", {-1e4, 1e4, "deg"}).value_or(Vec3(0, 0, 0));
    for (int k = 0; k < 3; ++k) r.turnStep[k] = engine::radians(degrees[k]);
    r.about = keys.vector("about", kMeters);
    r.jitter = keys.vector("jitter", {0.0, 1e3, "m"}).value_or(Vec3(0, 0, 0));
}

Repeat readRepeat(const Value& table, const Scope& scope, Complaints& complaints) {
    Keys keys(table, "a [[repeat]]", complaints, scope);
    const int depth = scope.turns.depth;
    Repeat r;
    const Value* count = table.find("count");
    if (!count) keys.complain("count", "a [[repeat]] has no count; write count = 10");
    const bool computed = count && !count->isNumber();  // may then be 0 in some turns
    r.count = keys.whole("count", {computed ? 0.0 : 1.0, kMostBodies}).value_or(0);
    // For pyramids: the inner count of the i-th outer turn is count + i count_step.
    if (depth > 0) r.countStep = keys.whole("count_step", {-kMostBodies, kMostBodies}).value_or(0);
    readMoves(keys, r);
    const int before = complaints.count();
    r.bodies = keys.tables("body");
    r.joints = keys.tables("joint");
    r.forces = keys.tables("force");
    if (depth + 1 < kDeepestRepeat)
        r.inner = keys.tables("repeat");
    else if (keys.any("repeat"))
        keys.complain("repeat",
                      "[[repeat]]s can be nested at most three deep: there are only i, j "
                      "and k");
    const bool reported = complaints.count() > before;  // an error in what it holds
    if (!reported && r.bodies.empty() && r.joints.empty() && r.forces.empty() && r.inner.empty())
        complaints.add(table.place,
                       "an empty [[repeat]]; give it a body, a joint, a force or a repeat");
    keys.done();
    return r;
}

std::size_t valuesIn(const Value& value) {
    std::size_t count = 1;
    for (const Value& item : value.items) count += valuesIn(item);
    return count;
}

/// Collects the instances and stops at the limits: a file of two lines can request 10^8 bodies.
class Unrolling {
public:
    Unrolling(Instances& out, std::uint64_t seed, Complaints& complaints)
        : out_(out), random_(seed), complaints_(complaints) {}

    void body(const Instance& instance) { add(out_.bodies, instance, kMostBodies, "10000 bodies"); }
    void joint(const Instance& instance) {
        add(out_.joints, instance, kMostJoints, "20000 joints");
    }
    void force(const Instance& instance) {
        add(out_.forces, instance, kMostForces, "10000 forces");
    }

    /// `instance`: the turn of the [[repeat]]s around it. False after an error.
    bool repeat(const Value& table, Instance instance) {
        const int before = complaints_.count();
        const Repeat r = readRepeat(table, instance.scope, complaints_);
        if (complaints_.count() > before) return false;
        Turns& turns = instance.scope.turns;
        const int level = turns.depth++;
        const long long outer = level > 0 ? turns.index[level - 1] : 0;
        const long long count = r.count + r.countStep * outer;
        turns.count[level] = static_cast<int>(std::clamp<long long>(count, 0, 10 * kMostBodies));
        for (int i = 0; i < turns.count[level] && !full_; ++i) {
            turns.index[level] = i;
            instance.motion[level] = r.motion(i);
            if (++turns_ > kMostTurns)
                stop(table, "100000 turns of [[repeat]]s");
            else
                turn(r, instance);
            for (const Value* inner : r.inner)
                if (!full_ && !repeat(*inner, instance)) return false;
        }
        return true;
    }

private:
    void turn(const Repeat& r, Instance instance) {
        for (const Value* table : r.bodies) {
            // In separate statements: the order of evaluation in one expression is unspecified.
            for (int k = 0; k < 3; ++k) instance.jitter[k] = r.jitter[k] * random_.signedUnit();
            instance.table = table;
            body(instance);
        }
        instance.jitter.setZero();
        for (const Value* table : r.joints) {
            instance.table = table;
            joint(instance);
        }
        for (const Value* table : r.forces) {
            instance.table = table;
            force(instance);
        }
    }

    void add(std::vector<Instance>& list, const Instance& instance, int most, const char* what) {
        const bool hasRoom = static_cast<int>(list.size()) < most;
        values_ += valuesIn(*instance.table);
        if (hasRoom && values_ <= kMostUnrolledValues)
            list.push_back(instance);
        else if (!full_)
            stop(*instance.table,
                 hasRoom ? "2000000 values in all bodies, joints and forces" : what);
    }

    void stop(const Value& table, const char* what) {
        full_ = out_.incomplete = true;
        complaints_.add(table.place,
                        std::string("more than ") + what + "; make the scene or a count smaller");
    }

    Instances& out_;
    SplitMix64 random_;
    Complaints& complaints_;
    int turns_ = 0;
    std::size_t values_ = 0;
    bool full_ = false;
};

/// The value of the text between braces; nothing, with the reason, if it is not a whole number.
std::optional<int> wholeIn(std::string_view text, const Scope& scope, std::string& wrong) {
    constexpr double kLargest = 1e9;
    if (text == "i") return scope.turns.index[0];  // by far the most frequent
    const Evaluated result = scope.expressions->evaluate(text, scope.turns);
    const std::string where = "{" + shown(text) + "} in a name";
    if (!result.value)
        wrong = where + ": " + result.wrong;
    else if (*result.value != std::floor(*result.value))
        wrong = where + " is " + numberText(*result.value) + "; it should be a whole number";
    else if (std::fabs(*result.value) > kLargest)
        wrong =
            where + " is " + numberText(*result.value) + "; it should be from -1e9 to 1e9";
    else
        return static_cast<int>(*result.value);
    return std::nullopt;
}

}  // namespace

std::string Instance::named(std::string_view text, std::string& wrong) const {
    std::string out;
    while (isRepeated()) {
        const std::size_t open = text.find('{');
        const std::size_t close = open == std::string_view::npos ? open : text.find('}', open);
        if (close == std::string_view::npos) break;
        out += text.substr(0, open);
        const std::optional<int> number =
            wholeIn(text.substr(open + 1, close - open - 1), scope, wrong);
        out += number ? std::to_string(*number) : text.substr(open, close - open + 1);
        text.remove_prefix(close + 1);
    }
    return out += text;
}

std::string Instance::named(std::string_view text, Keys& keys, std::string_view key) const {
    std::string wrong;
    std::string name = named(text, wrong);
    if (!wrong.empty()) keys.complain(key, wrong);
    return name;
}

Vec3 Instance::point(const Vec3& p) const {
    Vec3 moved = p;
    for (int level = scope.turns.depth - 1; level >= 0; --level) moved = motion[level].point(moved);
    return moved + jitter;
}

Quat Instance::rotation(const Quat& q) const {
    Quat turned = q;
    for (int level = scope.turns.depth - 1; level >= 0; --level)
        turned = motion[level].turn * turned;
    return turned;
}

Vec3 Instance::direction(const Vec3& v) const {
    Vec3 turned = v;
    for (int level = scope.turns.depth - 1; level >= 0; --level)
        turned = motion[level].turn * turned;
    return turned;
}

Instances unroll(const Repeatable& tables, std::uint64_t seed, const Scope& scope,
                 Complaints& complaints) {
    enum class Kind { body, joint, force, repeat };
    struct Item {
        const Value* table;
        Kind kind;
    };
    std::vector<Item> items;
    for (const Value* table : tables.bodies) items.push_back({table, Kind::body});
    for (const Value* table : tables.joints) items.push_back({table, Kind::joint});
    for (const Value* table : tables.repeats) items.push_back({table, Kind::repeat});
    for (const Value* table : tables.forces) items.push_back({table, Kind::force});
    std::stable_sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
        const Place &p = a.table->place, &q = b.table->place;
        return std::tie(p.file, p.line, p.column) < std::tie(q.file, q.line, q.column);
    });
    Instances out;
    Unrolling unrolling(out, seed, complaints);
    for (const Item& item : items) {
        Instance instance;
        instance.table = item.table;
        instance.scope = scope;
        if (item.kind == Kind::body) unrolling.body(instance);
        if (item.kind == Kind::joint) unrolling.joint(instance);
        if (item.kind == Kind::repeat) unrolling.repeat(*item.table, instance);
        if (item.kind == Kind::force) unrolling.force(instance);
    }
    return out;
}

}  // namespace demos
