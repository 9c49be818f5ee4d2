// [[expect]]: the physics contract

#include <algorithm>
#include <utility>

#include "demos/scene/pattern.h"
#include "demos/scene/ranges.h"
#include "demos/scene/table_readers.h"
#include "demos/text/nearest.h"

namespace demos {
namespace {

using What = Expectation::What;

constexpr double kMostWatched = 1e6;  // bodies or joints, of all expectations: 80 MB
constexpr double kMostSwings = 1e7;   // steps in which a period follows a body: 240 MB

const std::vector<std::pair<std::string, What>>& kinds() {
    static const std::vector<std::pair<std::string, What>> list = {
        {"drift", What::drift},   {"penetration", What::penetration},
        {"energy", What::energy}, {"separation", What::separation},
        {"speed", What::speed},   {"position", What::position},
        {"period", What::period}, {"angle_deg", What::angle},
        {"count", What::count},   {"height", What::height},
        {"spread", What::spread}};
    return list;
}

/// What all expectations of a scene keep while it runs: a line of 30 characters may watch ten
/// thousand bodies in every step.
struct WatchedSoFar {
    double bodies = 0.0, swings = 0.0;
    bool tooMany() const {
        return bodies > kMostWatched || swings > kMostSwings;
    }
};

class ExpectationReader {
public:
    ExpectationReader(Keys keys, const SceneDescription& scene, WatchedSoFar& watched)
        : scene_(scene), watched_(watched), keys_(std::move(keys)) {
        e_.place = keys_.place();
    }

    Expectation read() {
        readWhat();
        readOf();
        readBounds();
        readWindow();
        countWatched();
        e_.why = keys_.text("why").value_or("");
        keys_.done();
        return e_;
    }

private:
    void readWhat() {
        std::vector<std::string> words;
        for (const auto& [word, what] : kinds()) words.push_back(word);
        if (!keys_.has("what"))
            keys_.complain("what", "an [[expect]] has no what; write what = \"drift\", or " +
                                       anyOf({words.begin() + 1, words.end()}));
        const std::optional<std::string> word = keys_.word("what", words);
        for (const auto& [name, what] : kinds())
            if (word == name) e_.what = what, known_ = true;
    }

    void readOf() {
        const auto patterns = keys_.texts("of");
        if (!known_) return;
        const bool world = e_.what == What::penetration || e_.what == What::energy;
        if (patterns && world)
            keys_.complain("of", "penetration and energy are for the whole world; leave `of` out");
        if (world) return;
        const bool joints = e_.what == What::separation;
        chosen_ = static_cast<int>(joints ? scene_.joints.size() : scene_.bodies.size());
        if (!patterns) return;
        const std::vector<std::string> names = joints ? jointNames(scene_) : bodyNames(scene_);
        readPatterns(*patterns, names, joints ? "no joint" : "no body");
    }

    void readPatterns(const std::vector<std::string>& patterns,
                      const std::vector<std::string>& names, const std::string& none) {
        e_.of.clear();
        if (patterns.size() > kMostPatterns)
            return keys_.complain("of", std::to_string(patterns.size()) +
                                            " names; they should be at most " +
                                            std::to_string(kMostPatterns));
        for (const std::string& pattern : patterns) {
            e_.of += (e_.of.empty() ? "" : ",") + pattern;
            const auto fits = [&](const auto& name) { return matches(pattern, name); };
            if (std::ranges::none_of(names, fits))
                keys_.complain("of", none + " is called '" + shown(pattern) + "'" +
                                         suggestion(pattern, names));
        }
        chosen_ = static_cast<int>(std::ranges::count_if(
            names, [&](const auto& name) { return matchesAny(e_.of, name); }));
    }

    void readBounds() {
        constexpr Range kAny{-1e30, 1e30};
        e_.below = keys_.number("below", kAny);
        e_.above = keys_.number("above", kAny);
        if (e_.what == What::position)
            e_.nearPoint = keys_.vector("near", kMeters);
        else
            e_.near = keys_.number("near", kAny);
        e_.within = keys_.number("within", {0.0, 1e30}).value_or(0.0);
        const bool near = keys_.has("near"), bound = keys_.has("below") || keys_.has("above");
        if (near != keys_.has("within"))
            keys_.complain(near ? "near" : "within",
                           "near and within go together: near = 2.37, "
                           "within = 0.01");
        else if (e_.what == What::position && known_ && (!near || bound))
            keys_.complain("what",
                           "a position needs near = [x, y, z] and within (m), and no other "
                           "bound");
        else if (near == bound && known_)
            keys_.complain("what",
                           "an [[expect]] needs a bound: below, above, or near with within");
        if (e_.below && e_.above && *e_.above >= *e_.below)
            keys_.complain("above", "above is " + numberText(*e_.above) +
                                        "; it should be less than below, " + numberText(*e_.below));
    }

    void readWindow() {
        const Range film{0.0, scene_.seconds, "s"};
        e_.after = keys_.number("after", film).value_or(0.0);
        e_.until = keys_.number("until", film);
        if (e_.until && *e_.until < e_.after)
            keys_.complain("until", "until is " + numberText(*e_.until) +
                                        "; it should not be earlier than after, " +
                                        numberText(e_.after));
    }

    /// Complains once.
    void countWatched() {
        if (watched_.tooMany()) return;
        const double steps = (e_.until.value_or(scene_.seconds) - e_.after) * scene_.hz;
        watched_.bodies += chosen_;
        if (e_.what == What::period) watched_.swings += chosen_ * std::max(steps, 0.0);
        if (watched_.tooMany())
            keys_.complain("of", "the [[expect]]s up to this one watch too much: " +
                                     numberText(watched_.bodies) + " bodies and joints, and " +
                                     numberText(watched_.swings) +
                                     " steps of periods; they should be at most a million and "
                                     "ten million: name fewer");
    }

    const SceneDescription& scene_;
    WatchedSoFar& watched_;
    Keys keys_;
    int chosen_ = 1;  // bodies or joints
    Expectation e_;
    bool known_ = false;
};

}  // namespace

void readExpectations(Keys& top, SceneDescription& scene) {
    const std::vector<const Value*> tables = top.tables("expect");
    if (tables.size() > static_cast<std::size_t>(kMostExpectations))
        return top.complain("expect", std::to_string(tables.size()) +
                                          " [[expect]]s; a scene should have at most " +
                                          std::to_string(kMostExpectations));
    WatchedSoFar watched;
    for (const Value* table : tables) {
        if (top.complaintCount() >= kEnoughComplaints) return;
        scene.expectations.push_back(
            ExpectationReader(top.inner(*table, "an [[expect]]"), scene, watched).read());
    }
}

}  // namespace demos
