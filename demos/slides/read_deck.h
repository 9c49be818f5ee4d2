/// Reads a deck file's text into a Deck. It is as strict as for scene files: unknown keys, and
/// names of scenes, sections or bodies that do not exist, are errors with their positions.
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "demos/scene/catalog.h"
#include "demos/scene/reader.h"
#include "demos/slides/deck.h"

namespace demos {

inline constexpr std::size_t kMostSlides = 200;
inline constexpr std::ptrdiff_t kMostDollars = 4000;  // around 2000 formulas: a millisecond each

/// Whether the word is a path to a TOML file that has [[slide]] or otherwise looks like a deck;
/// false for names of scenes and for files that cannot be read.
bool isDeckFile(const std::string& nameOrPath);

/// Throws SceneError with every complaint as `file:line:column: what`.
Deck readDeck(std::string_view text, const std::filesystem::path& file);
Deck loadDeck(const std::filesystem::path& file);

/// The keys that the reader looks up in each table while it reads such a text, even an invalid one.
Catalog catalogDeck(std::string_view text);

}  // namespace demos
