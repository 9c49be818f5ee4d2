/// Independent pieces of work, each in a process of its own: one that crashes takes nothing with
/// it, and each may have an OpenGL context (two in one process would wait for each other).
#pragma once
#include <functional>
#include <string>

namespace demos {

/// How a piece ended.
struct PoolResult {
    bool ended = false;  // it came to its end, and `text` is what it returned
    std::string text;    // else how it did not: "was ended by signal 11 (Segmentation fault)"
};

/// Runs `work(i)` for i of 0 to count - 1 in forked processes, at most `jobs` at a time, and gives
/// what each returns to `take(i, result)` in this order, and to `finished(i, result)` as soon as it
/// is there. Call before any OpenGL. `work` must not throw. Throws Stop (interrupted) after SIGINT
/// or SIGTERM, with the processes ended.
void runInProcesses(int count, int jobs, const std::function<std::string(int)>& work,
                    const std::function<void(int, const PoolResult&)>& take,
                    const std::function<void(int, const PoolResult&)>& finished = {});

}  // namespace demos
