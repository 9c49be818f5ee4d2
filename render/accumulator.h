/// The mean of several pictures, in light and not in sRGB: anti-aliasing, motion blur and soft
/// shadows at once.
#pragma once
#include <cstdint>
#include <vector>

#include "render/image.h"

namespace render {

class Accumulator {
public:
    Accumulator(int width, int height);
    /// At most 256 pictures of the size given above.
    void add(const Image& image);
    Image mean() const;

private:
    int width_, height_;
    std::uint32_t count_ = 0;
    std::vector<std::uint32_t> sums_;  // red, green, blue times cover, and cover; 0..65535 each
};

}  // namespace render
