/// How far apart two pictures are, and whether that is still the same picture.
#pragma once
#include "render/image.h"

namespace render {

/// What compare() measures.
struct Difference {
    bool sameSize = false;         // false: nothing below was measured
    long differing = 0;            // pixels that differ at all, in any channel
    int largest = 0;               // largest difference of one channel, levels of 255
    int worstWindow = 0;           // most pixels over the levels in any 16x16 window
    int windowX = 0, windowY = 0;  // its upper left corner, the first such window
    double worstSsim = 1.0;        // least structural similarity of any 8x8 block of luma, -1..1
};

/// Measured on this renderer with all built-in scenes (tests/benchmark/gate). Noise, from
/// processors with FMA to those without: window <= 3, SSIM >= 0.993. Damage, such as a body that is
/// 1 cm off, hidden or of another colour: window >= 24. The defaults lie between. One step of the
/// sky's openness is 5 levels of 255, and where it falls to the other side five pixels differ by
/// more than 3 levels, but one by more than 4. A share of the whole picture, as other tools count,
/// lets a body moved by 1 cm pass. SSIM is blind to colour alone, so it only adds.
struct Gate {
    int levels = 4;        // of 255; a pixel that differs by more counts
    int windowPixels = 8;  // counted pixels allowed in any 16x16 window
    double ssim = 0.90;    // every block must reach it
    const char* reason = "between the noise of processors and the least damage";  // of its numbers
};

/// `levels`: a pixel counts in a window when any channel differs by more.
Difference compare(const Image& a, const Image& b, int levels = Gate{}.levels);

/// Whether `difference`, measured with `gate.levels`, passes. Pictures of two sizes never do.
bool samePicture(const Difference& difference, const Gate& gate = {});

}  // namespace render
