#include "demos/slides/pptx_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <cmath>


#include "demos/formulas/formula_runs.h"
#include "demos/slides/markup.h"
#include "demos/slides/markup_tree.h"

namespace demos {
namespace {

constexpr double kPoint = 75.0;  // hundredths of a point in a px: 1280 px are 960 pt
constexpr double kEmu = 9525.0;  // of a px
constexpr double kBlockGap = 0.62, kItemGap = 0.42, kListIndent = 1.1;  // as the page's style

int hundredths(double px) { return static_cast<int>(std::lround(kPoint * px)); }

struct RunLook {
    bool bold = false, italic = false, code = false;
    int level = 0;
    std::string link;  // its relationship
};

std::string runXml(const std::string& text, const RunLook& run, const PptxLook& look) {
    if (text.empty()) return {};
    std::string xml = fmt::format("<a:r><a:rPr lang=\"en-GB\" sz=\"{}\"",
                                  hundredths((run.code ? 0.86 : 1.0) * look.size));
    if (run.bold || look.bold) xml += " b=\"1\"";
    if (run.italic) xml += " i=\"1\"";
    if (run.level != 0) xml += run.level > 0 ? " baseline=\"30000\"" : " baseline=\"-25000\"";
    xml += fmt::format(" dirty=\"0\"><a:solidFill><a:schemeClr val=\"{}\"/></a:solidFill>",
                       look.color);
    // Always named: Impress else keeps that of the run before.
    const char* face = run.code ? "Courier New" : "+mn-lt";
    xml += fmt::format("<a:latin typeface=\"{}\"/>", face);
    if (!run.link.empty()) xml += fmt::format("<a:hlinkClick r:id=\"{}\"/>", run.link);
    return xml + "</a:rPr><a:t>" + xmlText(text) + "</a:t></a:r>";
}

class ParagraphWriter {
public:
    ParagraphWriter(const PptxLook& look, const PptxLink& link) : look_(look), link_(link) {}

    std::vector<PptxParagraph> blockOf(cmark_node* block) {
        paragraphs_.clear();
        gap_ = kBlockGap;
        writeBlock(block, 0.0);
        return paragraphs_;
    }
    std::string runsOf(cmark_node* parent, const RunLook& run = {}) const {
        std::string runs;
        for (cmark_node* child = cmark_node_first_child(parent); child;
             child = cmark_node_next(child))
            runs += runsIn(child, run);
        return runs;
    }

private:
    void add(const std::string& runs, double indent) {
        paragraphs_.push_back({runs, gap_, indent, std::exchange(bullet_, "")});
        gap_ = kBlockGap;
    }

    void writeBlock(cmark_node* block, double indent) {
        switch (cmark_node_get_type(block)) {
            case CMARK_NODE_PARAGRAPH:
                return add(runsOf(block), indent);
            case CMARK_NODE_HEADING:
                return add(runsOf(block, {true, false, false, 0, ""}), indent);
            case CMARK_NODE_CODE_BLOCK:
                for (PptxParagraph& line : pptxCode(cmark_node_get_literal(block), look_)) {
                    add(line.runs, indent);
                    gap_ = 0.0;
                }
                gap_ = kBlockGap;
                return;
            case CMARK_NODE_LIST:
                return writeList(block, indent + kListIndent);
            case CMARK_NODE_BLOCK_QUOTE:
                return writeChildren(block, indent + 0.8);
            default:
                return writeChildren(block, indent);
        }
    }

    void writeChildren(cmark_node* block, double indent) {
        for (cmark_node* child = cmark_node_first_child(block); child;
             child = cmark_node_next(child))
            writeBlock(child, indent);
    }

    void writeList(cmark_node* list, double indent) {
        const bool numbered = cmark_node_get_list_type(list) == CMARK_ORDERED_LIST;
        int number = cmark_node_get_list_start(list);
        for (cmark_node* item = cmark_node_first_child(list); item; item = cmark_node_next(item)) {
            bullet_ = numbered ? fmt::format("<a:buAutoNum type=\"arabicPeriod\" startAt=\"{}\"/>",
                                             std::max(number, 1))
                               : "<a:buChar char=\"•\"/>";
            const bool first = item == cmark_node_first_child(list);
            if (!first || indent > kListIndent) gap_ = kItemGap;
            writeChildren(item, indent);
        }
    }

    std::string formulaXml(const std::string& mathMl, const RunLook& run) const {
        std::string xml;
        for (const FormulaRun& part : formulaRuns(mathMl)) {
            RunLook look = run;
            look.italic = part.italic;
            look.bold = run.bold || part.bold;
            look.level = part.level;
            xml += runXml(part.text, look, look_);
        }
        return xml;
    }

