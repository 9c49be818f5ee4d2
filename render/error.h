/// Errors of the environment (no context, disk full, no ffmpeg). The message is one line: what is
/// wrong, the value, and what would be right.
#pragma once
#include <stdexcept>

namespace render {

class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A file that must not be replaced exists under the name of a new one.
class AlreadyThere : public Error {
public:
    using Error::Error;
};

}  // namespace render
