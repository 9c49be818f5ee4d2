/// Records a trajectory while a scene is simulated.
#pragma once
#include <map>

#include "demos/play/stage.h"
#include "demos/regression/trajectory.h"

namespace demos {

class TrajectoryRecorder {
public:
    /// `steps`: of the whole run. With very many bodies the trajectory is less dense.
    TrajectoryRecorder(const Stage& stage, int steps);

    /// Call it at time 0 and after every step.
    void look(const Stage& stage);
    const Trajectory& trajectory() const { return trajectory_; }

private:
    TrajectoryMoment momentOf(const Stage& stage);
    void addContacts(const Stage& stage, std::vector<TrajectoryImpulse>& impulses);
    void addJoints(const Stage& stage, std::vector<TrajectoryImpulse>& impulses);
    int constraintCalled(const std::string& name);

    Trajectory trajectory_;
    std::map<std::string, int> constraints_;
    int steps_, step_ = 0;
};

}  // namespace demos
