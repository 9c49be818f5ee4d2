/// A frame rate that a scene's steps allow.
#pragma once

namespace demos {

/// The largest rate up to `wanted` frames a second that divides `hz` steps a second; both are
/// positive.
constexpr int fpsUpTo(int wanted, int hz) {
    int fps = wanted < hz ? wanted : hz;
    while (hz % fps != 0) --fps;
    return fps;
}

}  // namespace demos
