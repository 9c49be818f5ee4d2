/// A clock for timings, and a median that one slow round does not affect.
#pragma once
#include <time.h>

#include <algorithm>
#include <vector>

namespace demos {

/// s; CLOCK_MONOTONIC: wall time, CLOCK_PROCESS_CPUTIME_ID: processor time of this process.
inline double seconds(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// s, of this process.
inline double processorTime() { return seconds(CLOCK_PROCESS_CPUTIME_ID); }

/// 0 for no values.
inline double medianOf(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace demos
