#include "demos/mjcf/actuators.h"

#include <algorithm>
#include <array>
#include <set>

#include "demos/mjcf/freedom.h"
#include "demos/text/nearest.h"

namespace demos::mjcf {
namespace {

constexpr Range kAny{-1e9, 1e9};

/// Names of joints or tendons.
using Known = std::set<std::string>;

using Polynomial = std::array<double, 3>;  // coefficients of 1, length, speed

/// `free`: the joints among them that leave a body free.
void addNames(const Element& element, Known& joints, Known& free) {
    for (const Element& child : element.children) {
        const Attribute *name = child.find("name"), *type = child.find("type");
        const bool isFree = child.name == "freejoint" || (type && type->value == "free");
        if (name && (child.name == "joint" || child.name == "freejoint")) {
            joints.insert(name->value);
            if (isFree) free.insert(name->value);
        }
        addNames(child, joints, free);
    }
}

class ActuatorReader {
public:
    ActuatorReader(const Element& element, double control, const Context& context)
        : kind_(element.name),
          own_(context.defaults.of(element, "")),
          general_(context.defaults.of(element, "", "general")),
          autoLimits_(context.rules.autoLimits),
          control_(control) {}

    void add(const Known& joints, const Known& free, const Known& tendons, Actuation& actuation) {
        const char* key = own_.has("joint") ? "joint" : "jointinparent";
        if (own_.has(key) && free.contains(own_.text(key)))
            return own_.note("", "an actuator of a free joint is not supported; left out");
        if (own_.has(key)) return add(key, joints, actuation.joints);
        if (own_.has("tendon")) add("tendon", tendons, actuation.tendons);
    }

private:
    /// The kinds are shortcuts: what their own defaults do not set comes from those of <general>.
    Attributes& saying(const char* name) { return own_.has(name) ? own_ : general_; }

    double number(const char* name, double otherwise) {
        return saying(name).number(name, kAny).value_or(otherwise);
    }

    void add(const char* key, const Known& known, ForcesByName& forces) {
        const std::string name = own_.text(key);
        if (!known.contains(name))
            return own_.wrong(key, std::string("no ") +
                                       (key == std::string("tendon") ? key : "joint") +
                                       " is called '" + name.substr(0, 64) + "'" +
                                       suggestion(name, {known.begin(), known.end()}));
        if (isDynamic()) return;
        AffineForce force = limited(atControl());
        const std::vector<double> gear =
            saying("gear").numbers("gear", 1, 6, kAny).value_or(std::vector<double>{1.0});
        forces[name] += force.geared(gear.front());
    }

    bool isDynamic() {
        const std::string type = saying("dyntype").text("dyntype");
        const bool dynamic = kind_ == "general" && !type.empty() && type != "none";
        if (dynamic)
            own_.note("", "an actuator with activation dynamics (dyntype " +
                              type.substr(0, 40) + ") is not supported; left out");
        return dynamic;
    }

    std::optional<std::vector<double>> range(const char* name, const char* limited) {
        if (!isLimited(saying(limited), limited, name, autoLimits_ && saying(name).has(name)))
            return std::nullopt;
        const auto range = saying(name).numbers(name, 2, 2, kAny);
        if (range && (*range)[0] <= (*range)[1]) return range;
        if (range)
            own_.wrong(name, std::string(name) + " is '" + saying(name).text(name).substr(0, 40) +
                                 "'; it should be two numbers, the lower one first");
        return std::nullopt;
    }

    AffineForce atControl() {
        double control = control_;
        if (const auto limits = range("ctrlrange", "ctrllimited"))
            control = engine::clamped(control, (*limits)[0], (*limits)[1]);
        Polynomial gain{1.0, 0.0, 0.0}, bias{0.0, 0.0, 0.0};
        readLaw(gain, bias);
        return {gain[0] * control + bias[0], -gain[1] * control - bias[1],
                -gain[2] * control - bias[2]};
    }

    void readLaw(Polynomial& gain, Polynomial& bias) {
        if (kind_ == "position") {
            gain[0] = number("kp", 1.0);
            bias = {0.0, -gain[0], -number("kv", 0.0)};
        } else if (kind_ == "velocity") {
            gain[0] = number("kv", 1.0);
            bias[2] = -gain[0];
        } else if (kind_ == "damper") {
            gain = {0.0, 0.0, -number("kv", 1.0)};
        } else if (kind_ == "general") {
            readTerms("gaintype", {"fixed", "affine"}, "gainprm", gain);
            readTerms("biastype", {"none", "affine"}, "biasprm", bias);
        }
    }

    /// With the first of the words, only the constant of `terms` counts.
    void readTerms(const char* type, const std::vector<std::string>& words, const char* name,
                   Polynomial& terms) {
        Attributes& says = saying(type);
        const std::string word = says.has(type) ? says.text(type) : words.front();
        if (word != words[0] && word != words[1])
            return own_.note("", std::string(type) + " " + word.substr(0, 40) +
                                     " of an actuator is not supported; replaced by " + words[0]);
        const auto given = saying(name).numbers(name, 1, 10, kAny);
        const bool counts = word != "none";
        const std::size_t most = word == "affine" ? 3 : 1;
        for (std::size_t i = 0; given && counts && i < std::min(most, given->size()); ++i)
            terms[i] = (*given)[i];
    }

    AffineForce limited(AffineForce force) {
        const auto limits = range("forcerange", "forcelimited");
        if (!limits) return force;
        if (force.isConstant())
            force.constant = engine::clamped(force.constant, (*limits)[0], (*limits)[1]);
        else
            own_.note("forcerange", "forcerange of an actuator whose force is not constant is "
                                    "not supported; left out");
        return force;
    }

    std::string kind_;
    Attributes own_, general_;
    bool autoLimits_;
    double control_;
};

/// The controls of the first <key> that has some.
std::vector<double> controls(const Element& root, const Context& context) {
    constexpr std::size_t kMost = 10'000;
    for (const Element& section : root.children) {
        if (section.name != "keyframe") continue;
        for (const Element& key : section.children)
            if (key.find("ctrl"))
                return context.defaults.of(key, "").numbers("ctrl", 1, kMost, kAny).value_or(
                    std::vector<double>{});
    }
    return {};
}

}  // namespace

Actuation readActuators(const Element& root, const Context& context) {
    Known joints, free, tendons;
    for (const Element& section : root.children) {
        if (section.name == "worldbody") addNames(section, joints, free);
        if (section.name != "tendon") continue;
        for (const Element& tendon : section.children)
            if (const Attribute* name = tendon.find("name")) tendons.insert(name->value);
    }
    const std::vector<double> control = controls(root, context);
    Actuation actuation;
    std::size_t number = 0;
    for (const Element& section : root.children) {
        if (section.name != "actuator") continue;
        for (const Element& element : section.children) {
            const double own = number < control.size() ? control[number] : 0.0;
            ++number;
            static const Known kRead{"general", "motor", "position", "velocity", "damper"};
            if (kRead.contains(element.name))
                ActuatorReader(element, own, context).add(joints, free, tendons, actuation);
        }
    }
    return context.rules.actuation ? actuation : Actuation{};
}

}  // namespace demos::mjcf
