/// A model's XML as plain data, each element and attribute with its place, <include> expanded.
/// (Only xml_tree.cpp uses pugixml.)
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "demos/mjcf/diagnostics.h"

namespace demos::mjcf {

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
