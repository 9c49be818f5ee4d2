/// A slide's words as libcmark's tree, with its formulas and nothing that a page should not have:
/// raw HTML is text, links lead to the web or to mail, pictures are replaced by their descriptions.
#pragma once
#include <cmark.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "demos/formulas/text_formulas.h"

namespace demos {

struct FreeNode {
    void operator()(cmark_node* node) const { cmark_node_free(node); }
};
using MarkupTree = std::unique_ptr<cmark_node, FreeNode>;

/// Returns a formula as it goes verbatim into the output.
using FormulaText = std::function<std::string(const TextFormula&)>;

enum class Words {
    blocks,  // paragraphs, lists, ...
    line     // one paragraph, even if it begins like another block
};

MarkupTree markupTree(const std::string& commonMark, Words words, const FormulaText& show);

/// All nodes, each once, parents before children.
std::vector<cmark_node*> nodesOf(cmark_node* root);

/// A new detached node with this text.
cmark_node* textNode(const std::string& text);

/// Replaces `old` by `node` and frees `old` with its children.
void replaceNode(cmark_node* old, cmark_node* node);

/// Replaces the node by its children, and frees it.
void unwrapNode(cmark_node* node);

}  // namespace demos
