#include "render/encode/png_read.h"

#include <cstdlib>
#include <limits>
#include <memory>
#include <string>

#include "render/encode/png.h"
#include "render/error.h"

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wconversion"
#endif
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb/stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace render {
namespace {

[[noreturn]] void refuse(const std::string& why) {
    throw Error("the PNG cannot be read: " + why + "; write the file again");
}

std::string sidesText(int width, int height) {
    return std::to_string(width) + "x" + std::to_string(height);
}

}  // namespace

Image decodePng(std::span<const std::uint8_t> bytes, int width, int height) {
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        refuse(std::to_string(bytes.size()) + " bytes are more than 2 GiB");
    }
    const int size = static_cast<int>(bytes.size());
    Image image;
    int channels = 0;
    if (!stbi_info_from_memory(bytes.data(), size, &image.width, &image.height, &channels)) {
        refuse("no PNG header");
    }
    if (image.width > kLargestSide || image.height > kLargestSide) {
        refuse(sidesText(image.width, image.height) + " has a side of more than 16384 pixels");
    }
    if ((width > 0 && image.width != width) || (height > 0 && image.height != height)) {
        refuse("it is " + sidesText(image.width, image.height) + ", not " +
               sidesText(width, height));
    }
    // stb does not check checksums and accepts some truncated files
    if (!pngIsWhole(bytes, image.width, image.height)) refuse("it is truncated or damaged");
    const std::unique_ptr<stbi_uc, decltype(&std::free)> pixels(
        stbi_load_from_memory(bytes.data(), size, &image.width, &image.height, &channels, 4),
        &std::free);
    if (!pixels) refuse(stbi_failure_reason());
    image.pixels.assign(pixels.get(), pixels.get() + std::size_t{4} * image.width * image.height);
    return image;
}

}  // namespace render
