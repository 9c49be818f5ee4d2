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
    void addContacts(const Stage& stage);
    void addJoints(const Stage& stage);
    int constraintCalled(const std::string& name, int a, int b);

    Trajectory trajectory_;
    std::map<std::string, int> constraints_;
    std::map<engine::BodyId, int> numbers_;  // in the scene
    std::map<int, double> sums_;             // N s since the moment before, by constraint
    int steps_, step_ = 0;
};

}  // namespace demos
