/// A slide's words as libcmark's tree, with its formulas in it and nothing that a page should not
/// have: raw HTML is text, links lead to the web or to a mailbox, pictures are their descriptions.
#pragma once
#include <cmark.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "demos/slides/text_formulas.h"

namespace demos {

struct FreeNode {
    void operator()(cmark_node* node) const { cmark_node_free(node); }
};
using MarkupTree = std::unique_ptr<cmark_node, FreeNode>;

/// A formula as it goes into the output, as it is.
using FormulaText = std::function<std::string(const TextFormula&)>;

enum class Words {
    blocks,  // paragraphs, lists, ...
    line     // one paragraph, whatever it begins with
};

MarkupTree markupTree(const std::string& commonMark, Words words, const FormulaText& show);

/// All nodes, each once, before those in it.
std::vector<cmark_node*> nodesOf(cmark_node* root);

/// A new node of its own with this text.
cmark_node* textNode(const std::string& text);

/// Puts `node` where `old` is, which is freed with all that is in it.
void replaceNode(cmark_node* old, cmark_node* node);

/// Puts what is in the node where it is, and frees it.
void unwrapNode(cmark_node* node);

}  // namespace demos
