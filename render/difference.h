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

/// Measured on probes, to be repeated on this renderer: one scene on CPUs of different classes
/// (with and without FMA) gave window <= 1 and SSIM >= 0.954; damaged pictures gave window >= 49
/// and SSIM <= 0.431. The defaults lie between. A share of the whole picture, as other tools
/// count, lets a body moved by 1 cm pass. SSIM is blind to colour alone, so it only adds.
struct Gate {
    int levels = 3;        // of 255; a pixel that differs by more counts
    int windowPixels = 8;  // counted pixels allowed in any 16x16 window
    double ssim = 0.90;    // every block must reach it
    const char* reason = "between the noise of CPU classes and the least damage";  // of its numbers
};

/// `levels`: a pixel counts in a window when any channel differs by more.
Difference compare(const Image& a, const Image& b, int levels = Gate{}.levels);

/// Whether `difference`, measured with `gate.levels`, passes. Pictures of two sizes never do.
bool samePicture(const Difference& difference, const Gate& gate = {});

}  // namespace render
