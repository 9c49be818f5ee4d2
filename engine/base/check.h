/// A bug of the caller stops the program in every build; the message says how to fix it.
/// (Run-time conditions, such as a state that is no longer finite, are reported instead:
/// StepReport.)
#pragma once

namespace engine {
/// Prints its arguments to standard error and aborts.
[[noreturn]] void checkFailed(const char* condition, const char* advice, const char* file,
                              int line);
}

/// A condition that a call must meet, and advice for the caller that violates it.
#define ENGINE_CHECK(condition, advice) \
    ((condition) ? static_cast<void>(0) \
                 : ::engine::checkFailed(#condition, advice, __FILE__, __LINE__))
