/// Text for the standard streams.
#pragma once
#include <cstdio>
#include <string_view>

namespace demos {

/// Never throws: a reader that went away is no reason to lose what is being made. What standard
/// output has refused is reported at the end (run.cpp); what standard error has, nobody would read.
void putText(std::FILE* stream, std::string_view text);

/// "impulse: LINE" on standard error.
void putError(std::string_view line);

}  // namespace demos
