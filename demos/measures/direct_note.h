/// Notes of the direct solver on a run: redundant rows, contradicting rows.
#pragma once
#include <set>
#include <string>
#include <vector>

#include "demos/play/stage.h"

namespace demos {

class DirectNote {
public:
    /// To be called after every step.
    void look(const Stage& stage);
    /// One line per note.
    std::vector<std::string> lines() const;

private:
    std::set<std::string> redundant_;         // joints
    long contradictions_ = 0, notFound_ = 0;  // steps
};

}  // namespace demos
