#include "demos/slides/markup.h"

#include <cstdlib>
#include <memory>

#include "demos/slides/markup_tree.h"

namespace demos {
namespace {

std::string htmlFrom(const std::string& commonMark, Words words) {
    const MarkupTree tree = markupTree(commonMark, words, mathMlIn);
    const std::unique_ptr<char, decltype(&std::free)> html(
        cmark_render_html(tree.get(), CMARK_OPT_DEFAULT), std::free);
    return html.get();
}

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(' ');
    if (first == std::string::npos) return "";
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// What a node adds to a line; blocks are parted by spaces.
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

}  // namespace

std::string htmlOf(const std::string& commonMark) { return htmlFrom(commonMark, Words::blocks); }

std::string htmlInlineOf(const std::string& commonMark) {
    constexpr std::size_t kOpen = 3, kClose = 5;  // "<p>", "</p>\n"
    const std::string html = htmlFrom(commonMark, Words::line);
    return trimmed(html.substr(kOpen, html.size() - kOpen - kClose));
}

std::string plainOf(const std::string& commonMark) {
    const MarkupTree tree = markupTree(commonMark, Words::blocks,
                                       [](const TextFormula& formula) { return formula.tex; });
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
