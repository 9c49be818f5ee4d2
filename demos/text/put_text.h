/// Text for the standard streams.
#pragma once
#include <cstdio>
#include <string_view>

namespace demos {

/// Never throws: a closed pipe must not end the run. A failure of standard output is reported at
/// the end (run.cpp), one of standard error is not.
void putText(std::FILE* stream, std::string_view text);

/// "impulse: LINE" on standard error.
void putError(std::string_view line);

}  // namespace demos
