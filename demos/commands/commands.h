/// The commands, one a file. Each throws Stop, SceneError or render::Error, or returns its code.
#pragma once
#include "demos/options.h"
#include "demos/stop.h"

namespace demos {

Exit renderCommand(const Options& options);
Exit stillCommand(const Options& options);
Exit stripCommand(const Options& options);
Exit simCommand(const Options& options);
Exit plotCommand(const Options& options);
Exit compareCommand(const Options& options);
Exit sweepCommand(const Options& options);
Exit exportCommand(const Options& options);
Exit slidesCommand(const Options& options);
Exit testCommand(const Options& options);
Exit selfTestCommand(const Options& options);  // of test
Exit approveCommand(const Options& options);
Exit watchCommand(const Options& options);
Exit galleryCommand(const Options& options);
Exit listCommand(const Options& options);
Exit doctorCommand(const Options& options);
Exit benchCommand(const Options& options);
Exit completionCommand(const Options& options);

}  // namespace demos
