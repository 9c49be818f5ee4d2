/// What the direct solver had to say of a run: rows that follow from others, rows that contradict.
#pragma once
#include <set>
#include <string>
#include <vector>

#include "demos/play/stage.h"

namespace demos {

class DirectNote {
public:
    /// After every step.
    void look(const Stage& stage);
    /// A line each; none when nothing is to be said.
    std::vector<std::string> lines() const;

private:
    std::set<std::string> redundant_;         // joints
    long contradictions_ = 0, notFound_ = 0;  // steps
};

}  // namespace demos
