/// The world's fault (no context, disk full, no ffmpeg), told in one line: what is wrong, the value,
/// what would be right.
#pragma once
#include <stdexcept>

namespace render {

class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace render
