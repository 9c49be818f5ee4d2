/// The world's fault (no context, disk full, no ffmpeg), told in one line: what is wrong, the value,
/// what would be right.
#pragma once
#include <stdexcept>

namespace render {

class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A file that was to be new has appeared under its name meanwhile.
class AlreadyThere : public Error {
public:
    using Error::Error;
};

}  // namespace render
