#include "render/context.h"

#include <algorithm>
#include <cstddef>

#include "render/gl.h"

namespace render {

Image Context::read() const {
    Image image{width_, height_, {}};
    const std::size_t row = std::size_t{4} * width_;
    image.pixels.resize(row * height_);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    for (int y = 0; y < height_ / 2; ++y) {  // GL's row 0 is at the bottom
        std::swap_ranges(image.at(0, y), image.at(0, y) + row, image.at(0, height_ - 1 - y));
    }
    return image;
}

}  // namespace render
