/// <asset>: meshes and the colours of materials, by name.
#pragma once
#include <map>
#include <optional>
#include <string>

#include "demos/mjcf/compiler.h"
#include "engine/shape.h"

namespace demos::mjcf {

struct MeshShapes {
    engine::Shape hull;                    // about its own centre of mass
    std::optional<engine::Shape> picture;  // its triangles, in the axes of the hull
};

struct Assets {
    std::map<std::string, std::optional<MeshShapes>> meshes;  // nothing: an error, reported already
    std::map<std::string, std::optional<unsigned>> colors;       // 0xRRGGBB of materials
};

/// The colour of rgba, or nothing. Transparency is not supported.
std::optional<unsigned> readColor(Attributes& attributes);

/// `folder`: the model's.
Assets readAssets(const Element& root, const Defaults& defaults, const Rules& rules,
                  const std::filesystem::path& folder, const FileReader& read,
                  Diagnostics& diagnostics);

}  // namespace demos::mjcf
