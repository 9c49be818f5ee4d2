// [world] and [solver]

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "demos/scene/solver_settings.h"
#include "demos/scene/solver_words.h"
#include "demos/scene/table_readers.h"

namespace demos {
namespace {

engine::Settings presetOf(Keys& keys, SceneDescription& scene) {
    set(scene.preset, keys.word("preset", {"steady", "fast", "seed"}));
    return presetCalled(scene.preset);
}

/// Reads one of the words for these values, if the key is given.
template <class Enum>
void readWord(Keys& keys, const char* key, std::initializer_list<Enum> all, Enum& to) {
    std::vector<std::string> words;
    for (const Enum value : all) words.emplace_back(wordOf(value));
    const std::optional<std::string> word = keys.word(key, words);
    for (const Enum value : all)
        if (word == wordOf(value)) to = value;
}

void readMethod(Keys& keys, engine::Settings& s) {
    using engine::Method;
    readWord(keys, "type", {Method::impulses, Method::pgs, Method::pgsMatrix, Method::direct},
             s.method);
}

void readSweeps(Keys& keys, engine::Settings& s) {
    constexpr Range kSweeps{0, 10'000};
    const std::optional<int> sweeps = keys.whole("sweeps", kSweeps);
    const std::optional<int> least = keys.whole("min_sweeps", kSweeps);
    set(s.sweeps, sweeps);
    s.minSweeps = least ? *least : std::min(s.minSweeps, s.sweeps);
    if (s.minSweeps > s.sweeps)
        keys.complain("min_sweeps", "min_sweeps is " + std::to_string(s.minSweeps) +
                                        "; it should be at most sweeps, " +
                                        std::to_string(s.sweeps));
    set(s.tolerance, keys.number("tolerance", {0.0, 10.0, "m/s"}));
}

void readSubsteps(Keys& keys, engine::Settings& s) {
    constexpr Range kSubsteps{1, 1000};
    set(s.substeps, keys.whole("substeps", kSubsteps));
    const std::optional<int> most = keys.whole("max_substeps", kSubsteps);
    s.maxSubsteps = most ? *most : std::max(s.maxSubsteps, s.substeps);
    if (s.maxSubsteps < s.substeps)
        keys.complain("max_substeps", "max_substeps is " + std::to_string(s.maxSubsteps) +
                                          "; it should be at least substeps, " +
                                          std::to_string(s.substeps));
}

void readCorrections(Keys& keys, engine::Settings& s) {
    set(s.nudges, keys.whole("nudges", {0, 1000}));
    set(s.baumgarte, keys.number("baumgarte", {0.0, 1.0}));
    set(s.slop, keys.number("slop", {0.0, 0.1, "m"}));
    set(s.depenetrationSpeed, keys.number("depenetration_speed", {0.01, 1e4, "m/s"}));
    if (s.baumgarte > 0.0 && s.nudges > 0) {
        keys.complain("baumgarte", "baumgarte is " + numberText(s.baumgarte) + " and nudges are " +
                                       std::to_string(s.nudges) +
                                       "; use one of the two: write nudges = 0 or baumgarte = 0");
        s.baumgarte = 0.0;
    }
}

}  // namespace

void readWorld(Keys& top, SceneDescription& scene) {
    const Value* table = top.any("world");
    if (!table) return;
    Keys keys = top.inner(*table, "[world]");
    set(scene.gravity, keys.vector("gravity", {-1e4, 1e4, "m/s^2"}));
    set(scene.hz, keys.whole("hz", {10, 100'000, "steps a second"}));
    constexpr double kLargest = 9007199254740992.0;  // 2^53: exact in every TOML parser
    if (const auto seed = keys.large("seed", {0, kLargest}))
        scene.seed = static_cast<std::uint64_t>(*seed);
    keys.done();
}

void readSolver(Keys& top, SceneDescription& scene) {
    scene.settings = engine::Settings::steady();
    const Value* table = top.any("solver");
    if (!table) return;
    Keys keys = top.inner(*table, "[solver]");
    engine::Settings s = presetOf(keys, scene);
    readMethod(keys, s);
    readSweeps(keys, s);
    readSubsteps(keys, s);
    readCorrections(keys, s);
    readWord(keys, "order", {engine::Order::gravity, engine::Order::pairs}, s.order);
    readWord(keys, "joints", {engine::JointSolving::direct, engine::JointSolving::rows}, s.joints);
    set(s.block, keys.truth("block"));
    set(s.lanes, keys.truth("lanes"));
    set(s.warmStart, keys.truth("warm_start"));
    set(s.accumulate, keys.truth("accumulate"));
    set(s.threads, keys.whole("threads", {1, 64}));
    set(s.sleeping, keys.truth("sleeping"));
    set(s.sleepAfter, keys.number("sleep_after", {0.1, 3600.0, "s"}));
    keys.done();
    scene.settings = s;
}

}  // namespace demos
