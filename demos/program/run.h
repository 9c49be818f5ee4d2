/// The program but for its start-up, so that main() stays tiny.
#pragma once

namespace demos {

/// Does what the command line says; every exception becomes a line on standard error and a code.
int run(int argc, const char* const* argv) noexcept;

}  // namespace demos
