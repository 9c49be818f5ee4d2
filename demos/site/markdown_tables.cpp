#include "demos/site/markdown_tables.h"

#include <algorithm>

namespace demos {
namespace {

std::vector<std::string_view> linesOf(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1);
        lines.push_back(text.substr(0, end + 1));
        text.remove_prefix(end + 1);
    }
    return lines;
}

std::string_view withoutSpaces(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \n");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \n") - first + 1);
}

/// The cells of "| a | b \\| c |": "a", "b | c".
std::vector<std::string> cellsOf(std::string_view line) {
    line = withoutSpaces(line);
    if (line.starts_with('|')) line.remove_prefix(1);
    if (line.ends_with('|') && !line.ends_with("\\|")) line.remove_suffix(1);
    std::vector<std::string> cells(1);
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool escaped = line.substr(i).starts_with("\\|");
        if (line[i] == '|')
            cells.emplace_back();
        else
            cells.back() += escaped ? line[++i] : line[i];
    }
    for (std::string& cell : cells) cell = std::string(withoutSpaces(cell));
    return cells;
}

/// "|---|--:|"
bool isRule(std::string_view line) {
    line = withoutSpaces(line);
    return line.starts_with('|') && line.find('-') != std::string_view::npos &&
           line.find_first_not_of("|-: ") == std::string_view::npos;
}

}  // namespace

std::vector<MarkdownPiece> markdownPieces(std::string_view markdown) {
    const std::vector<std::string_view> lines = linesOf(markdown);
    std::vector<MarkdownPiece> pieces;
    bool fenced = false, table = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].starts_with("```")) fenced = !fenced;
        const bool row = lines[i].starts_with('|');
        table = !fenced && row && (table || (i + 1 < lines.size() && isRule(lines[i + 1])));
        if (pieces.empty() || pieces.back().table != table) pieces.push_back({table, ""});
        pieces.back().text += lines[i];
    }
    return pieces;
}

MarkdownTable markdownTable(std::string_view text) {
    const std::vector<std::string_view> lines = linesOf(text);
    MarkdownTable table;
    table.head = cellsOf(lines[0]);
    for (const std::string& cell : cellsOf(lines[1])) table.right.push_back(cell.ends_with(':'));
    for (std::size_t i = 2; i < lines.size(); ++i) {
        table.rows.push_back(cellsOf(lines[i]));
        table.rows.back().resize(table.head.size());
    }
    return table;
}

}  // namespace demos
