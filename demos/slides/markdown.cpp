// Words of a slide as Markdown for Marp: CommonMark again, from the cleaned tree, which has no raw
// HTML, no external pictures and nothing that begins a slide.

#include <cstdlib>
#include <memory>
#include <string_view>

#include "demos/slides/markup.h"
#include "demos/slides/markup_tree.h"

namespace demos {
namespace {

/// Marp's markup in addition to CommonMark: formulas, tables, struck-out words.
constexpr std::string_view kMarksOfMarp = "$|~";

cmark_node* verbatimNode(const std::string& markdown) {
    cmark_node* node = cmark_node_new(CMARK_NODE_CUSTOM_INLINE);
    cmark_node_set_on_enter(node, markdown.c_str());
    return node;
}

/// cmark escapes only CommonMark's own markup.
void escapeMarpsMarks(cmark_node* node) {
    const std::string text = cmark_node_get_literal(node);
    std::size_t done = 0;
    for (std::size_t at; (at = text.find_first_of(kMarksOfMarp, done)) != std::string::npos;
         done = at + 1) {
        cmark_node_insert_before(node, textNode(text.substr(done, at - done)));
        cmark_node_insert_before(node, verbatimNode(std::string("\\") + text[at]));
    }
    cmark_node_set_literal(node, text.substr(done).c_str());
}

bool isNothing(cmark_node* node) {
    return cmark_node_get_type(node) == CMARK_NODE_TEXT && !*cmark_node_get_literal(node);
}

/// Marp needs a display formula at the beginning of a line.
void putOnItsOwnLine(cmark_node* formula) {
    std::string text = cmark_node_get_on_enter(formula);
    if (!text.starts_with("$$")) return;
    cmark_node* before = cmark_node_previous(formula);
    while (before && isNothing(before)) before = cmark_node_previous(before);
    cmark_node* after = cmark_node_next(formula);
    while (after && isNothing(after)) after = cmark_node_next(after);
    text = (before ? "\n" : "") + text + (after ? "\n" : "");
    cmark_node_set_on_enter(formula, text.c_str());
}

/// Two adjacent lists would become one. cmark separates them by a comment, which Marp takes for
/// speaker's notes; an unused link definition separates them as well.
void partFromNext(cmark_node* list) {
    cmark_node* next = cmark_node_next(list);
    if (!next) return;
    const cmark_node_type type = cmark_node_get_type(next);
    if (type != CMARK_NODE_LIST && type != CMARK_NODE_CODE_BLOCK) return;
    cmark_node* block = cmark_node_new(CMARK_NODE_CUSTOM_BLOCK);
    cmark_node_set_on_enter(block, "[//]: #");
    cmark_node_insert_after(list, block);
}

MarkupTree treeOf(const std::string& commonMark, Words words) {
    MarkupTree tree = markupTree(commonMark, words, [](const TextFormula& formula) {
        const std::string dollars = formula.display ? "$$" : "$";
        return dollars + formula.tex + dollars;
    });
    // A rule would begin the next slide.
    for (cmark_node* node : nodesOf(tree.get()))
        if (cmark_node_get_type(node) == CMARK_NODE_THEMATIC_BREAK) cmark_node_free(node);
    for (cmark_node* node : nodesOf(tree.get())) {
        const cmark_node_type type = cmark_node_get_type(node);
        if (type == CMARK_NODE_CUSTOM_INLINE) putOnItsOwnLine(node);
        if (type == CMARK_NODE_TEXT) escapeMarpsMarks(node);
        if (type == CMARK_NODE_LIST) partFromNext(node);
    }
    return tree;
}

/// Writes each paragraph as one line, since Marp keeps line ends.
std::string commonMarkFrom(cmark_node* root) {
    const std::unique_ptr<char, decltype(&std::free)> text(
        cmark_render_commonmark(root, CMARK_OPT_NOBREAKS, 0), std::free);
    std::string result = text.get();
    while (result.ends_with('\n')) result.pop_back();
    return result;
}

constexpr std::string_view kItemMark = "\xee\x80\x82";  // U+E002, a private letter

/// Marp shows items one by one in lists with "1)", and with "*", which cmark does not write: the
/// words of their items get a mark.
void markItems(cmark_node* root) {
    for (cmark_node* node : nodesOf(root)) {
        if (cmark_node_get_type(node) != CMARK_NODE_LIST) continue;
        cmark_node_set_list_delim(node, CMARK_PAREN_DELIM);
        if (cmark_node_get_list_type(node) != CMARK_BULLET_LIST) continue;
        for (cmark_node* item = cmark_node_first_child(node); item; item = cmark_node_next(item)) {
            cmark_node* words = cmark_node_first_child(item);
            if (words && cmark_node_get_type(words) == CMARK_NODE_PARAGRAPH)
                cmark_node_prepend_child(words, verbatimNode(std::string(kItemMark)));
        }
    }
}

}  // namespace

std::string markdownStepsOf(const std::string& commonMark) {
    const MarkupTree tree = treeOf(commonMark, Words::blocks);
    markItems(tree.get());
    std::string text = commonMarkFrom(tree.get());
    const std::string bullet = "- " + std::string(kItemMark);
    for (std::size_t at = 0; (at = text.find(bullet, at)) != std::string::npos;)
        text.replace(at, bullet.size(), "* ");
    return text;
}

std::string markdownOf(const std::string& commonMark) {
    return commonMarkFrom(treeOf(commonMark, Words::blocks).get());
}

std::string markdownInlineOf(const std::string& commonMark) {
    return commonMarkFrom(treeOf(commonMark, Words::line).get());
}

std::string markdownEscaped(const std::string& text) {
    const MarkupTree document(cmark_node_new(CMARK_NODE_DOCUMENT));
    cmark_node* paragraph = cmark_node_new(CMARK_NODE_PARAGRAPH);
    cmark_node_append_child(document.get(), paragraph);
    cmark_node* node = textNode(text);
    cmark_node_append_child(paragraph, node);
    escapeMarpsMarks(node);
    return commonMarkFrom(document.get());
}

}  // namespace demos
