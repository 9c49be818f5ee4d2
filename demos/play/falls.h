/// Bodies that fall out of a scene: below everything fixed, with nothing that could stop them.
#pragma once
#include <string>
#include <vector>

#include "demos/play/stage.h"

namespace demos {

/// Notices the bodies that still fall freely at the end of a run, 100 m below everything that is
/// fixed or kinematic; if there is no such thing, 44 m below their start: three seconds of fall.
/// Without gravity, and where air or a joint carries a body, nothing falls.
class Falls {
public:
    /// To be called after every step.
    void look(const Stage& stage);
    /// "my: 'ball' falls without end: ..."; empty if no body does.
    std::string line(const Stage& stage) const;

private:
    std::vector<Vec3> before_;     // m/s, by body, one step before the last
    std::vector<Vec3> velocities_;  // m/s, by body, of the last look
};

}  // namespace demos
