/// The binary part of a .glb, and the lists of its JSON that describe the layout.
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
    GlbBuffer(const GlbBuffer&) = delete;  // others keep references to it
    GlbBuffer& operator=(const GlbBuffer&) = delete;

    /// Each returns an accessor's number. For an animation; times have minimum and maximum.
    int addKeys(std::span<const float> values, GlbType type);
    /// For vertices: positions have minimum and maximum, normals need none.
    int addPositions(std::span<const float> values);
    int addNormals(std::span<const float> values);
    /// Corners of triangles, of `vertices` vertices.
    int addCorners(std::span<const std::uint32_t> corners, std::size_t vertices);

    /// The whole file: `json` with `accessors`, `bufferViews` and `buffers` added. Throws
    /// render::Error if it would be too large for the format.
    std::vector<std::uint8_t> file(GlbJson json) const;

private:
    int addView(std::span<const std::byte> bytes, int target);
    int addAccessor(int view, int component, std::size_t count, const char* type);
    int addFloats(std::span<const float> values, GlbType type, int target, bool bounds);

    std::vector<std::uint8_t> bytes_;
    GlbJson views_ = GlbJson::array(), accessors_ = GlbJson::array();
};

}  // namespace demos
