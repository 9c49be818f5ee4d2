// Compares a picture with one of eight times its size.
#pragma once
#include <cmath>

#include "render/image.h"
#include "render/renderer.h"

namespace render {

inline RendererSettings plainSettings(int width, int height, int samples) {
    RendererSettings s;
    s.width = width, s.height = height, s.samples = samples, s.threads = 0;
    return s;
}

/// Every pixel is the mean of 8 x 8 pixels of the larger picture.
inline Image shrunk(const Image& large) {
    Image small{large.width / 8, large.height / 8, {}};
    small.pixels.resize(4u * static_cast<std::size_t>(small.width * small.height));
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x)
            for (int c = 0; c < 4; ++c) {
                int sum = 32;
                for (int i = 0; i < 64; ++i)
                    sum += large.at(8 * x + i % 8, 8 * y + i / 8)[c];
                small.at(x, y)[c] = static_cast<std::uint8_t>(sum / 64);
            }
    return small;
}

/// Root of the mean square, in levels.
inline double apart(const Image& a, const Image& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double d = a.pixels[i] - b.pixels[i];
        sum += d * d;
    }
    return std::sqrt(sum / static_cast<double>(a.pixels.size()));
}

}  // namespace render
