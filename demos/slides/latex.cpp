// Words of a slide as LaTeX for a Beamer frame.

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "demos/slides/markup.h"
#include "demos/slides/markup_tree.h"

namespace demos {
namespace {

constexpr int kDeepestList = 3;   // Beamer's limit
constexpr int kDeepestQuote = 2;  // LaTeX has six levels for both

std::string rendered(cmark_node* root) {
    const std::unique_ptr<char, decltype(&std::free)> latex(
        cmark_render_latex(root, CMARK_OPT_DEFAULT, 0), std::free);
    return latex.get();
}

std::string withoutLastNewlines(std::string text) {
    while (text.ends_with('\n')) text.pop_back();
    return text;
}

/// Headings become bold lines, as a frame has no sections.
void putHeading(cmark_node* heading) {
    cmark_node* paragraph = cmark_node_new(CMARK_NODE_PARAGRAPH);
    cmark_node* strong = cmark_node_new(CMARK_NODE_STRONG);
    cmark_node_append_child(paragraph, strong);
    while (cmark_node* child = cmark_node_first_child(heading))
        cmark_node_append_child(strong, child);
    replaceNode(heading, paragraph);
}

/// Not verbatim, which needs a fragile frame and ends at an \end{verbatim} in the code.
void putCode(cmark_node* code) {
    cmark_node* block = cmark_node_new(CMARK_NODE_CUSTOM_BLOCK);
    cmark_node_set_on_enter(block, latexCodeOf(cmark_node_get_literal(code)).c_str());
    replaceNode(code, block);
}

/// cmark's own rule uses \\linethickness as a length, which it is not.
void putRule(cmark_node* rule) {
    cmark_node* block = cmark_node_new(CMARK_NODE_CUSTOM_BLOCK);
    cmark_node_set_on_enter(block, "\\begin{center}\\rule{0.5\\linewidth}{0.4pt}\\end{center}");
    replaceNode(rule, block);
}

/// Lists or quotes that are nested deeper than LaTeX allows.
std::vector<cmark_node*> tooDeep(cmark_node* root, cmark_node_type type, int deepest) {
    std::vector<cmark_node*> nodes;
    int depth = 0;
    cmark_iter* iterator = cmark_iter_new(root);
    for (cmark_event_type event; (event = cmark_iter_next(iterator)) != CMARK_EVENT_DONE;) {
        cmark_node* node = cmark_iter_get_node(iterator);
        if (cmark_node_get_type(node) != type) continue;
        depth += event == CMARK_EVENT_ENTER ? 1 : -1;
        if (event == CMARK_EVENT_ENTER && depth > deepest) nodes.push_back(node);
    }
    cmark_iter_free(iterator);
    return nodes;
}

void flatten(cmark_node* root) {
    for (cmark_node* quote : tooDeep(root, CMARK_NODE_BLOCK_QUOTE, kDeepestQuote))
        unwrapNode(quote);
    for (cmark_node* list : tooDeep(root, CMARK_NODE_LIST, kDeepestList)) {
        while (cmark_node* item = cmark_node_first_child(list)) {
            while (cmark_node* block = cmark_node_first_child(item))
                cmark_node_insert_before(list, block);
            cmark_node_free(item);
        }
        cmark_node_free(list);
    }
}

std::string withoutEmptyLines(const std::string& text) {
    std::string result;
    std::string_view rest = text;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view line = rest.substr(0, end);
        if (line.find_first_not_of(" \t\r") != std::string_view::npos)
            result += (result.empty() ? "" : "\n") + std::string(line);
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return result;
}

/// amsmath's align and similar environments need no \[ \]; KaTeX takes them in a display.
bool isOwnDisplay(std::string_view tex) {
    constexpr std::string_view kBegin = "\\begin{";
    tex.remove_prefix(std::min(tex.find_first_not_of(" \t\r\n"), tex.size()));
    if (!tex.starts_with(kBegin)) return false;
    std::string_view name = tex.substr(kBegin.size(), tex.find('}') - kBegin.size());
    if (name.ends_with('*')) name.remove_suffix(1);
    return name == "align" || name == "alignat" || name == "gather" || name == "equation";
}

std::string latexFrom(const std::string& commonMark, Words words) {
    const MarkupTree tree = markupTree(commonMark, words, [](const TextFormula& formula) {
        mathMlIn(formula);  // throws: a formula that KaTeX refuses would stop LaTeX
        return latexFormulaOf(formula.tex, formula.display);
    });
    flatten(tree.get());
    for (cmark_node* node : nodesOf(tree.get())) {
        const cmark_node_type type = cmark_node_get_type(node);
        if (type == CMARK_NODE_HEADING) putHeading(node);
        if (type == CMARK_NODE_CODE_BLOCK) putCode(node);
        if (type == CMARK_NODE_THEMATIC_BREAK) putRule(node);
    }
    return rendered(tree.get());
}

}  // namespace

std::string latexOf(const std::string& commonMark) { return latexFrom(commonMark, Words::blocks); }

std::string latexInlineOf(const std::string& commonMark) {
    return withoutLastNewlines(latexFrom(commonMark, Words::line));
}

std::string latexStepsOf(const std::string& commonMark) {
    std::string latex = latexOf(commonMark);
    for (const std::string_view list : {"\\begin{itemize}", "\\begin{enumerate}"})
        for (std::size_t at = 0; (at = latex.find(list, at)) != std::string::npos;) {
            at += list.size();
            latex.insert(at, "[<+(1)->]");  // from the second overlay on: the first shows no item
        }
    return latex;
}

std::string latexEscaped(const std::string& text) {
    const MarkupTree document(cmark_node_new(CMARK_NODE_DOCUMENT));
    cmark_node* paragraph = cmark_node_new(CMARK_NODE_PARAGRAPH);
    cmark_node_append_child(document.get(), paragraph);
    cmark_node_append_child(paragraph, textNode(text));
    return withoutLastNewlines(rendered(document.get()));
}

std::string latexCodeOf(const std::string& code) {
    std::string lines;
    std::string_view rest = code;
    while (rest.ends_with('\n')) rest.remove_suffix(1);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        std::string line;
        for (const char c : rest.substr(0, end)) line += c == '\t' ? "    " : std::string(1, c);
        const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
        line = latexEscaped(line.substr(indent));
        std::string kept;
        for (const char c : line) kept += c == ' ' ? "~" : std::string(1, c);
        // \mbox{}: a line may be empty, and a bracket after \\ would be its argument.
        lines += (lines.empty() ? "" : "\\\\\n") + std::string("\\mbox{}");
        for (std::size_t i = 0; i < indent; ++i) lines += '~';
        lines += kept;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return "\\begin{flushleft}\\ttfamily\n" + lines + "\n\\end{flushleft}";
}

std::string latexFormulaOf(const std::string& tex, bool display) {
    // An empty line would end the formula's paragraph; after a % the end would be a comment.
    std::string text = withoutEmptyLines(tex);
    if (text.find('%') != std::string::npos) text += '\n';
    if (!display) return "$" + text + "$";
    return isOwnDisplay(text) ? text : "\\[" + text + "\\]";
}

}  // namespace demos
