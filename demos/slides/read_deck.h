/// From a deck file's text to a Deck. Strict, as scene files are: what is not understood, and what
/// names a scene, section, body or key that is not there, is an error with its place.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "demos/scene/catalog.h"
#include "demos/scene/reader.h"
#include "demos/slides/deck.h"

namespace demos {

/// Whether the word is a path to a TOML file with [[slide]] in it, or one that looks like a deck
/// but for that; false for scenes' names and whatever cannot be read.
bool isDeckFile(const std::string& nameOrPath);

/// Throws SceneError with every complaint as `file:line:column: what`.
Deck readDeck(std::string_view text, const std::filesystem::path& file);
Deck loadDeck(const std::filesystem::path& file);

/// What the reader asks of which table while it reads such a text, whatever is wrong with it.
Catalog catalogDeck(std::string_view text);

}  // namespace demos
