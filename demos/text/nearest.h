/// "Did you mean": the known name closest to a misspelt one.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace demos {

/// Insertions, deletions, substitutions and swaps of neighbours that lead from a to b
/// (Damerau-Levenshtein, each letter edited once); `most` if there are that many or more.
int editDistance(std::string_view a, std::string_view b, int most);

/// The first of the names closest to `word` within two edits (one for words of two or three
/// letters, none for one letter); empty if there is none.
std::string nearest(std::string_view word, std::span<const std::string> names);

/// "; did you mean 'hz'?", or "; known are: gravity, hz, seed" (the first dozen).
std::string suggestion(std::string_view word, const std::vector<std::string>& names);

}  // namespace demos
