#include "demos/slides/pptx_package.h"

#include <fmt/format.h>

#include "demos/slides/pptx_text.h"

namespace demos {
namespace {

constexpr const char* kHead = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n";
constexpr const char* kOffice =
    "http://schemas.openxmlformats.org/officeDocument/2006/relationships/";

std::vector<std::uint8_t> xmlBytes(const std::string& xml) {
    const std::string text = kHead + xml;
    return {text.begin(), text.end()};
}

/// "ppt/slides/_rels/slide1.xml.rels"
std::string relationsName(const std::string& part) {
    const std::size_t slash = part.rfind('/') + 1;
    return part.substr(0, slash) + "_rels/" + part.substr(slash) + ".rels";
}

}  // namespace

std::string PptxRelations::addLine(const std::string& type, const std::string& target,
                                   const char* mode) {
    const std::string id = fmt::format("rId{}", lines_.size() + 1);
    lines_.push_back(fmt::format("<Relationship Id=\"{}\" Type=\"{}\" Target=\"{}\"{}/>", id, type,
                                 xmlText(target), mode));
    return id;
}

std::string PptxRelations::add(const std::string& type, const std::string& target) {
    return addLine(kOffice + type, target, "");
}

std::string PptxRelations::addLink(const std::string& address) {
    return addLine(std::string(kOffice) + "hyperlink", address, " TargetMode=\"External\"");
}

std::string PptxRelations::addMedia(const std::string& target) {
    return addLine("http://schemas.microsoft.com/office/2007/relationships/media", target, "");
}

std::string PptxRelations::addCore(const std::string& target) {
    return addLine(
        "http://schemas.openxmlformats.org/package/2006/relationships/metadata/core-properties",
        target, "");
}

std::string PptxRelations::xml() const {
    std::string xml =
        "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">";
    for (const std::string& line : lines_) xml += line;
    return xml + "</Relationships>";
}

void PptxPackage::add(const std::string& name, const std::string& xml, const std::string& type,
                      const PptxRelations& relations) {
    files_.push_back({name, xmlBytes(xml)});
    const bool whole = type.find('/') != std::string::npos;
    types_ += fmt::format(
        "<Override PartName=\"/{}\" ContentType=\"{}\"/>", name,
        whole ? type
              : "application/vnd.openxmlformats-officedocument.presentationml." + type + "+xml");
    if (!relations.empty()) files_.push_back({relationsName(name), xmlBytes(relations.xml())});
}

void PptxPackage::addBytes(const std::string& name, std::vector<std::uint8_t> bytes) {
    files_.push_back({name, std::move(bytes)});
}

std::vector<std::uint8_t> PptxPackage::bytes() const {
    constexpr const char* kDefaults =
        "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
        "<Default Extension=\"rels\" "
        "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
        "<Default Extension=\"xml\" ContentType=\"application/xml\"/>"
        "<Default Extension=\"png\" ContentType=\"image/png\"/>"
        "<Default Extension=\"mp4\" ContentType=\"video/mp4\"/>";
    PptxRelations root;
    root.add("officeDocument", "ppt/presentation.xml");
    root.add("extended-properties", "docProps/app.xml");
    root.addCore("docProps/core.xml");
    std::vector<ZipEntry> all{{"[Content_Types].xml", xmlBytes(kDefaults + types_ + "</Types>")},
                              {"_rels/.rels", xmlBytes(root.xml())}};
    all.insert(all.end(), files_.begin(), files_.end());
    return zipOf(all);
}

}  // namespace demos
