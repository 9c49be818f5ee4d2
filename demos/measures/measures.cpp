#include "demos/measures/measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>

namespace demos {
namespace {

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMostCourses = 12;  // more lines cannot be distinguished
constexpr double kMillimetres = 1e3;
constexpr int kEnergyInks[] = {1, 0, 4};  // warm, cool, ink: as in statistics and replays

using Sweeps = std::span<const engine::SweepReport>;

/// The sweeps of the first sub-step in `all`. They ended by their number or by the tolerance, as in
/// sweepUntilSatisfied (engine/solver/impulses.h).
Sweeps firstSubstep(Sweeps all, const engine::Settings& settings) {
    const auto most = static_cast<std::size_t>(std::max(settings.sweeps, 1));
    const auto least = static_cast<std::size_t>(std::max(settings.minSweeps, 1));
    for (std::size_t count = 1; count <= all.size(); ++count) {
        const bool enough = count >= least && all[count - 1].residual < settings.tolerance;
        if (enough || count >= most) return all.first(count);
    }
    return all;
}

/// The least value of the axis: rare steps (at most one in fifty) that leave nearly nothing would
/// stretch the axis over rounding errors. 0 if there are more of them, or none.
double leastShown(const std::vector<double>& values) {
    constexpr double kNearly = 1e-9;  // of the largest
    double largest = 0.0;
    for (const double value : values)
        if (value > largest) largest = value;
    const auto tiny = std::count_if(values.begin(), values.end(), [&](double value) {
        return value > 0.0 && value < kNearly * largest;
    });
    const bool few = tiny > 0 && 50 * tiny <= static_cast<std::ptrdiff_t>(values.size());
    return few ? kNearly * largest : 0.0;
}

bool isHarder(Sweeps a, Sweeps b) {
    if (a.size() != b.size()) return a.size() > b.size();
    return !a.empty() && a.front().residual > b.front().residual;
}

}  // namespace

Measures measuresOf(const Stage& stage) {
    const engine::StepReport& report = stage.world.report();
    Measures m;
    m.time = report.time;
    m.energy = stage.world.energy();
    const engine::ErrorReport errors = stage.world.errors();
    m.contacts = errors.contacts;
    m.penetration = errors.penetration;
    m.separation = errors.separation;
    m.residual = report.residual;
    if (report.step > 0) return m;
    m.contacts = static_cast<int>(stage.world.contacts().size());
    for (const engine::ContactState& contact : stage.world.contacts())
        m.penetration = std::max(m.penetration, contact.penetration);
    for (const engine::JointId id : stage.joints)
        m.separation = std::max(m.separation, stage.world.joint(id).separation);
    return m;
}

void Recorder::look(const Stage& stage) {
    scene_ = stage.scene.name;
    hasJoints_ = !stage.joints.empty();
    looks_.push_back(measuresOf(stage));
    if (stage.world.report().step == 0) {  // nothing is solved yet
        looks_.back().residual = kGap;
        return;
    }
    lookAtSweeps(stage);
    lookAtContacts(stage);
}

void Recorder::lookAtSweeps(const Stage& stage) {
    const engine::StepReport& report = stage.world.report();
    Sweeps left = report.sweeps;
    const bool oneEach = static_cast<int>(left.size()) == report.substeps;  // the direct solver
    while (!left.empty()) {
        const Sweeps now = oneEach ? left.first(1) : firstSubstep(left, stage.world.settings());
        if (isHarder(now, hardest_.sweeps)) hardest_ = {report.time, {now.begin(), now.end()}};
        left = left.subspan(now.size());
    }
}

void Recorder::lookAtContacts(const Stage& stage) {
    for (const engine::ContactState& contact : stage.world.contacts()) {
        const auto [low, high] = std::minmax(contact.a, contact.b);
        PointHistory& history = histories_[{low.index, high.index, contact.feature}];
        if (history.bodies.empty()) history.bodies = stage.nameOf(low) + "–" + stage.nameOf(high);
        history.looks.push_back(looks_.size() - 1);
        history.impulses.push_back(contact.impulse);
        history.largest = std::max(history.largest, contact.impulse);
    }
}

std::vector<Chart> Recorder::charts(const std::vector<std::string>& what) const {
    std::vector<Chart> all;
    for (const std::string& name : what) {
        if (name == "energy") all.push_back(energy());
        if (name == "penetration") all.push_back(penetration());
        if (name == "separation") all.push_back(separation());
        if (name == "contacts") all.push_back(contacts());
        if (name == "impulse") all.push_back(impulses());
        if (name == "residual") all.insert(all.end(), {sweeps(), residual()});
    }
    return all;
}

std::vector<double> Recorder::times() const {
    std::vector<double> result;
    for (const Measures& m : looks_) result.push_back(m.time);
    return result;
}

template <class Value>
Series Recorder::series(const std::string& label, Value value) const {
    Series result{label, times(), {}};
    for (const Measures& m : looks_) result.y.push_back(value(m));
    return result;
}

Chart Recorder::overTime(const std::string& title, const std::string& yTitle,
                         const std::string& unit) const {
    Chart chart;
    chart.title = scene_ + ": " + title;
    chart.xTitle = "time", chart.xUnit = "s";
    chart.yTitle = yTitle, chart.yUnit = unit;
    return chart;
}

Chart Recorder::energy() const {
    Chart chart = overTime("energy", "energy", "J");
    chart.series = {series("kinetic", [](const Measures& m) { return m.energy.kinetic; }),
                    series("potential", [](const Measures& m) { return m.energy.potential; }),
                    series("total", [](const Measures& m) { return m.energy.total(); })};
    for (std::size_t i = 0; i < chart.series.size(); ++i) chart.series[i].ink = kEnergyInks[i];
    return chart;
}

Chart Recorder::penetration() const {
    Chart chart = overTime("deepest penetration", "penetration", "mm");
    const bool touched =
        std::any_of(looks_.begin(), looks_.end(), [](const Measures& m) { return m.contacts > 0; });
    if (touched)
        chart.series = {series("", [](const Measures& m) { return kMillimetres * m.penetration; })};
    useFittingUnit(chart);
    return chart;
}

Chart Recorder::separation() const {
    Chart chart = overTime("widest joint separation", "separation", "mm");
    if (hasJoints_)
        chart.series = {series("", [](const Measures& m) { return kMillimetres * m.separation; })};
    useFittingUnit(chart);
    return chart;
}

Chart Recorder::contacts() const {
    Chart chart = overTime("contact points", "points", "");
    chart.series = {series("", [](const Measures& m) { return double{1} * m.contacts; })};
    return chart;
}

std::vector<const Recorder::PointHistory*> Recorder::largestHistories() const {
    std::vector<const PointHistory*> all;
    for (const auto& [key, history] : histories_)
        if (history.largest > 0.0) all.push_back(&history);
    std::stable_sort(all.begin(), all.end(), [](const PointHistory* a, const PointHistory* b) {
        return a->largest > b->largest;
    });
    all.resize(std::min(all.size(), kMostCourses));
    return all;
}

/// A missing contact leaves a gap. The points of one pair are numbered.
Chart Recorder::impulses() const {
    Chart chart = overTime("impulse of each contact point", "impulse per step", "N s");
    const std::vector<const PointHistory*> histories = largestHistories();
    if (histories.size() == kMostCourses && histories_.size() > kMostCourses)
        chart.title += fmt::format(", the {} largest of {}", kMostCourses, histories_.size());
    std::map<std::string, int> points, numbered;
    for (const PointHistory* history : histories) ++points[history->bodies];
    for (const PointHistory* history : histories) {
        Series line{history->bodies, times(), std::vector<double>(looks_.size(), kGap)};
        if (points[history->bodies] > 1)
            line.label += fmt::format(" ({})", ++numbered[history->bodies]);
        for (std::size_t i = 0; i < history->looks.size(); ++i)
            line.y[history->looks[i]] = history->impulses[i];
        chart.series.push_back(std::move(line));
    }
    return chart;
}

Chart Recorder::sweeps() const {
    Chart chart;
    chart.title = fmt::format("{}: residual sweep by sweep, hardest sub-step (t = {:.3f} s)",
                              scene_, hardest_.time);
    chart.xTitle = "sweep";
    chart.yTitle = "residual", chart.yUnit = "m/s";
    chart.logY = true;
    Series residual, distance;
    for (const engine::SweepReport& sweep : hardest_.sweeps) {
        if (sweep.residual == 0.0 && !residual.y.empty() && residual.y.back() == 0.0)
            break;  // nothing is left to correct in further sweeps
        residual.x.push_back(static_cast<double>(residual.x.size() + 1));
        residual.y.push_back(sweep.residual);
        distance.y.push_back(sweep.distance >= 0.0 ? sweep.distance : kGap);
    }
    distance.x = residual.x;
    chart.series = {std::move(residual)};
    if (std::none_of(hardest_.sweeps.begin(), hardest_.sweeps.end(),
                     [](const engine::SweepReport& sweep) { return sweep.distance >= 0.0; }))
        return chart;
    chart.series.front().label = "correction";
    distance.label = "to exact";
    chart.series.push_back(std::move(distance));
    return chart;
}

Chart Recorder::residual() const {
    Chart chart = overTime("residual after the last sweep", "residual", "m/s");
    chart.logY = true;
    chart.series = {series("", [](const Measures& m) { return m.residual; })};
    chart.leastY = leastShown(chart.series.front().y);
    return chart;
}

}  // namespace demos
