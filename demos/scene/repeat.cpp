#include "demos/scene/repeat.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <tuple>

#include "demos/scene/keys.h"
#include "engine/base/trigonometry.h"

namespace demos {
namespace {

constexpr Range kMeters{-1e5, 1e5, "m"};

/// One [[repeat]] as written.
struct Repeat {
    int count = 0, countStep = 0;
    Vec3 step{0, 0, 0};      // m
    Vec3 turnStep{0, 0, 0};  // rad
    std::optional<Vec3> about;
    Vec3 jitter{0, 0, 0};  // m
    std::vector<const Value*> bodies, joints, forces, inner;
    Place place;

    Motion motion(int i) const { return {engine::turnAboutXyz(turnStep * i), about, step * i}; }
};

Repeat readRepeat(const Value& table, int depth, Complaints& complaints) {
    Keys keys(table, "a [[repeat]]", complaints);
    Repeat r;
    r.place = table.place;
    if (!keys.has("count")) keys.complain("count", "a [[repeat]] has no count; write count = 10");
    r.count = keys.whole("count", {1, kMostBodies}).value_or(0);
    // For pyramids: the inner count of the i-th outer turn is count + i count_step.
    if (depth == 1) r.countStep = keys.whole("count_step", {-kMostBodies, kMostBodies}).value_or(0);
    r.step = keys.vector("step", kMeters).value_or(Vec3(0, 0, 0));
    const Vec3 degrees = keys.vector("turn_step_deg", {-1e4, 1e4, "deg"}).value_or(Vec3(0, 0, 0));
    for (int k = 0; k < 3; ++k) r.turnStep[k] = engine::radians(degrees[k]);
    r.about = keys.vector("about", kMeters);
    r.jitter = keys.vector("jitter", {0.0, 1e3, "m"}).value_or(Vec3(0, 0, 0));
    r.bodies = keys.tables("body");
    r.joints = keys.tables("joint");
    r.forces = keys.tables("force");
    if (depth == 0)
        r.inner = keys.tables("repeat");
    else if (keys.any("repeat"))
        keys.complain("repeat", "a [[repeat]] in a [[repeat]] holds no third: there are i and j");
    if (r.bodies.empty() && r.joints.empty() && r.forces.empty() && r.inner.empty())
        complaints.add(table.place,
                       "a [[repeat]] of nothing; give it a body, a joint, a force or a repeat");
    keys.done();
    return r;
}

/// Grows the instances, and stops at the limits: a file of two lines can ask for 10^8 bodies.
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

    void repeat(const Value& table) {
        const int before = complaints_.count();
        const Repeat outer = readRepeat(table, 0, complaints_);
        std::vector<Repeat> inner;
        for (const Value* t : outer.inner) inner.push_back(readRepeat(*t, 1, complaints_));
        if (complaints_.count() > before) return;
        Instance instance;
        for (int i = 0; i < outer.count && !full_; ++i) {
            instance.depth = 1;
            instance.index[0] = i;
            instance.motion[0] = outer.motion(i);
            turn(outer, instance);
            for (const Repeat& r : inner) innerTurns(r, instance);
        }
    }

private:
    void innerTurns(const Repeat& r, Instance instance) {
        const long long count = r.count + static_cast<long long>(r.countStep) * instance.index[0];
        for (int j = 0; j < count && !full_; ++j) {
            instance.depth = 2;
            instance.index[1] = j;
            instance.motion[1] = r.motion(j);
            turn(r, instance);
        }
    }

    void turn(const Repeat& r, Instance instance) {
        for (const Value* table : r.bodies) {
            // One after the other: the order of evaluation in one expression is the compiler's.
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
        if (static_cast<int>(list.size()) < most) {
            list.push_back(instance);
        } else if (!full_) {
            full_ = true;
            complaints_.add(instance.table->place, std::string("more than ") + what +
                                                       "; make the scene or a count smaller");
        }
    }

    Instances& out_;
    SplitMix64 random_;
    Complaints& complaints_;
    bool full_ = false;
};

/// `i`, `i+1`, `j-12`: the letter's index and the number; nothing for any other text.
std::optional<int> evaluate(std::string_view text, const Instance& instance) {
    const int which = text.empty() ? -1 : text[0] - 'i';
    if (which < 0 || which >= instance.depth) return std::nullopt;
    int offset = 0;
    if (text.size() > 1) {
        if (text.size() < 3 || text.size() > 6 || (text[1] != '+' && text[1] != '-'))
            return std::nullopt;
        const char* end = text.data() + text.size();
        const std::from_chars_result read = std::from_chars(text.data() + 2, end, offset);
        if (read.ec != std::errc() || read.ptr != end || text[2] == '-') return std::nullopt;
        if (text[1] == '-') offset = -offset;
    }
    return instance.index[which] + offset;
}

}  // namespace

std::string Instance::named(std::string_view text) const {
    std::string out;
    while (!text.empty()) {
        const std::size_t open = text.find('{');
        const std::size_t close = open == std::string_view::npos ? open : text.find('}', open);
        if (close == std::string_view::npos) break;
        out += text.substr(0, open);
        const std::optional<int> number = evaluate(text.substr(open + 1, close - open - 1), *this);
        out += number ? std::to_string(*number) : text.substr(open, close - open + 1);
        text.remove_prefix(close + 1);
    }
    return out += text;
}

Vec3 Instance::point(const Vec3& p) const {
    Vec3 moved = p;
    for (int level = depth - 1; level >= 0; --level) moved = motion[level].point(moved);
    return moved + jitter;
}

Quat Instance::rotation(const Quat& q) const {
    Quat turned = q;
    for (int level = depth - 1; level >= 0; --level) turned = motion[level].turn * turned;
    return turned;
}

Vec3 Instance::direction(const Vec3& v) const {
    Vec3 turned = v;
    for (int level = depth - 1; level >= 0; --level) turned = motion[level].turn * turned;
    return turned;
}

Instances unroll(const std::vector<const Value*>& bodies, const std::vector<const Value*>& joints,
                 const std::vector<const Value*>& forces,
                 const std::vector<const Value*>& repeats, std::uint64_t seed,
                 Complaints& complaints) {
    struct Item {
        const Value* table;
        int kind;  // 0 body, 1 joint, 2 repeat, 3 force
    };
    std::vector<Item> items;
    for (const Value* table : bodies) items.push_back({table, 0});
    for (const Value* table : joints) items.push_back({table, 1});
    for (const Value* table : repeats) items.push_back({table, 2});
    for (const Value* table : forces) items.push_back({table, 3});
    std::stable_sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
        const Place &p = a.table->place, &q = b.table->place;
        return std::tie(p.line, p.column) < std::tie(q.line, q.column);
    });
    Instances out;
    Unrolling unrolling(out, seed, complaints);
    for (const Item& item : items) {
        Instance instance;
        instance.table = item.table;
        if (item.kind == 0) unrolling.body(instance);
        if (item.kind == 1) unrolling.joint(instance);
        if (item.kind == 2) unrolling.repeat(*item.table);
        if (item.kind == 3) unrolling.force(instance);
    }
    return out;
}

std::uint64_t SplitMix64::next() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

double SplitMix64::signedUnit() {
    return static_cast<double>(next() >> 11) * (2.0 / 9007199254740992.0) - 1.0;
}

}  // namespace demos
