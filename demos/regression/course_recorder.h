/// Writes a course down while a scene plays.
#pragma once
#include <map>

#include "demos/regression/course.h"
#include "demos/scene/stage.h"

namespace demos {

class CourseRecorder {
public:
    /// `steps`: that will be played. With very many bodies the course is less dense.
    CourseRecorder(const Stage& stage, int steps);

    /// At time 0, and after every step.
    void look(const Stage& stage);
    const Course& course() const { return course_; }

private:
    CourseMoment momentOf(const Stage& stage);
    void addContacts(const Stage& stage, std::vector<CourseImpulse>& impulses);
    void addJoints(const Stage& stage, std::vector<CourseImpulse>& impulses);
    int constraintCalled(const std::string& name);

    Course course_;
    std::map<std::string, int> constraints_;
    int steps_, step_ = 0;
};

}  // namespace demos
