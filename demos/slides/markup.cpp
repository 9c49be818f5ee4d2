#include "demos/slides/markup.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <utility>

#include "demos/slides/markup_tree.h"

namespace demos {
namespace {

/// The byte after the tag that begins at `at`; a quoted value may contain a '>'.
std::size_t afterTag(const std::string& xml, std::size_t at) {
    bool quoted = false;
    for (; at < xml.size() && (quoted || xml[at] != '>'); ++at) quoted = quoted != (xml[at] == '"');
    return std::min(at + 1, xml.size());
}

/// Browsers break a line between a formula and the full stop after it; in these spans they do not.
std::string withPunctuation(std::string html) {
    const std::string last = "</math>";
    for (std::size_t at = 0; (at = html.find(last, at)) != std::string::npos;) {
        std::size_t end = at + last.size(), begin = html.rfind("<math", at);
        at = end;
        const std::string tag = html.substr(begin, afterTag(html, begin) - begin);
        if (tag.find("display=\"block\"") != std::string::npos) continue;
        end = std::min(html.find_first_not_of(".,;:!?)", end), html.size());
        if (begin > 0 && html[begin - 1] == '(') --begin;
        else if (end == at) continue;
        html.insert(end, "</span>");
        html.insert(begin, "<span class=\"kept\">");
        at = html.find("</span>", end);
    }
    return html;
}

std::string htmlFrom(const std::string& commonMark, Words words) {
    const MarkupTree tree = markupTree(commonMark, words, mathMlIn);
    const std::unique_ptr<char, decltype(&std::free)> html(
        cmark_render_html(tree.get(), CMARK_OPT_DEFAULT), std::free);
    return withPunctuation(html.get());
}

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(' ');
    if (first == std::string::npos) return "";
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// The text that a node adds to a line; blocks are separated by spaces.
std::string plainPart(cmark_node* node) {
    switch (cmark_node_get_type(node)) {
        case CMARK_NODE_TEXT:
        case CMARK_NODE_CODE:
        case CMARK_NODE_CODE_BLOCK:
            return cmark_node_get_literal(node);
        case CMARK_NODE_CUSTOM_INLINE:
            return cmark_node_get_on_enter(node);
        case CMARK_NODE_SOFTBREAK:
        case CMARK_NODE_LINEBREAK:
        case CMARK_NODE_PARAGRAPH:
        case CMARK_NODE_HEADING:
            return " ";
        default:
            return "";
    }
}

std::string unescaped(std::string text) {
    for (const auto& [entity, letter] : {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}})
        for (std::size_t at = 0; (at = text.find(entity, at)) != std::string::npos; ++at)
            text.replace(at, std::strlen(entity), letter);
    return text;
}

/// "\lambda \ge 0" as the letters it is drawn with; as LaTeX if they are not on one line.
std::string lettersOf(const TextFormula& formula) {
    const std::string mathMl = mathMlIn(formula);
    std::string letters;
    for (std::size_t at = 0; at < mathMl.size();) {
        const std::size_t tag = std::min(mathMl.find('<', at), mathMl.size());
        letters += mathMl.substr(at, tag - at);
        if (tag == mathMl.size()) break;
        at = afterTag(mathMl, tag);
        const std::size_t name = tag + (mathMl[tag + 1] == '/' ? 2 : 1);
        const std::string element = mathMl.substr(name, mathMl.find_first_of(" />", name) - name);
        if (element == "mspace") letters += ' ';
        const bool inLine = element == "math" || element == "mrow" || element == "mi" ||
                            element == "mo" || element == "mn" || element == "mtext" ||
                            element == "mspace" || element == "mstyle";
        if (!inLine) return formula.tex;
    }
    return unescaped(letters);
}

std::string lineOf(const std::string& commonMark, const FormulaText& show) {
    const MarkupTree tree = markupTree(commonMark, Words::blocks, show);
    std::string line;
    for (cmark_node* node : nodesOf(tree.get())) line += plainPart(node);
    std::string result;
    for (const char c : line) {
        const bool space = c == ' ' || c == '\n' || c == '\t' || c == '\r';
        if (!space) result += c;
        if (space && !result.empty() && result.back() != ' ') result += ' ';
    }
    return trimmed(result);
}

}  // namespace

std::string htmlOf(const std::string& commonMark) { return htmlFrom(commonMark, Words::blocks); }

std::string htmlInlineOf(const std::string& commonMark) {
    constexpr std::size_t kOpen = 3, kClose = 5;  // "<p>", "</p>\n"
    const std::string html = htmlFrom(commonMark, Words::line);
    return trimmed(html.substr(kOpen, html.size() - kOpen - kClose));
}

std::string plainOf(const std::string& commonMark) {
    return lineOf(commonMark, [](const TextFormula& formula) { return formula.tex; });
}

std::string titleTextOf(const std::string& commonMark) { return lineOf(commonMark, lettersOf); }

std::string commonMarkOf(const std::string& plain) {
    const MarkupTree document(cmark_node_new(CMARK_NODE_DOCUMENT));
    cmark_node* paragraph = cmark_node_new(CMARK_NODE_PARAGRAPH);
    cmark_node_append_child(document.get(), paragraph);
    cmark_node_append_child(paragraph, textNode(plain));
    const std::unique_ptr<char, decltype(&std::free)> text(
        cmark_render_commonmark(document.get(), CMARK_OPT_DEFAULT, 0), std::free);
    std::string result;
    char before = 0;
    bool escaped = false;
    for (const char* c = text.get(); *c; before = *c++) {
        const bool special = *c == '$' || *c == '@';
        const bool joined = (*c == '-' || *c == '.') && before == *c;  // a dash, an ellipsis
        if (!escaped && (special || joined)) result += '\\';
        result += *c;
        escaped = !escaped && *c == '\\';
    }
    while (result.ends_with('\n')) result.pop_back();
    return result;
}

std::string htmlEscaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '"')
            result += "&quot;";
        else if (c == '\'')
            result += "&#39;";
        else
            result += c;
    }
    return result;
}

}  // namespace demos
