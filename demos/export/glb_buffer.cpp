// glTF 2.0, sections 3.6 (buffers, views, accessors) and 4.4 (binary glTF).
#include "demos/export/glb_buffer.h"

#include <algorithm>
#include <array>
#include <bit>

#include "demos/text/little_endian.h"
#include "render/error.h"

namespace demos {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

constexpr int kFloat = 5126, kUnsigned16 = 5123, kUnsigned32 = 5125;  // component types
constexpr int kNoTarget = 0, kVertices = 34962, kCorners = 34963;     // of a view

int componentsOf(GlbType type) {
    return type == GlbType::scalar ? 1 : type == GlbType::vec3 ? 3 : 4;
}

const char* nameOf(GlbType type) {
    return type == GlbType::scalar ? "SCALAR" : type == GlbType::vec3 ? "VEC3" : "VEC4";
}

std::uint32_t sizeInGlb(std::size_t size) {
    if (size > std::numeric_limits<std::uint32_t>::max())
        throw render::Error("a .glb cannot exceed 4 GiB; use fewer frames (--fps, --seconds)");
    return static_cast<std::uint32_t>(size);
}

/// Every chunk's length is a multiple of four.
void addChunk(std::vector<std::uint8_t>& out, std::uint32_t type,
              std::span<const std::uint8_t> data, std::uint8_t padding) {
    const std::size_t fill = (4 - data.size() % 4) % 4;
    putBytes(out, sizeInGlb(data.size() + fill));
    putBytes(out, type);
    out.insert(out.end(), data.begin(), data.end());
    out.insert(out.end(), fill, padding);
}

}  // namespace

int GlbBuffer::addView(std::span<const std::byte> bytes, int target) {
    bytes_.resize((bytes_.size() + 3) / 4 * 4);  // accessors must be aligned to their components
    GlbJson& view = views_.emplace_back();
    view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}};
    if (target != kNoTarget) view["target"] = target;
    const auto* first = reinterpret_cast<const std::uint8_t*>(bytes.data());
    bytes_.insert(bytes_.end(), first, first + bytes.size());
    return static_cast<int>(views_.size()) - 1;
}

int GlbBuffer::addAccessor(int view, int component, std::size_t count, const char* type) {
    GlbJson& accessor = accessors_.emplace_back();
    accessor = {
        {"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}};
    return static_cast<int>(accessors_.size()) - 1;
}

int GlbBuffer::addFloats(std::span<const float> values, GlbType type, int target, bool bounds) {
    const auto width = static_cast<std::size_t>(componentsOf(type));
    const int view = addView(std::as_bytes(values), target);
    const int number = addAccessor(view, kFloat, values.size() / width, nameOf(type));
    if (!bounds) return number;
    GlbJson &least = accessors_.back()["min"], &largest = accessors_.back()["max"];
    for (std::size_t k = 0; k < width; ++k) {
        float low = values[k], high = values[k];
        for (std::size_t i = k; i < values.size(); i += width) {
            low = std::min(low, values[i]);
            high = std::max(high, values[i]);
        }
        least.push_back(low);
        largest.push_back(high);
    }
    return number;
}

int GlbBuffer::addKeys(std::span<const float> values, GlbType type) {
    return addFloats(values, type, kNoTarget, type == GlbType::scalar);
}

int GlbBuffer::addPositions(std::span<const float> values) {
    return addFloats(values, GlbType::vec3, kVertices, true);
}

int GlbBuffer::addNormals(std::span<const float> values) {
    return addFloats(values, GlbType::vec3, kVertices, false);
}

/// The largest 16-bit number must not be used as an index (3.7.2.1).
int GlbBuffer::addCorners(std::span<const std::uint32_t> corners, std::size_t vertices) {
    if (vertices > std::numeric_limits<std::uint16_t>::max())
        return addAccessor(addView(std::as_bytes(corners), kCorners), kUnsigned32, corners.size(),
                           "SCALAR");
    const std::vector<std::uint16_t> narrowed(corners.begin(), corners.end());
    return addAccessor(addView(std::as_bytes(std::span(narrowed)), kCorners), kUnsigned16,
                       corners.size(), "SCALAR");
}

std::vector<std::uint8_t> GlbBuffer::file(GlbJson json) const {
    constexpr std::uint32_t kMagic = 0x46546c67, kVersion2 = 2, kHeader = 12;
    constexpr std::uint32_t kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;
    if (!bytes_.empty()) {  // the format allows no empty lists
        json["accessors"] = accessors_;
        json["bufferViews"] = views_;
        json["buffers"] = {{{"byteLength", bytes_.size()}}};
    }
    const std::string text = json.dump(-1, ' ', false, GlbJson::error_handler_t::replace);
    std::vector<std::uint8_t> chunks;
    addChunk(chunks, kJsonChunk, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()},
             ' ');
    if (!bytes_.empty()) addChunk(chunks, kBinaryChunk, bytes_, 0);
    std::vector<std::uint8_t> out;
    for (const std::uint32_t word : {kMagic, kVersion2, sizeInGlb(kHeader + chunks.size())})
        putBytes(out, word);
    out.insert(out.end(), chunks.begin(), chunks.end());
    return out;
}

}  // namespace demos
