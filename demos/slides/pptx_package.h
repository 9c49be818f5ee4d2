/// The parts of a .pptx (ECMA-376, Office Open XML): files in a ZIP with their content types, and
/// relationships by which they refer to each other.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "demos/export/zip.h"

namespace demos {

/// The relationships of one part, in a file beside it.
class PptxRelations {
public:
    /// The identity of a relationship: "rId3". `type`: the last word of its address. `target`:
    /// relative to the part.
    std::string add(const std::string& type, const std::string& target);
    std::string addLink(const std::string& address);
    /// A film within the package, as PowerPoint 2010 and later want it beside `video`.
    std::string addMedia(const std::string& target);
    /// The title and the author of the package.
    std::string addCore(const std::string& target);
    std::string xml() const;
    bool empty() const { return lines_.empty(); }

private:
    std::string addLine(const std::string& type, const std::string& target, const char* mode);
    std::vector<std::string> lines_;
};

class PptxPackage {
public:
    /// `name`: from the root: "ppt/slides/slide1.xml"; `type`: the word of its content type after
    /// "presentationml." and before "+xml", or the whole type if it has a slash.
    void add(const std::string& name, const std::string& xml, const std::string& type,
             const PptxRelations& relations = {});
    void addBytes(const std::string& name, std::vector<std::uint8_t> bytes);
    /// The package; the same parts give the same bytes. Throws render::Error.
    std::vector<std::uint8_t> bytes() const;

private:
    std::vector<ZipEntry> files_;
    std::string types_;
};

/// The attributes of a part's root element.
inline constexpr std::string_view kPptxSpaces =
    "xmlns:a=\"http://schemas.openxmlformats.org/drawingml/2006/main\" "
    "xmlns:r=\"http://schemas.openxmlformats.org/officeDocument/2006/relationships\" "
    "xmlns:p=\"http://schemas.openxmlformats.org/presentationml/2006/main\"";

}  // namespace demos
