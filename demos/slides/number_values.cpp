#include "demos/slides/number_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "demos/film/progress.h"
#include "demos/text/complaints.h"
#include "demos/text/stop.h"

namespace demos {
namespace {

/// The name as it was written, without its digits.
std::string written(const NumberName& name) {
    std::string text = name.run == 1 ? "" : std::to_string(name.run) + ".";
    if (name.group == "measure") return text + name.field;
    text += name.group;
    for (const std::string& part : {name.of, name.field})
        if (!part.empty()) text += "." + part;
    return text;
}

[[noreturn]] void refuseNumber(const NumberName& name, const std::string& what) {
    throw Stop(Exit::scene, fmt::format("@{{{}}}: {}", printable(written(name)), printable(what)));
}

[[noreturn]] void refuseField(const NumberName& name) {
    refuseNumber(name,
                 "there is no such number; examples are body.NAME.height, joint.NAME.force, "
                 "contacts.impulse, run.time and measures");
}

/// Writes a number as text.
struct Writer {
    const NumberName& name;
    NumberSetting setting;

    std::string operator()(double value, const char* unit) const {
        return quantityText(value, unit, name.digits, setting, name.zeros);
    }
    std::string operator()(const Vec3& value, const char* unit) const {
        return vectorText(value, unit, name.digits, setting, name.zeros);
    }
};

std::string measureValue(const NumberName& name, const RunNumbers& run, const Writer& write) {
    const int measure = measureCalled(name.field);
    if (measure < 0) refuseField(name);
    const auto i = static_cast<std::size_t>(measure);
    return write(run.summary.values[i], measures()[i].unit);
}

std::string expectValue(const NumberName& name, const RunNumbers& run, const Writer& write) {
    std::size_t number = 0;
    std::from_chars(name.of.data(), name.of.data() + name.of.size(), number);
    if (number < 1 || number > run.expectations.size())
        refuseNumber(name, fmt::format("the scene '{}' has {} [[expect]]", run.scene.name,
                                       run.expectations.size()));
    const ExpectationResult& result = run.expectations[number - 1];
    return write(result.value, result.unit.c_str());
}

template <class List>
std::size_t placeOf(const NumberName& name, const List& list, const RunNumbers& run) {
    for (std::size_t i = 0; i < list.size(); ++i)
        if (list[i].name == name.of) return i;
    refuseNumber(name,
                 fmt::format("the scene '{}' has no {} '{}'", run.scene.name, name.group, name.of));
}

std::string bodyValue(const NumberName& name, const RunNumbers& run, const Writer& write) {
    const BodyMotion& body = run.moment.bodies[placeOf(name, run.scene.bodies, run)];
    if (name.field == "position") return write(body.pose.position, "m");
    if (name.field == "velocity") return write(body.velocity, "m/s");
    if (name.field == "spin") return write(body.spin, "rad/s");
    if (name.field == "height") return write(body.pose.position.y(), "m");
    if (name.field == "speed") return write(body.velocity.norm(), "m/s");
    refuseField(name);
}

/// A joint's force is a mean over the step, so force times dt is the impulse of the step's rows.
std::string jointValue(const NumberName& name, const RunNumbers& run, const Writer& write) {
    const engine::JointState& joint = run.moment.joints[placeOf(name, run.scene.joints, run)];
    if (name.field == "impulse") return write(joint.force.norm() * run.moment.dt, "N s");
    if (name.field == "force") return write(joint.force.norm(), "N");
    if (name.field == "separation") return write(joint.separation, "m");
    refuseField(name);
}

std::string contactsValue(const NumberName& name, const RunNumbers& run, const Writer& write) {
    double sum = 0.0, largest = 0.0;
    for (const engine::ContactState& contact : run.moment.contacts) {
        sum += contact.impulse;
        largest = std::max(largest, contact.impulse);
    }
    if (name.field == "impulse") return write(sum, "N s");
    if (name.field == "largest") return write(largest, "N s");
    if (name.field == "points") return write(double{1} * run.moment.measures.contacts, "");
    refuseField(name);
}

std::string runValue(const NumberName& name, const RunNumbers& run, const Writer& write) {
    const RunMoment& moment = run.moment;
    if (name.field == "time") return write(moment.measures.time, "s");
    if (name.field == "steps") return write(static_cast<double>(moment.report.step), "");
    if (name.field == "sweeps") return write(static_cast<double>(moment.report.sweeps.size()), "");
    if (name.field == "energy") return write(moment.measures.energy.total(), "J");
    if (name.field != "hash") refuseField(name);
    const std::string hash = hexText(moment.hash);
    return write.setting == NumberSetting::formula ? "\\mathtt{" + hash + "}" : hash;
}

}  // namespace

std::string valueOf(const NumberName& name, const RunNumbers& run, NumberSetting setting) {
    const Writer write{name, setting};
    if (name.group == "measure") return measureValue(name, run, write);
    if (name.group == "expect") return expectValue(name, run, write);
    if (name.group == "body") return bodyValue(name, run, write);
    if (name.group == "joint") return jointValue(name, run, write);
    if (name.group == "contacts") return contactsValue(name, run, write);
    if (name.group == "run") return runValue(name, run, write);
    refuseField(name);
}

}  // namespace demos
