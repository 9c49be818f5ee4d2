/// Materials by name, with their values for pictures and for other renderers.
#pragma once
#include <array>
#include <cstddef>
#include <string_view>

#include "render/frame.h"

namespace render {

/// A material as glTF describes one; its pattern and sheen are in shaders/material.glsl.
struct MaterialValues {
    std::string_view name;  // as in scene files
    float roughness;  // 0..1
    float metallic;   // 0..1
    float alpha;      // 0..1; below 1 it is seen through
    unsigned color;   // 0xRRGGBB, sRGB, of bodies that define none
};

/// The number of values of Material.
inline constexpr std::size_t kMaterials = 9;

/// In the order of Material.
inline constexpr std::array<MaterialValues, kMaterials> kMaterialTable = {{
    {"plastic", 0.55f, 0.0f, 1.0f, 0x2f6690},
    {"wood", 0.60f, 0.0f, 1.0f, 0xc39a68},
    {"brick", 0.95f, 0.0f, 1.0f, 0xa6563c},
    {"steel", 0.30f, 1.0f, 1.0f, 0xb9bec4},
    {"rubber", 0.85f, 0.0f, 1.0f, 0x2b2d30},
    {"stone", 0.80f, 0.0f, 1.0f, 0xa8a299},
    {"paper", 0.95f, 0.0f, 1.0f, 0xf1ece0},
    {"felt", 1.00f, 0.0f, 1.0f, 0x3f6b4f},
    {"glass", 0.05f, 0.0f, 0.30f, 0xcfe4e8},
}};

/// Its place in the table.
constexpr std::size_t indexOf(Material material) { return static_cast<std::size_t>(material); }
/// The row of the table.
constexpr const MaterialValues& valuesOf(Material material) {
    return kMaterialTable[indexOf(material)];
}

}  // namespace render
