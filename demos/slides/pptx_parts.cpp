#include "demos/slides/pptx_parts.h"

#include <fmt/format.h>

#include "demos/look/inks.h"
#include "demos/slides/linked_page.h"
#include "demos/slides/markup.h"
#include "demos/slides/pptx_text.h"

namespace demos {
namespace {

constexpr const char* kTree =
    "<p:nvGrpSpPr><p:cNvPr id=\"1\" name=\"\"/><p:cNvGrpSpPr/><p:nvPr/></p:nvGrpSpPr><p:grpSpPr/>";
constexpr const char* kColors =
    "bg1=\"lt1\" tx1=\"dk1\" bg2=\"lt2\" tx2=\"dk2\" accent1=\"accent1\" accent2=\"accent2\" "
    "accent3=\"accent3\" accent4=\"accent4\" accent5=\"accent5\" accent6=\"accent6\" "
    "hlink=\"hlink\" folHlink=\"folHlink\"";

/// As --accent in page/slides.css.
std::string accentOf(const std::string& theme) {
    return theme == "dark" ? "79aef0" : theme == "print" ? "1d4e86" : "2263b0";
}

/// The roles are those of a light theme: dk1 is the ink and lt1 the ground, whatever they are.
std::string colorScheme(const std::string& theme) {
    const Inks inks = inksOf(theme);
    const auto color = [](const char* role, const std::string& rgb) {
        return fmt::format("<a:{0}><a:srgbClr val=\"{1}\"/></a:{0}>", role, rgb);
    };
    const auto ink = [](const render::Color& c) { return hexOf(c).substr(1); };
    std::string xml = color("dk1", ink(inks.ink)) + color("lt1", ink(inks.ground)) +
                      color("dk2", ink(inks.muted)) + color("lt2", ink(inks.grid)) +
                      color("accent1", accentOf(theme));
    for (int i = 1; i < 6; ++i)
        xml += color(fmt::format("accent{}", i + 1).c_str(), ink(lineColor(i, inks)));
    return xml + color("hlink", accentOf(theme)) + color("folHlink", accentOf(theme));
}

/// Arial, or a typeface of the same widths, is on every machine that shows such a file.
std::string themeXml(const std::string& theme) {
    constexpr const char* kFont =
        "<a:latin typeface=\"Arial\"/><a:ea typeface=\"\"/><a:cs typeface=\"\"/>";
    constexpr const char* kFill = "<a:solidFill><a:schemeClr val=\"phClr\"/></a:solidFill>";
    const std::string fills = std::string(kFill) + kFill + kFill;
    std::string lines, effects;
    for (int i = 0; i < 3; ++i) {
        lines += fmt::format("<a:ln w=\"9525\">{}</a:ln>", kFill);
        effects += "<a:effectStyle><a:effectLst/></a:effectStyle>";
    }
    return fmt::format(
        "<a:theme xmlns:a=\"http://schemas.openxmlformats.org/drawingml/2006/main\" "
        "name=\"impulse {0}\"><a:themeElements><a:clrScheme name=\"{0}\">{1}</a:clrScheme>"
        "<a:fontScheme name=\"impulse\"><a:majorFont>{2}</a:majorFont><a:minorFont>{2}"
        "</a:minorFont></a:fontScheme><a:fmtScheme name=\"impulse\"><a:fillStyleLst>{3}"
        "</a:fillStyleLst><a:lnStyleLst>{4}</a:lnStyleLst><a:effectStyleLst>{5}"
        "</a:effectStyleLst><a:bgFillStyleLst>{3}</a:bgFillStyleLst></a:fmtScheme>"
        "</a:themeElements></a:theme>",
        theme, colorScheme(theme), kFont, fills, lines, effects);
}

std::string placeholder(int id, const char* name, const char* type, const char* place,
                        const char* text) {
    return fmt::format(
        "<p:sp><p:nvSpPr><p:cNvPr id=\"{}\" name=\"{}\"/><p:cNvSpPr><a:spLocks noGrp=\"1\"/>"
        "</p:cNvSpPr><p:nvPr><p:ph {}/></p:nvPr></p:nvSpPr><p:spPr><a:xfrm>{}</a:xfrm><a:prstGeom "
        "prst=\"rect\"><a:avLst/></a:prstGeom></p:spPr><p:txBody><a:bodyPr lIns=\"0\" tIns=\"0\" "
        "rIns=\"0\" bIns=\"0\"/><a:lstStyle/><a:p>{}</a:p></p:txBody></p:sp>",
        id, name, type, place, text);
}

constexpr const char* kTitlePlace = "<a:off x=\"533400\" y=\"381000\"/><a:ext cx=\"11125200\" "
                                    "cy=\"632000\"/>";
constexpr const char* kOpeningPlace = "<a:off x=\"857250\" y=\"2500000\"/><a:ext cx=\"10477500\" "
                                      "cy=\"1400000\"/>";
constexpr const char* kSomeText = "<a:r><a:rPr lang=\"en-GB\"/><a:t>Title</a:t></a:r>";

std::string masterXml() {
    constexpr const char* kLevel =
        "<a:lvl1pPr algn=\"l\"><a:defRPr sz=\"{}\"{}><a:solidFill><a:schemeClr val=\"tx1\"/>"
        "</a:solidFill><a:latin typeface=\"+mn-lt\"/></a:defRPr></a:lvl1pPr>";
    const auto level = [&](int size, const char* bold) {
        return fmt::format(fmt::runtime(kLevel), size, bold);
    };
    return fmt::format(
        "<p:sldMaster {0}><p:cSld><p:bg><p:bgPr><a:solidFill><a:schemeClr val=\"bg1\"/>"
        "</a:solidFill><a:effectLst/></p:bgPr></p:bg><p:spTree>{1}{2}</p:spTree></p:cSld><p:clrMap "
        "{3}/><p:sldLayoutIdLst><p:sldLayoutId id=\"2147483649\" r:id=\"rId1\"/><p:sldLayoutId "
        "id=\"2147483650\" r:id=\"rId2\"/></p:sldLayoutIdLst><p:txStyles><p:titleStyle>{4}"
        "</p:titleStyle><p:bodyStyle>{5}</p:bodyStyle><p:otherStyle>{5}</p:otherStyle></p:txStyles>"
        "</p:sldMaster>",
        kPptxSpaces, kTree, placeholder(2, "Title", "type=\"title\"", kTitlePlace, kSomeText),
        kColors, level(3000, " b=\"1\""), level(2025, ""));
}

/// "3 / 25" in the corner.
std::string slideNumber(std::size_t slides) {
    constexpr const char* kLook = "<a:rPr lang=\"en-GB\" sz=\"1125\"><a:solidFill><a:schemeClr "
                                  "val=\"tx2\"/></a:solidFill><a:latin "
                                  "typeface=\"+mn-lt\"/></a:rPr>";
    return fmt::format(
        "<p:sp><p:nvSpPr><p:cNvPr id=\"3\" name=\"Number\"/><p:cNvSpPr txBox=\"1\"/><p:nvPr "
        "userDrawn=\"1\"/></p:nvSpPr><p:spPr><a:xfrm><a:off x=\"10800000\" y=\"6510000\"/><a:ext "
        "cx=\"1163400\" cy=\"230000\"/></a:xfrm><a:prstGeom prst=\"rect\"><a:avLst/></a:prstGeom>"
        "</p:spPr><p:txBody><a:bodyPr lIns=\"0\" tIns=\"0\" rIns=\"0\" bIns=\"0\" wrap=\"square\"/>"
        "<a:lstStyle/><a:p><a:pPr algn=\"r\"/><a:fld "
        "id=\"{{B6F15528-21DE-4FAA-801E-634DDDAF4B2B}}\" type=\"slidenum\">{0}<a:t>1</a:t></a:fld>"
        "<a:r>{0}<a:t> / {1}</a:t></a:r></a:p></p:txBody></p:sp>",
        kLook, slides);
}

std::string layoutXml(const char* name, const char* type, const std::string& shapes) {
    return fmt::format(
        "<p:sldLayout {} type=\"{}\" preserve=\"1\"><p:cSld name=\"{}\"><p:spTree>{}{}</p:spTree>"
        "</p:cSld><p:clrMapOvr><a:masterClrMapping/></p:clrMapOvr></p:sldLayout>",
        kPptxSpaces, type, name, kTree, shapes);
}

std::string notesMasterXml() {
    return fmt::format(
        "<p:notesMaster {}><p:cSld><p:bg><p:bgPr><a:solidFill><a:srgbClr val=\"ffffff\"/>"
        "</a:solidFill><a:effectLst/></p:bgPr></p:bg><p:spTree>{}<p:sp><p:nvSpPr><p:cNvPr id=\"2\" "
        "name=\"Slide\"/><p:cNvSpPr><a:spLocks noGrp=\"1\" noRot=\"1\" noChangeAspect=\"1\"/>"
        "</p:cNvSpPr><p:nvPr><p:ph type=\"sldImg\" idx=\"2\"/></p:nvPr></p:nvSpPr><p:spPr><a:xfrm>"
        "<a:off x=\"685800\" y=\"1143000\"/><a:ext cx=\"5486400\" cy=\"3086100\"/></a:xfrm>"
        "<a:prstGeom prst=\"rect\"><a:avLst/></a:prstGeom></p:spPr></p:sp>{}</p:spTree></p:cSld>"
        "<p:clrMap {}/></p:notesMaster>",
        kPptxSpaces, kTree,
        placeholder(3, "Notes", "type=\"body\" idx=\"1\"",
                    "<a:off x=\"685800\" y=\"4400550\"/><a:ext cx=\"5486400\" cy=\"3600450\"/>",
                    kSomeText),
        kColors);
}

/// The slides' relationships come first, then master, notes master and theme.
std::string presentationXml(std::size_t slides) {
    std::string list;
    for (std::size_t i = 1; i <= slides; ++i)
        list += fmt::format("<p:sldId id=\"{}\" r:id=\"rId{}\"/>", 255 + i, i);
    return fmt::format(
        "<p:presentation {} saveSubsetFonts=\"1\"><p:sldMasterIdLst><p:sldMasterId "
        "id=\"2147483648\" r:id=\"rId{}\"/></p:sldMasterIdLst><p:notesMasterIdLst><p:notesMasterId "
        "r:id=\"rId{}\"/></p:notesMasterIdLst><p:sldIdLst>{}</p:sldIdLst><p:sldSz cx=\"12192000\" "
        "cy=\"6858000\"/><p:notesSz cx=\"6858000\" cy=\"9144000\"/></p:presentation>",
        kPptxSpaces, slides + 1, slides + 2, list);
}

void addProperties(const Deck& deck, PptxPackage& package) {
    package.add("docProps/app.xml",
                "<Properties xmlns=\"http://schemas.openxmlformats.org/officeDocument/2006/"
                "extended-properties\"><Application>impulse</Application></Properties>",
                "application/vnd.openxmlformats-officedocument.extended-properties+xml");
    package.add(
        "docProps/core.xml",
        fmt::format("<cp:coreProperties xmlns:cp=\"http://schemas.openxmlformats.org/package/2006/"
                    "metadata/core-properties\" xmlns:dc=\"http://purl.org/dc/elements/1.1/\">"
                    "<dc:title>{}</dc:title><dc:creator>{}</dc:creator></cp:coreProperties>",
                    xmlText(titleTextOf(deck.title)), xmlText(deck.author)),
        "application/vnd.openxmlformats-package.core-properties+xml");
}

}  // namespace

void addPptxParts(const Deck& deck, std::size_t slides, PptxPackage& package) {
    addProperties(deck, package);
    PptxRelations presentation, master, layout, notes;
    for (std::size_t i = 1; i <= slides; ++i)
        presentation.add("slide", fmt::format("slides/slide{}.xml", i));
    presentation.add("slideMaster", "slideMasters/slideMaster1.xml");
    presentation.add("notesMaster", "notesMasters/notesMaster1.xml");
    presentation.add("theme", "theme/theme1.xml");
    package.add("ppt/presentation.xml", presentationXml(slides), "presentation.main", presentation);
    master.add("slideLayout", "../slideLayouts/slideLayout1.xml");
    master.add("slideLayout", "../slideLayouts/slideLayout2.xml");
    master.add("theme", "../theme/theme1.xml");
    package.add("ppt/slideMasters/slideMaster1.xml", masterXml(), "slideMaster", master);
    layout.add("slideMaster", "../slideMasters/slideMaster1.xml");
    package.add("ppt/slideLayouts/slideLayout1.xml",
                layoutXml("Title only", "titleOnly",
                          placeholder(2, "Title", "type=\"title\"", kTitlePlace, kSomeText) +
                              slideNumber(slides)),
                "slideLayout", layout);
    package.add("ppt/slideLayouts/slideLayout2.xml",
                layoutXml("Opening", "title",
                          placeholder(2, "Title", "type=\"ctrTitle\"", kOpeningPlace, kSomeText)),
                "slideLayout", layout);
    notes.add("theme", "../theme/theme2.xml");  // a master has a theme of its own
    package.add("ppt/notesMasters/notesMaster1.xml", notesMasterXml(), "notesMaster", notes);
    constexpr const char* kThemeType = "application/vnd.openxmlformats-officedocument.theme+xml";
    package.add("ppt/theme/theme1.xml", themeXml(deck.theme), kThemeType);
    package.add("ppt/theme/theme2.xml", themeXml("print"), kThemeType);
}

}  // namespace demos
