/// The options of `impulse test`.
#pragma once
#include <string>

#include "demos/options/options.h"

namespace demos {

struct TestOptions : Options {
    std::string baselines;  // a folder; empty = next to the scenes
    std::string update;     // missing, changed, all, none; empty = missing, or none where CI=true
    bool cache = true;      // skip scenes that have passed
    bool selfTest = false;
};

}  // namespace demos
