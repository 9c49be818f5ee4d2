/// The program without its start-up code in main().
#pragma once

namespace demos {

/// Runs the command line; every exception becomes a line on standard error and an exit code.
int run(int argc, const char* const* argv) noexcept;

}  // namespace demos
