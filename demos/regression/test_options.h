/// What `impulse test` is asked for.
#pragma once
#include <string>

#include "demos/options/options.h"

namespace demos {

struct TestOptions : Options {
    std::string baselines;  // a folder; empty = beside the scenes
    std::string update;     // missing, changed, all, none; empty = missing, or none where CI=true
    bool cache = true;      // leave out what has passed
    bool selfTest = false;
};

}  // namespace demos
