/// The binary part of a .glb, and the lists of its JSON that say what lies where.
#pragma once
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace demos {

using GlbJson = nlohmann::ordered_json;

/// What an accessor's numbers are: one, three or four floats each.
enum class GlbType { scalar, vec3, vec4 };

class GlbBuffer {
public:
    GlbBuffer() = default;
    GlbBuffer(const GlbBuffer&) = delete;  // others hold on to it
    GlbBuffer& operator=(const GlbBuffer&) = delete;

    /// Each returns the number of an accessor. Of an animation; times have their least and largest.
    int addKeys(std::span<const float> values, GlbType type);
    /// Of vertices: positions have their least and largest, normals need none.
    int addPositions(std::span<const float> values);
    int addNormals(std::span<const float> values);
    /// Corners of triangles, of so many vertices.
    int addCorners(std::span<const std::uint32_t> corners, std::size_t vertices);

    /// The whole file: `json` with `accessors`, `bufferViews` and `buffers` added. Throws
    /// render::Error where it would be too large for the format.
    std::vector<std::uint8_t> file(GlbJson json) const;

private:
    int addView(std::span<const std::byte> bytes, int target);
    int addAccessor(int view, int component, std::size_t count, const char* type);
    int addFloats(std::span<const float> values, GlbType type, int target, bool bounds);

    std::vector<std::uint8_t> bytes_;
    GlbJson views_ = GlbJson::array(), accessors_ = GlbJson::array();
};

}  // namespace demos
