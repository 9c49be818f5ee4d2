#include "demos/text/nearest.h"

#include <algorithm>

namespace demos {

int editDistance(std::string_view a, std::string_view b) {
    const std::size_t rows = a.size() + 1, columns = b.size() + 1;
    std::vector<int> d(rows * columns);  // d(i, j): from the first i letters of a to j of b
    const auto at = [&](std::size_t i, std::size_t j) -> int& { return d[i * columns + j]; };
    for (std::size_t i = 0; i < rows; ++i) at(i, 0) = static_cast<int>(i);
    for (std::size_t j = 0; j < columns; ++j) at(0, j) = static_cast<int>(j);
    for (std::size_t i = 1; i < rows; ++i)
        for (std::size_t j = 1; j < columns; ++j) {
            const int changed = a[i - 1] == b[j - 1] ? 0 : 1;
            at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, at(i - 1, j - 1) + changed});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
        }
    return at(rows - 1, columns - 1);
}

std::string nearest(std::string_view word, std::span<const std::string> names) {
    constexpr std::size_t kLongest = 64;  // no name is longer
    if (word.size() > kLongest + 2) return {};
    // Fewer edits than letters: otherwise any letter would be near a name of one letter.
    int best = std::min(word.size() <= 3 ? 2 : 3, static_cast<int>(word.size()));
    std::string name;
    for (const std::string& candidate : names) {
        const int distance = editDistance(word, candidate);
        if (distance < best) best = distance, name = candidate;
    }
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
