/// Another program, run to its end without a shell.
#pragma once
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace demos {

/// `arguments`: the program's name first, looked up in PATH. What it says goes to the file `words`.
/// Empty when it ended well, else how it ended: "stopped with status 1". A program that takes
/// longer than `patience` is ended, with all that it has started. Throws render::Error where it
/// does not start, Stop (interrupted) after SIGINT or SIGTERM, where somebody watches for these
/// (demos/processes/signals.h), also before.
std::string runChild(const std::vector<std::string>& arguments, const std::filesystem::path& words,
                     std::chrono::milliseconds patience);

}  // namespace demos
