/// A model's XML as plain data, each element and attribute with its place, <include> expanded.
/// (Only xml_tree.cpp uses pugixml.)
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "demos/mjcf/diagnostics.h"

namespace demos::mjcf {

inline constexpr std::uintmax_t kMostModelBytes = 8u << 20;         // of a file
inline constexpr std::uintmax_t kMostModelBytesInAll = 128u << 20;  // a mesh may be read often
inline constexpr int kDeepestElement = 64;
inline constexpr int kMostElements = 200'000;
inline constexpr std::size_t kMostAttributes = 256;  // of an element; MuJoCo has fewer in all
inline constexpr std::size_t kMostModelFiles = 64;

struct Attribute {
    std::string name, value;
    Spot spot;
};

struct Element {
    std::string name;
    std::vector<Attribute> attributes;
    std::vector<Element> children;
    Spot spot;

    /// Null if it is missing.
    const Attribute* find(std::string_view attribute) const;
};

/// The bytes of a file; throws SceneError.
using FileReader = std::function<std::string(const std::filesystem::path&)>;

/// The document's root element. Text that is not XML or exceeds the limits (depth 64, 200 000
/// elements, 256 attributes each, 64 files) is reported. `include` is relative to the model's
/// folder. Entities that a document defines are not expanded, so that they cannot blow up.
Element readTree(const std::string& text, const std::string& fileName, const FileReader& read,
                 Diagnostics& diagnostics);

}  // namespace demos::mjcf
