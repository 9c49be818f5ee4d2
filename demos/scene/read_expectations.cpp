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

class ExpectationReader {
public:
    ExpectationReader(Keys keys, const SceneDescription& scene)
        : scene_(scene), keys_(std::move(keys)) {
        e_.place = keys_.place();
    }

    Expectation read() {
        readWhat();
        readOf();
        readBounds();
        readWindow();
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
        if (!patterns || !known_) return;
        if (e_.what == What::penetration || e_.what == What::energy) {
            keys_.complain("of", "penetration and energy are for the whole world; leave `of` out");
            return;
        }
        const bool joints = e_.what == What::separation;
        const std::vector<std::string> names = joints ? jointNames(scene_) : bodyNames(scene_);
        e_.of.clear();
        for (const std::string& pattern : *patterns) {
            e_.of += (e_.of.empty() ? "" : ",") + pattern;
            const bool found = std::any_of(names.begin(), names.end(), [&](const auto& name) {
                return matches(pattern, name);
            });
            if (!found)
                keys_.complain("of", std::string(joints ? "no joint" : "no body") + " is called '" +
                                         pattern + "'" + suggestion(pattern, names));
        }
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

    const SceneDescription& scene_;
    Keys keys_;
    Expectation e_;
    bool known_ = false;
};

}  // namespace

void readExpectations(Keys& top, SceneDescription& scene) {
    for (const Value* table : top.tables("expect"))
        scene.expectations.push_back(
            ExpectationReader(top.inner(*table, "an [[expect]]"), scene).read());
}

}  // namespace demos
