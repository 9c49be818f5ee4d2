/// `impulse test --self-test`: shows which damage a test would detect.
#pragma once
#include "demos/regression/test_options.h"
#include "demos/text/stop.h"

namespace demos {

Exit selfTest(const TestOptions& options);

}  // namespace demos
