/// Measures how much two pictures differ, and decides whether they count as the same picture.
#pragma once
#include "render/image.h"

namespace render {

/// The result of compare().
struct Difference {
    bool sameSize = false;         // false: nothing below was measured
    long differing = 0;            // pixels that differ at all, in any channel
    int largest = 0;               // largest difference of one channel, in levels of 255
    int worstWindow = 0;           // most counted pixels in any 16x16 window
    int windowX = 0, windowY = 0;  // upper left corner of the first such window
    double worstShift = 0.0;       // levels: largest mean difference of a channel in any 8x8 window
    double worstSsim = 1.0;        // lowest structural similarity of any 8x8 block of luma, -1..1
};

/// The limits of samePicture(), measured on this renderer with all built-in scenes
/// (tests/benchmark/gate). Noise between processors with and without FMA: window <= 3,
/// SSIM >= 0.993. Damage, such as a body that is 1 cm off, hidden or of another colour:
/// window >= 24. The defaults lie between. One step of the sky's openness is 5 levels of 255; where
/// it rounds the other way, five pixels differ by more than 3 levels, but only one by more than 4.
/// A limit on the share of the whole picture, as in other tools, lets a body moved by 1 cm pass.
/// SSIM does not see differences of colour alone, so it is only an additional condition. An area that
/// changes its colour as a whole by less than `levels` is no noise: its mean shows it.
struct Gate {
    int levels = 4;        // of 255; a pixel that differs by more is counted
    int windowPixels = 8;  // most counted pixels allowed in any 16x16 window
    double ssim = 0.90;    // every block must reach it
    /// Most mean difference of a channel in any 8x8 window, in levels of 255. A gate whose
    /// windowPixels lets such an area differ as a whole lets it shift, too.
    double shift() const { return 0.5 * levels; }
    const char* reason = "between the noise of processors and the least damage";  // of the limits
};

/// `levels`: a pixel is counted in its windows if any channel differs by more.
Difference compare(const Image& a, const Image& b, int levels = Gate{}.levels);

/// Whether `difference`, measured with `gate.levels`, passes. Pictures of different sizes never do.
bool samePicture(const Difference& difference, const Gate& gate = {});

}  // namespace render
