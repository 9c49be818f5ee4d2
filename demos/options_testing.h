/// Options of the commands that measure and compare: test, approve, bench.
#pragma once
#include "demos/options_commands.h"

namespace demos {

void addTest(CLI::App& app, Options& options, RawOptions& raw);
void addApprove(CLI::App& app, Options& options);
void addBench(CLI::App& app, Options& options, RawOptions& raw);

}  // namespace demos
