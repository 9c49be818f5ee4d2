/// Time in seconds, from the machine's clocks.
#pragma once
#include <time.h>

namespace peers {

enum class Clock {
    wall,      // the time that a user waits
    processor  // of all threads of this process; others on the machine hardly change it
};

inline double seconds(Clock clock) {
    timespec now;
    clock_gettime(clock == Clock::wall ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace peers
