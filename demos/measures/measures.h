/// Records the measures of a run (look/measure_names.h) and makes charts of them.
#pragma once
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "demos/charts/chart.h"
#include "demos/look/measure_names.h"
#include "demos/play/stage.h"

namespace demos {

/// The values of one step; at time 0, what the first step will find.
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
    /// To be called at time 0 and after every step.
    void look(const Stage& stage);
    /// The charts in the order of `what`, names of measureNames(), also those without data;
    /// residual gives two.
    std::vector<Chart> charts(const std::vector<std::string>& what) const;

private:
    /// The sub-step with the most sweeps; of several, the one with the largest first residual.
    struct Hardest {
        double time = 0.0;  // s
        std::vector<engine::SweepReport> sweeps;
    };
    /// Identifies a contact point: lower body, higher body, feature.
    using ContactKey = std::tuple<int, int, int>;
    struct PointHistory {
        std::string bodies;
        std::vector<std::size_t> looks;  // indices of the looks at which it existed
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
    std::vector<const PointHistory*> largestHistories() const;

    std::string scene_;
    bool hasJoints_ = false;
    std::vector<Measures> looks_;
    std::map<ContactKey, PointHistory> histories_;
    Hardest hardest_;
};

}  // namespace demos
