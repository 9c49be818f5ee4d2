#include "demos/text/nearest.h"

#include <algorithm>
#include <cstdlib>

#include "demos/text/synonyms.h"

namespace demos {

int editDistance(std::string_view a, std::string_view b, int most) {
    const int rows = static_cast<int>(a.size()) + 1, columns = static_cast<int>(b.size()) + 1;
    if (std::abs(rows - columns) >= most) return most;
    std::vector<int> d(static_cast<std::size_t>(rows) * columns, most);
    // d(i, j): from the first i letters of a to j of b. It is `most` far from the diagonal.
    const auto at = [&](int i, int j) -> int& {
        return d[static_cast<std::size_t>(i) * columns + j];
    };
    for (int i = 0; i < rows; ++i) at(i, 0) = i;
    for (int j = 0; j < columns; ++j) at(0, j) = j;
    for (int i = 1; i < rows; ++i)
        for (int j = std::max(1, i - most); j < std::min<long>(columns, long{i} + most); ++j) {
            const int changed = a[i - 1] == b[j - 1] ? 0 : 1;
            at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, at(i - 1, j - 1) + changed});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
        }
    return std::min(at(rows - 1, columns - 1), most);
}

std::string nearest(std::string_view word, std::span<const std::string> names) {
    constexpr std::size_t kLongest = 64;  // no name is longer
    if (word.size() > kLongest + 2) return {};
    if (std::string name = sameMeaning(word, names); !name.empty()) return name;
    // Two edits of four letters make any word: 'ball' would be near 'hull'. Fewer edits than
    // letters: otherwise any letter would be near a name of one letter.
    int best = std::min(word.size() <= 4 ? 2 : 3, static_cast<int>(word.size()));
    std::string name;
    for (const std::string& candidate : names) {
        const int distance = editDistance(word, candidate, best);
        if (distance < best) best = distance, name = candidate;
    }
    constexpr std::size_t kBeginning = 3;
    if (name.empty() && word.size() >= kBeginning)
        for (const std::string& candidate : names)
            if (candidate.starts_with(word)) return candidate;
    return name;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& names) {
    const std::string close = nearest(word, names);
    if (!close.empty()) return "; did you mean '" + close + "'?";
    if (names.empty()) return "";
    constexpr std::size_t kMost = 12;
    std::string list;
    for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i)
        list += (i == 0 ? "" : ", ") + names[i];
    return "; known are: " + list + (names.size() > kMost ? " ..." : "");
}

}  // namespace demos
