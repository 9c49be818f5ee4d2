#include "demos/slides/pptx_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "demos/slides/table_columns.h"

namespace demos {
namespace {

long long emuOf(double px) { return std::llround(9525.0 * px); }

std::string placeXml(const SlideBox& box, const char* element = "a:xfrm") {
    return fmt::format("<{0}><a:off x=\"{1}\" y=\"{2}\"/><a:ext cx=\"{3}\" cy=\"{4}\"/></{0}>",
                       element, emuOf(box.x), emuOf(box.y), std::max(emuOf(box.width), 1ll),
                       std::max(emuOf(box.height), 1ll));
}

std::string fillXml(const PptxFill& fill) {
    const std::string alpha =
        fill.opacity < 1.0
            ? fmt::format("<a:alpha val=\"{}\"/>", std::lround(100000.0 * fill.opacity))
            : "";
    return fmt::format("<a:solidFill><a:schemeClr val=\"{}\">{}</a:schemeClr></a:solidFill>",
                       fill.color, alpha);
}

constexpr const char* kRectangle = "<a:prstGeom prst=\"rect\"><a:avLst/></a:prstGeom>";

/// `extra`: relationships of a film, if it is one.
std::string pictureXml(const std::string& named, const std::string& extra,
                       const std::string& picture, const SlideBox& box) {
    return fmt::format(
        "<p:pic><p:nvPicPr>{}<p:cNvPicPr><a:picLocks noChangeAspect=\"1\"/></p:cNvPicPr>"
        "<p:nvPr>{}</p:nvPr></p:nvPicPr><p:blipFill><a:blip r:embed=\"{}\"/>"
        "<a:stretch><a:fillRect/></a:stretch></p:blipFill><p:spPr>{}{}</p:spPr></p:pic>",
        named, extra, picture, placeXml(box), kRectangle);
}

/// `gap`: px on the right.
std::string cellXml(const std::string& text, const PptxLook& look, bool head, double gap) {
    const std::string line =
        fmt::format("<a:lnB w=\"{}\">{}</a:lnB>", head ? 19050 : 9525,
                    fillXml({head ? "tx2" : "bg2", 1.0}));
    return fmt::format(
        "<a:tc><a:txBody><a:bodyPr/><a:lstStyle/>{}</a:txBody><a:tcPr marL=\"0\" marR=\"{}\" "
        "marT=\"0\" marB=\"0\" anchor=\"ctr\"><a:lnL><a:noFill/></a:lnL><a:lnR><a:noFill/></a:lnR>"
        "<a:lnT><a:noFill/></a:lnT>{}<a:noFill/></a:tcPr></a:tc>",
        pptxParagraphs({pptxPlainLine(text, look)}, look), emuOf(gap), line);
}

std::string rowXml(const std::vector<std::string>& cells, const std::vector<bool>& numbers,
                   double height, double size, bool head) {
    std::string xml = fmt::format("<a:tr h=\"{}\">", emuOf(height));
    for (std::size_t i = 0; i < cells.size(); ++i) {
        PptxLook look{size, 1.2 * size};
        look.bold = head;
        look.color = head ? "tx2" : "tx1";
        look.align = i < numbers.size() && numbers[i] ? "r" : "l";
        xml += cellXml(cells[i], look, head, i + 1 < cells.size() ? 0.4 * size : 0.0);
    }
    return xml + "</a:tr>";
}

}  // namespace

std::string PptxShapes::named(const std::string& name, const std::string& says,
                              const char* inside) {
    const std::string description = says.empty() ? "" : " descr=\"" + xmlText(says) + "\"";
    return fmt::format("<p:cNvPr id=\"{}\" name=\"{}\"{}>{}</p:cNvPr>", next_++, xmlText(name),
                       description, inside);
}

void PptxShapes::addText(const std::string& name, const SlideBox& box,
                         const std::string& paragraphs, const std::string& placeholder) {
    const bool own = placeholder.empty();
    xml_ += fmt::format(
        "<p:sp><p:nvSpPr>{}{}<p:nvPr>{}</p:nvPr></p:nvSpPr><p:spPr>{}{}<a:noFill/></p:spPr>"
        "<p:txBody><a:bodyPr wrap=\"square\" lIns=\"0\" tIns=\"0\" rIns=\"0\" bIns=\"0\" "
        "anchor=\"t\"><a:noAutofit/></a:bodyPr><a:lstStyle/>{}</p:txBody></p:sp>",
        named(name, ""),
        own ? "<p:cNvSpPr txBox=\"1\"/>"
            : "<p:cNvSpPr><a:spLocks noGrp=\"1\"/></p:cNvSpPr>",
        own ? "" : "<p:ph type=\"" + placeholder + "\"/>", placeXml(box), kRectangle, paragraphs);
}

void PptxShapes::addRectangle(const SlideBox& box, const PptxFill& fill) {
    xml_ += fmt::format(
        "<p:sp><p:nvSpPr>{}<p:cNvSpPr/><p:nvPr/></p:nvSpPr><p:spPr>{}{}{}<a:ln><a:noFill/></a:ln>"
        "</p:spPr><p:txBody><a:bodyPr/><a:lstStyle/><a:p/></p:txBody></p:sp>",
        named("Ground", ""), placeXml(box), kRectangle, fillXml(fill));
}

void PptxShapes::addPicture(const std::string& name, const SlideBox& box,
                            const std::string& picture, const std::string& says) {
    xml_ += pictureXml(named(name, says), "", picture, box);
}

int PptxShapes::addFilm(const SlideBox& box, const std::string& poster, const std::string& film,
                        const std::string& media, const std::string& says) {
    const int shape = next_;
    const std::string extra = fmt::format(
        "<a:videoFile r:link=\"{}\"/><p:extLst><p:ext "
        "uri=\"{{DAA4B4D4-6D71-4841-9C94-3DE7FCFB9230}}\"><p14:media "
        "xmlns:p14=\"http://schemas.microsoft.com/office/powerpoint/2010/main\" r:embed=\"{}\"/>"
        "</p:ext></p:extLst>",
        film, media);
    xml_ += pictureXml(
        named("Film", says, "<a:hlinkClick r:id=\"\" action=\"ppaction://media\"/>"), extra, poster,
        box);
    return shape;
}

void PptxShapes::addTable(const MadeTable& table, const MeasuredTable& measured) {
    const std::vector<bool> numbers = numberColumns(table);
    const double size = measured.words.size;
    const auto height = [&](std::size_t row) {
        return row < measured.rows.size() ? measured.rows[row] : 1.8 * size;
    };
    std::string columns;
    for (const double width : measured.columns)
        columns += fmt::format("<a:gridCol w=\"{}\"/>", emuOf(width));
    std::string rows = rowXml(table.head, numbers, height(0), size, true);
    for (std::size_t i = 0; i < table.rows.size(); ++i)
        rows += rowXml(table.rows[i], numbers, height(i + 1), size, false);
    xml_ += fmt::format(
        "<p:graphicFrame><p:nvGraphicFramePr>{}<p:cNvGraphicFramePr><a:graphicFrameLocks "
        "noGrp=\"1\"/></p:cNvGraphicFramePr><p:nvPr/></p:nvGraphicFramePr>{}<a:graphic>"
        "<a:graphicData uri=\"http://schemas.openxmlformats.org/drawingml/2006/table\"><a:tbl>"
        "<a:tblPr firstRow=\"1\"/><a:tblGrid>{}</a:tblGrid>{}</a:tbl></a:graphicData></a:graphic>"
        "</p:graphicFrame>",
        named("Table", ""), placeXml(measured.words.box, "p:xfrm"), columns, rows);
}

std::string pptxFilmTiming(int shape, bool loop) {
    constexpr std::string_view kClick =
        "<p:cond evt=\"onClick\" delay=\"0\"><p:tgtEl><p:spTgt spid=\"{0}\"/></p:tgtEl></p:cond>";
    constexpr std::string_view kNow =
        "<p:stCondLst><p:cond delay=\"0\"/></p:stCondLst><p:childTnLst>";
    const std::string click = fmt::format(kClick, shape);
    return fmt::format(
        "<p:timing><p:tnLst><p:par><p:cTn id=\"1\" dur=\"indefinite\" restart=\"never\" "
        "nodeType=\"tmRoot\"><p:childTnLst><p:seq concurrent=\"1\" nextAc=\"seek\"><p:cTn id=\"2\" "
        "restart=\"whenNotActive\" fill=\"hold\" evtFilter=\"cancelBubble\" "
        "nodeType=\"interactiveSeq\"><p:stCondLst>{1}</p:stCondLst><p:endSync evt=\"end\" "
        "delay=\"0\"><p:rtn val=\"all\"/></p:endSync><p:childTnLst><p:par><p:cTn id=\"3\" "
        "fill=\"hold\">{2}<p:par><p:cTn id=\"4\" fill=\"hold\">{2}<p:par><p:cTn id=\"5\" "
        "presetID=\"2\" presetClass=\"mediacall\" presetSubtype=\"0\" fill=\"hold\" "
        "nodeType=\"clickEffect\">{2}<p:cmd type=\"call\" cmd=\"togglePause\"><p:cBhvr><p:cTn "
        "id=\"6\" dur=\"1\" fill=\"hold\"/><p:tgtEl><p:spTgt spid=\"{0}\"/></p:tgtEl></p:cBhvr>"
        "</p:cmd></p:childTnLst></p:cTn></p:par></p:childTnLst></p:cTn></p:par></p:childTnLst>"
        "</p:cTn></p:par></p:childTnLst></p:cTn><p:nextCondLst>{1}</p:nextCondLst></p:seq>"
        "<p:video><p:cMediaNode vol=\"80000\" mute=\"1\"><p:cTn id=\"7\"{3} fill=\"hold\" "
        "display=\"0\"><p:stCondLst><p:cond delay=\"indefinite\"/></p:stCondLst></p:cTn><p:tgtEl>"
        "<p:spTgt spid=\"{0}\"/></p:tgtEl></p:cMediaNode></p:video></p:childTnLst></p:cTn></p:par>"
        "</p:tnLst></p:timing>",
        shape, click, kNow, loop ? " repeatCount=\"indefinite\"" : "");
}

}  // namespace demos
