/// The caller's bugs stop the program, in every build, with the mend in the message.
/// (Circumstances, such as a state that is no longer finite, are reported instead: StepReport.)
#pragma once

namespace engine {
[[noreturn]] void checkFailed(const char* condition, const char* advice, const char* file,
                              int line);
}

#define ENGINE_CHECK(condition, advice) \
    ((condition) ? static_cast<void>(0) \
                 : ::engine::checkFailed(#condition, advice, __FILE__, __LINE__))
