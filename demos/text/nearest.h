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

/// The name with the same letters or meaning (synonyms.h), or else the first of those closest to
/// `word` within two edits (one for words of two to four letters, none for one letter), or else the
/// first that begins with a word of three letters or more; empty if there is none.
std::string nearest(std::string_view word, std::span<const std::string> names);

/// "; did you mean 'hz'?", or "; known are: gravity, hz, seed" (the first dozen).
std::string suggestion(std::string_view word, const std::vector<std::string>& names);

}  // namespace demos
