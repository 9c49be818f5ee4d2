/// A model's XML as plain data, each piece with its place, <include> carried out. (The only text
/// that knows pugixml is xml_tree.cpp.)
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

    /// Null where it is not given.
    const Attribute* find(std::string_view attribute) const;
};

/// The bytes of a file; throws SceneError.
using FileReader = std::function<std::string(const std::filesystem::path&)>;

/// The document's outermost element; what is no XML, or beyond the limits (depth 64, 200 000
/// elements, 256 attributes each, 64 files), is reported. `include` names files beside the model's own. XML's entities
/// of its own making are not known, so that none can grow.
Element readTree(const std::string& text, const std::string& fileName, const FileReader& read,
                 Diagnostics& diagnostics);

}  // namespace demos::mjcf
