/// The mean of several pictures, computed in linear light, not in sRGB. It gives anti-aliasing,
/// motion blur and soft shadows at once.
#pragma once
#include <cstdint>
#include <vector>

#include "render/image.h"

namespace render {

class Accumulator {
public:
    Accumulator(int width, int height);
    /// Adds a picture of the size given above; at most 256.
    void add(const Image& image);
    Image mean() const;

private:
    int width_, height_;
    std::uint32_t count_ = 0;
    std::vector<std::uint32_t> sums_;  // red, green, blue times alpha, and alpha; 0..65535 each
};

}  // namespace render
