/// GitHub's tables in a Markdown text, which CommonMark does not have.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace demos {

/// Whole lines of a text.
struct MarkdownPiece {
    bool table = false;  // else CommonMark
    std::string text;
};

/// All pieces together are the text.
std::vector<MarkdownPiece> markdownPieces(std::string_view markdown);

struct MarkdownTable {
    std::vector<std::string> head;  // cells, CommonMark of one line
    std::vector<std::vector<std::string>> rows;
    std::vector<bool> right;  // by column: aligned at the right
};

/// `text`: of a piece that is a table.
MarkdownTable markdownTable(std::string_view text);

}  // namespace demos
