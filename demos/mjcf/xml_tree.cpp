#include "demos/mjcf/xml_tree.h"

#include <algorithm>
#include <cstddef>
#include <pugixml.hpp>
#include <utility>

#include "demos/scene/reader.h"

namespace demos::mjcf {
namespace {

/// Line and column of a text's bytes.
class Lines {
public:
    explicit Lines(std::string_view text) {
        for (std::size_t i = 0; i < text.size(); ++i)
            if (text[i] == '\n') starts_.push_back(static_cast<std::ptrdiff_t>(i) + 1);
    }

    Place placeOf(std::ptrdiff_t offset) const {
        const auto after = std::upper_bound(starts_.begin(), starts_.end(), offset);
        return {static_cast<int>(after - starts_.begin()),
                static_cast<int>(offset - *(after - 1)) + 1};
    }

private:
    std::vector<std::ptrdiff_t> starts_{0};
};

class TreeReader {
public:
    TreeReader(const std::string& fileName, const FileReader& read, Diagnostics& diagnostics)
        : folder_(std::filesystem::path(fileName).parent_path()),
          read_(read),
          diagnostics_(diagnostics) {}

    Element readFile(std::string text, const std::string& name, int depth);

private:
    /// A parsed file. Names and values point into `text`, which gives their places.
    struct File {
        std::string text;
        Lines lines;
        int number = 0;

        std::ptrdiff_t offsetOf(const char* piece) const { return piece - text.data(); }
        Spot spotOf(std::ptrdiff_t offset) const {
            const auto size = static_cast<std::ptrdiff_t>(text.size());
            return {number, lines.placeOf(std::clamp<std::ptrdiff_t>(offset, 0, size))};
        }
    };

    Element convert(const pugi::xml_node& node, const File& file, int depth);
    void addAttributes(const pugi::xml_node& node, const File& file, Element& element);
    void addChildren(const pugi::xml_node& node, const File& file, int depth, Element& element);
    void include(const Element& element, int depth, std::vector<Element>& children);

    std::filesystem::path folder_;
    const FileReader& read_;
    Diagnostics& diagnostics_;
    std::vector<std::string> included_;
    int elements_ = 0;
};

Element TreeReader::readFile(std::string text, const std::string& name, int depth) {
    File file{text, Lines(text), diagnostics_.addFile(name)};
    pugi::xml_document document;
    const pugi::xml_parse_result result = document.load_buffer_inplace(
        file.text.data(), file.text.size(), pugi::parse_default, pugi::encoding_utf8);
    const pugi::xml_node root = document.document_element();
    if (!result) {
        diagnostics_.wrong(file.spotOf(result.offset),
                           std::string("this is not XML: ") + result.description());
        return {};
    }
    if (root.next_sibling())
        diagnostics_.wrong(file.spotOf(root.next_sibling().offset_debug()),
                           "a second root element; a document has only one");
    return convert(root, file, depth);
}

Element TreeReader::convert(const pugi::xml_node& node, const File& file, int depth) {
    Element element;
    element.name = node.name();
    element.spot = file.spotOf(node.offset_debug() - 1);  // at its bracket
    if (++elements_ == kMostElements + 1)
        diagnostics_.wrong(element.spot, "more than 200000 elements; a model should have fewer");
    if (depth == kDeepestElement + 1)
        diagnostics_.wrong(element.spot,
                           "elements nested more than 64 deep; nest them less deeply");
    if (elements_ > kMostElements || depth > kDeepestElement) return element;
    addAttributes(node, file, element);
    addChildren(node, file, depth, element);
    return element;
}

void TreeReader::addAttributes(const pugi::xml_node& node, const File& file, Element& element) {
    for (const pugi::xml_attribute& attribute : node.attributes()) {
        const Spot spot = file.spotOf(file.offsetOf(attribute.name()));
        if (element.attributes.size() == kMostAttributes)
            return diagnostics_.wrong(spot, "more than 256 attributes in one <" + element.name +
                                                ">; it should have fewer");
        if (element.find(attribute.name()))
            diagnostics_.wrong(spot, std::string("two attributes '") + attribute.name() +
                                         "' in one <" + element.name + ">; leave one out");
        element.attributes.push_back({attribute.name(), attribute.value(), spot});
    }
}

void TreeReader::addChildren(const pugi::xml_node& node, const File& file, int depth,
                             Element& element) {
    for (const pugi::xml_node& inner : node.children()) {
        if (inner.type() != pugi::node_element) continue;  // text has no meaning in MJCF
        Element child = convert(inner, file, depth + 1);
        if (child.name == "include")
            include(child, depth, element.children);
        else
            element.children.push_back(std::move(child));
    }
}

void TreeReader::include(const Element& element, int depth, std::vector<Element>& children) {
    const Attribute* name = element.find("file");
    if (!name || name->value.empty())
        return diagnostics_.wrong(element.spot,
                                  "an <include> has no file; write file=\"NAME.xml\"");
    if (std::filesystem::path(name->value).is_absolute())
        return diagnostics_.wrong(name->spot, "file is '" + name->value +
                                                  "'; it should be relative to the model's folder");
    if (std::find(included_.begin(), included_.end(), name->value) != included_.end())
        return diagnostics_.wrong(
            name->spot, "'" + name->value + "' is included twice; include it only once");
    if (included_.size() == kMostModelFiles)
        return diagnostics_.wrong(
            name->spot, "'" + name->value + "' is the 65th file; a model should have at most 64");
    included_.push_back(name->value);
    const std::string path = (folder_ / name->value).lexically_normal().string();
    try {
        Element root = readFile(read_(path), path, depth);
        for (Element& child : root.children) children.push_back(std::move(child));
    } catch (const SceneError& error) {
        if (diagnostics_.errors() >= kEnoughComplaints) throw;
        diagnostics_.wrong(name->spot, error.what());
    }
}

}  // namespace

const Attribute* Element::find(std::string_view attribute) const {
    for (const Attribute& own : attributes)
        if (own.name == attribute) return &own;
    return nullptr;
}

Element readTree(const std::string& text, const std::string& fileName, const FileReader& read,
                 Diagnostics& diagnostics) {
    return TreeReader(fileName, read, diagnostics).readFile(text, fileName, 1);
}

}  // namespace demos::mjcf
