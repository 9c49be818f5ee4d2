/// What a run shows in numbers, recorded while it plays, as charts.
///
///   energy       J    kinetic, potential and their sum
///   penetration  mm   the deepest contact of the world
///   separation   mm   the joint that is farthest apart
///   contacts          points that touch or may touch within the next step
///   impulse      N s  along the normal, of each of the contacts that got most
///   residual     m/s  what the sweeps leave: sweep by sweep in the sub-step that was hardest, and
///                     after the last sweep of every step
#pragma once
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "demos/report/chart.h"
#include "demos/scene/stage.h"

namespace demos {

/// Every name above, in this order.
const std::vector<std::string>& measureNames();

/// What is recorded of a step; of time 0, what the first step will find.
struct Measures {
    double time = 0.0;      // s
    engine::Energy energy;  // J
    int contacts = 0;
    double penetration = 0.0;  // m
    double separation = 0.0;   // m
    double residual = 0.0;     // m/s
};
Measures measuresOf(const Stage& stage);

class Recorder {
public:
    /// At time 0, and after every step.
    void look(const Stage& stage);
    /// In the order of `what`, names of measureNames(); residual gives two. Those without data too.
    std::vector<Chart> charts(const std::vector<std::string>& what) const;

private:
    /// The sub-step with the most sweeps, of these the one with the largest first residual.
    struct Hardest {
        double time = 0.0;  // s
        std::vector<engine::SweepReport> sweeps;
    };
    /// A contact point while it lasts: lower body, higher body, feature.
    using ContactKey = std::tuple<int, int, int>;
    struct Course {
        std::string bodies;
        std::vector<std::size_t> looks;  // numbers of the looks at which it was there
        std::vector<double> impulses;    // N s
        double largest = 0.0;
    };

    void lookAtSweeps(const Stage& stage);
    void lookAtContacts(const Stage& stage);
    std::vector<double> times() const;
    Chart overTime(const std::string& title, const std::string& yTitle,
                   const std::string& unit) const;
    template <class Value>
    Series series(const std::string& label, Value value) const;
    Chart energy() const;
    Chart penetration() const;
    Chart separation() const;
    Chart contacts() const;
    Chart impulses() const;
    Chart sweeps() const;
    Chart residual() const;
    std::vector<const Course*> largestCourses() const;

    std::string scene_;
    bool hasJoints_ = false;
    std::vector<Measures> looks_;
    std::map<ContactKey, Course> courses_;
    Hardest hardest_;
};

}  // namespace demos
