#include "render/encode/float_files.h"

#include <bit>
#include <string>

#include "render/encode/bytes.h"
#include "render/error.h"

namespace render {
namespace {

void addFloat(Bytes& file, float value) {
    addLittleEndian32(file, std::bit_cast<std::uint32_t>(value));
}

void checkCount(std::size_t count, int width, int height) {
    const bool sane = width >= 1 && height >= 1;
    if (!sane || count != static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
        throw Error("a float picture of " + std::to_string(width) + "x" + std::to_string(height) +
                    " holds " + std::to_string(count) + " pixels; it needs width times height");
}

}  // namespace

std::vector<std::uint8_t> encodePfm(std::span<const float> values, int width, int height) {
    checkCount(values.size(), width, height);
    const std::string header =
        "Pf\n" + std::to_string(width) + " " + std::to_string(height) + "\n-1.0\n";
    Bytes file(header.begin(), header.end());
    file.reserve(header.size() + 4 * values.size());
    const std::size_t row = static_cast<std::size_t>(width);
    for (std::size_t y = static_cast<std::size_t>(height); y-- > 0;)
        for (const float value : values.subspan(y * row, row)) addFloat(file, value);
    return file;
}

std::vector<std::uint8_t> encodeFlo(std::span<const Eigen::Vector2f> flow, int width, int height) {
    checkCount(flow.size(), width, height);
    Bytes file{'P', 'I', 'E', 'H'};
    file.reserve(12 + 8 * flow.size());
    addLittleEndian32(file, static_cast<std::uint32_t>(width));
    addLittleEndian32(file, static_cast<std::uint32_t>(height));
    for (const Eigen::Vector2f& v : flow) {
        addFloat(file, v.x());
        addFloat(file, v.y());
    }
    return file;
}

}  // namespace render
