#include "demos/slides/table_columns.h"

#include <algorithm>

namespace demos {
namespace {

constexpr std::size_t kLongestUnit = 6;  // bytes with its space: " rad/s", " N s"

enum class CellKind { number, words, nothing };

CellKind kindOf(const std::string& cell) {
    if (cell.empty() || cell == "-") return CellKind::nothing;
    const std::size_t first = cell.find_first_not_of("+-.<> ");
    if (first == std::string::npos || cell[first] < '0' || cell[first] > '9')
        return CellKind::words;
    const std::size_t unit =
        std::min(cell.find_first_not_of("0123456789.eE+-", first), cell.size());
    return cell.size() - unit <= kLongestUnit ? CellKind::number : CellKind::words;
}

}  // namespace

std::vector<bool> numberColumns(const MadeTable& table) {
    std::vector<bool> numbers;
    for (std::size_t column = 0; column < table.head.size(); ++column) {
        bool some = false, none = true;
        for (const std::vector<std::string>& row : table.rows) {
            if (column >= row.size()) continue;
            const CellKind kind = kindOf(row[column]);
            some = some || kind == CellKind::number;
            none = none && kind != CellKind::words;
        }
        numbers.push_back(some && none);
    }
    return numbers;
}

}  // namespace demos
