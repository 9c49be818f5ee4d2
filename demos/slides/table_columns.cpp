#include "demos/slides/table_columns.h"

#include <algorithm>
#include <string_view>

namespace demos {
namespace {

constexpr std::size_t kLongestUnit = 8;  // bytes with its space of two bytes: " rad/s", " µm/s"
constexpr std::string_view kMinus = "\u2212", kTimes = "\u00a0\u00d7\u00a010";

enum class CellKind { number, words, nothing };

/// Removes the power of ten: "\u00a0\u00d7\u00a010\u207b\u2076".
void skipPower(std::string_view& rest) {
    if (!rest.starts_with(kTimes)) return;
    rest.remove_prefix(kTimes.size());
    while (!rest.empty() && !rest.starts_with("\u00a0")) rest.remove_prefix(1);
}

CellKind kindOf(const std::string& cell) {
    if (cell.empty() || cell == "-") return CellKind::nothing;
    std::string_view rest = cell;
    if (rest.starts_with(kMinus)) rest.remove_prefix(kMinus.size());
    rest.remove_prefix(std::min(rest.find_first_not_of("+-.<> "), rest.size()));
    if (rest.empty() || rest.front() < '0' || rest.front() > '9') return CellKind::words;
    rest.remove_prefix(std::min(rest.find_first_not_of("0123456789.eE+-"), rest.size()));
    skipPower(rest);
    return rest.size() <= kLongestUnit ? CellKind::number : CellKind::words;
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