    std::string runsIn(cmark_node* node, RunLook run) const {
        switch (cmark_node_get_type(node)) {
            case CMARK_NODE_TEXT:
                return runXml(cmark_node_get_literal(node), run, look_);
            case CMARK_NODE_SOFTBREAK:
                return runXml(" ", run, look_);
            case CMARK_NODE_LINEBREAK:
                return "<a:br/>";
            case CMARK_NODE_CODE:
                run.code = true;
                return runXml(cmark_node_get_literal(node), run, look_);
            case CMARK_NODE_CUSTOM_INLINE:
                return formulaXml(cmark_node_get_on_enter(node), run);
            case CMARK_NODE_EMPH:
                run.italic = !run.italic;
                return runsOf(node, run);
            case CMARK_NODE_STRONG:
                run.bold = true;
                return runsOf(node, run);
            case CMARK_NODE_LINK:
                run.link = link_(cmark_node_get_url(node));
                return runsOf(node, run);
            default:
                return runsOf(node, run);
        }
    }

    const PptxLook& look_;
    const PptxLink& link_;
    std::vector<PptxParagraph> paragraphs_;
    double gap_ = kBlockGap;
    std::string bullet_;
};

std::string paragraphXml(const PptxParagraph& paragraph, const PptxLook& look, bool first) {
    const int indent = static_cast<int>(std::lround(kEmu * look.size * paragraph.indent));
    const int hang = paragraph.bullet.empty()
                         ? 0
                         : static_cast<int>(std::lround(kEmu * look.size * kListIndent));
    const std::string bullet =
        paragraph.bullet.empty()
            ? "<a:buNone/>"
            : "<a:buClr><a:schemeClr val=\"accent1\"/></a:buClr>" + paragraph.bullet;
    return fmt::format(
        "<a:p><a:pPr marL=\"{}\" indent=\"{}\" algn=\"{}\"><a:lnSpc><a:spcPts val=\"{}\"/>"
        "</a:lnSpc><a:spcBef><a:spcPts val=\"{}\"/></a:spcBef><a:spcAft><a:spcPts val=\"0\"/></a:spcAft>{}"
        "</a:pPr>{}</a:p>",
        indent, -hang, look.align, hundredths(look.line),
        first ? 0 : hundredths(paragraph.before * look.size), bullet, paragraph.runs);
}

}  // namespace

std::vector<std::vector<PptxParagraph>> pptxBlocks(const std::string& commonMark,
                                                   const PptxLook& look, const PptxLink& link) {
    const MarkupTree tree = markupTree(commonMark, Words::blocks, mathMlIn);
    ParagraphWriter writer(look, link);
    std::vector<std::vector<PptxParagraph>> blocks;
    for (cmark_node* block = cmark_node_first_child(tree.get()); block;
         block = cmark_node_next(block))
        blocks.push_back(writer.blockOf(block));
    return blocks;
}

PptxParagraph pptxLine(const std::string& commonMark, const PptxLook& look, const PptxLink& link) {
    const MarkupTree tree = markupTree(commonMark, Words::line, mathMlIn);
    const ParagraphWriter writer(look, link);
    return {writer.runsOf(cmark_node_first_child(tree.get())), 0.0, 0.0, ""};
}

PptxParagraph pptxPlainLine(const std::string& text, const PptxLook& look) {
    return {runXml(text, {}, look), 0.0, 0.0, ""};
}

std::vector<PptxParagraph> pptxCode(const std::string& code, const PptxLook& look) {
    std::vector<PptxParagraph> lines;
    std::string rest = code;
    while (rest.ends_with('\n')) rest.pop_back();
    RunLook mono;
    mono.code = true;
    PptxLook own = look;
    own.size /= 0.86;  // runXml() makes code smaller than the words around it
    for (std::size_t at = 0; at <= rest.size();) {
        const std::size_t end = std::min(rest.find('\n', at), rest.size());
        std::string line;
        for (const char c : rest.substr(at, end - at))
            line += c == '\t' ? std::string(4, ' ') : std::string(1, c);
        lines.push_back({runXml(line, mono, own), 0.0, 0.0, ""});
        at = end + 1;
    }
    return lines;
}

std::string pptxParagraphs(const std::vector<PptxParagraph>& paragraphs, const PptxLook& look) {
    std::string xml;
    for (std::size_t i = 0; i < paragraphs.size(); ++i)
        xml += paragraphXml(paragraphs[i], look, i == 0);
    return xml.empty() ? "<a:p/>" : xml;
}

std::string xmlText(const std::string& text) {
    std::string allowed;
    for (const char c : text) {
        const bool control = static_cast<unsigned char>(c) < 0x20;
        if (!control || c == '\t' || c == '\n') allowed += c;
    }
    return htmlEscaped(allowed);
}

}  // namespace demos
