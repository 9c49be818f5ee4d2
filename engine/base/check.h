/// The caller's bugs stop the program, in every build, with the fix in the message.
/// (Circumstances, such as a state that is no longer finite, are reported instead: StepReport.)
#pragma once

namespace engine {
/// Prints the four to standard error and aborts.
[[noreturn]] void checkFailed(const char* condition, const char* advice, const char* file,
                              int line);
}

/// What has to be true of a call, and what to do instead.
#define ENGINE_CHECK(condition, advice) \
    ((condition) ? static_cast<void>(0) \
                 : ::engine::checkFailed(#condition, advice, __FILE__, __LINE__))
