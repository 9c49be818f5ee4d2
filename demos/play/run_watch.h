/// What someone should know of a run that was not about it: that an expectation of the scene
/// failed, that a body fell out of the scene.
#pragma once
#include <string>
#include <vector>

#include "demos/play/expect.h"
#include "demos/play/falls.h"

namespace demos {

class RunWatch {
public:
    explicit RunWatch(const Stage& stage) : checker_(stage) { look(stage); }

    /// To be called after every step.
    void look(const Stage& stage) {
        checker_.look(stage);
        falls_.look(stage);
    }
    /// A line each, with the scene's name, at the end of the run.
    std::vector<std::string> lines(const Stage& stage) const;

private:
    ExpectationChecker checker_;
    Falls falls_;
};

}  // namespace demos
