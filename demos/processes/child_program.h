/// Runs another program to its end, without a shell.
#pragma once
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace demos {

/// `arguments`: the program's name first, looked up in PATH. Its output goes to the file `words`.
/// Empty if it succeeded, else how it ended: "stopped with status 1". A program that takes longer
/// than `patience` is killed, with all that it has started. Throws render::Error if it cannot be
/// started, and Stop (interrupted) after SIGINT or SIGTERM, also earlier ones, if these are watched
/// (demos/processes/signals.h).
std::string runChild(const std::vector<std::string>& arguments, const std::filesystem::path& words,
                     std::chrono::milliseconds patience);

}  // namespace demos
