#include "demos/slides/markup_tree.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <string_view>

namespace demos {
namespace {

// While cmark reads, formula 12 is U+E000 12 U+E001: private letters without a meaning to cmark.
constexpr std::string_view kMarkBegin = "\xee\x80\x80", kMarkEnd = "\xee\x80\x81";
constexpr std::string_view kUnknown = "\xef\xbf\xbd";  // U+FFFD, cmark's letter for invalid bytes

/// A formula's mark in a text: from `begin` to `end`.
struct Mark {
    std::size_t begin, end, number;
};

class Marks {
public:
    Marks(std::string text, Words words) : words_(words) {
        for (const std::string_view mark : {kMarkBegin, kMarkEnd})
            for (std::size_t i = 0; (i = text.find(mark, i)) != std::string::npos;)
                text.replace(i, mark.size(), kUnknown);
        if (words == Words::line)
            std::replace_if(
                text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
        formulas_ = formulasIn(text);
        source_ = std::move(text);
    }

    /// A point at the beginning keeps a line from being a heading or a list.
    std::string marked() const {
        std::string text = words_ == Words::line ? "." : "";
        std::size_t done = 0;
        for (std::size_t i = 0; i < formulas_.size(); ++i) {
            text += source_.substr(done, formulas_[i].begin - done);
            text += std::string(kMarkBegin) + std::to_string(i) + std::string(kMarkEnd);
            done = formulas_[i].end;
        }
        return text + source_.substr(done);
    }

    /// Also finds marks that a text spells as &#xE000; those without a formula stay as they are.
    std::vector<Mark> in(std::string_view text) const {
        std::vector<Mark> marks;
        for (std::size_t i = 0; (i = text.find(kMarkBegin, i)) != std::string_view::npos;) {
            Mark mark{i, 0, 0};
            i += kMarkBegin.size();
            const char* end = text.data() + text.size();
            const char* after = std::from_chars(text.data() + i, end, mark.number).ptr;
            mark.end = static_cast<std::size_t>(after - text.data()) + kMarkEnd.size();
            const bool good = after != text.data() + i && mark.number < formulas_.size() &&
                              text.substr(mark.end - kMarkEnd.size()).starts_with(kMarkEnd);
            if (!good) continue;
            marks.push_back(mark);
            i = mark.end;
        }
        return marks;
    }

    /// The text with its formulas and their dollars again, for code.
    std::string restored(std::string_view text) const {
        std::string result;
        std::size_t done = 0;
        for (const Mark& mark : in(text)) {
            const TextFormula& formula = formulas_[mark.number];
            result += text.substr(done, mark.begin - done);
            result += source_.substr(formula.begin, formula.end - formula.begin);
            done = mark.end;
        }
        return result += text.substr(done);
    }

    TextFormula formula(std::size_t number) const {
        TextFormula formula = formulas_[number];
        formula.display = formula.display && words_ == Words::blocks;
        return formula;
    }

private:
    Words words_;
    std::string source_;
    std::vector<TextFormula> formulas_;
};

std::string_view literalOf(cmark_node* node) {
    const char* literal = cmark_node_get_literal(node);
    return literal ? literal : "";
}

void putFormulas(cmark_node* node, const Marks& marks, const FormulaText& show) {
    const std::string text(literalOf(node));
    const std::vector<Mark> found = marks.in(text);
    if (found.empty()) return;
    std::size_t done = 0;
    for (const Mark& mark : found) {
        const std::string shown = show(marks.formula(mark.number));
        cmark_node_insert_before(node, textNode(text.substr(done, mark.begin - done)));
        cmark_node* formula = cmark_node_new(CMARK_NODE_CUSTOM_INLINE);
        cmark_node_set_on_enter(formula, shown.c_str());
        cmark_node_insert_before(node, formula);
        done = mark.end;
    }
    cmark_node_set_literal(node, text.substr(done).c_str());
}

bool leadsOut(std::string_view url) {
    constexpr std::string_view kStarts[] = {"http://", "https://", "mailto:"};
    return std::any_of(std::begin(kStarts), std::end(kStarts),
                       [&](std::string_view start) { return url.starts_with(start); });
}

void putHtmlBlock(cmark_node* node, const Marks& marks) {
    std::string text = marks.restored(literalOf(node));
    while (text.ends_with('\n')) text.pop_back();
    cmark_node* paragraph = cmark_node_new(CMARK_NODE_PARAGRAPH);
    cmark_node_append_child(paragraph, textNode(text));
    replaceNode(node, paragraph);
}

void clean(cmark_node* node, const Marks& marks, const FormulaText& show) {
    switch (cmark_node_get_type(node)) {
        case CMARK_NODE_TEXT:
            return putFormulas(node, marks, show);
        case CMARK_NODE_CODE:
        case CMARK_NODE_CODE_BLOCK:
            cmark_node_set_literal(node, marks.restored(literalOf(node)).c_str());
            return;
        case CMARK_NODE_HTML_INLINE:
            return replaceNode(node, textNode(marks.restored(literalOf(node))));
        case CMARK_NODE_HTML_BLOCK:
            return putHtmlBlock(node, marks);
        case CMARK_NODE_IMAGE:
            return unwrapNode(node);
        case CMARK_NODE_LINK:
            if (!leadsOut(cmark_node_get_url(node))) return unwrapNode(node);
            cmark_node_set_url(node, marks.restored(cmark_node_get_url(node)).c_str());
            cmark_node_set_title(node, "");
            return;
        default:
            return;
    }
}

/// Removes the point that Marks::marked() put before a line.
void dropPoint(cmark_node* root) {
    cmark_node* first = cmark_node_first_child(cmark_node_first_child(root));
    cmark_node_set_literal(first, std::string(literalOf(first).substr(1)).c_str());
}

}  // namespace

std::vector<cmark_node*> nodesOf(cmark_node* root) {
    std::vector<cmark_node*> nodes;
    cmark_iter* iterator = cmark_iter_new(root);
    for (cmark_event_type event; (event = cmark_iter_next(iterator)) != CMARK_EVENT_DONE;)
        if (event == CMARK_EVENT_ENTER) nodes.push_back(cmark_iter_get_node(iterator));
    cmark_iter_free(iterator);
    return nodes;
}

cmark_node* textNode(const std::string& text) {
    cmark_node* node = cmark_node_new(CMARK_NODE_TEXT);
    cmark_node_set_literal(node, text.c_str());
    return node;
}

void replaceNode(cmark_node* old, cmark_node* node) {
    cmark_node_replace(old, node);
    cmark_node_free(old);
}

void unwrapNode(cmark_node* node) {
    while (cmark_node* child = cmark_node_first_child(node)) cmark_node_insert_before(node, child);
    cmark_node_free(node);
}

MarkupTree markupTree(const std::string& commonMark, Words words, const FormulaText& show) {
    const Marks marks(commonMark, words);
    const std::string text = marks.marked();
    MarkupTree tree(cmark_parse_document(text.data(), text.size(),
                                         CMARK_OPT_VALIDATE_UTF8 | CMARK_OPT_SMART));
    cmark_consolidate_text_nodes(tree.get());
    if (words == Words::line) dropPoint(tree.get());
    for (cmark_node* node : nodesOf(tree.get())) clean(node, marks, show);
    return tree;
}

}  // namespace demos
