/// The project's texts for readers and their pictures, embedded by embed_documents.cmake.
#pragma once
#include <span>
#include <string_view>

namespace demos {

struct SiteDocument {
    std::string_view path;  // in the sources: "demos/scenes/recipes.md"
    std::string_view text;  // CommonMark with tables; a picture's bytes if the path ends in .png
};

/// Sorted by path.
std::span<const SiteDocument> documents();

/// Null if there is none.
inline const SiteDocument* documentAt(std::string_view path) {
    for (const SiteDocument& document : documents())
        if (document.path == path) return &document;
    return nullptr;
}

}  // namespace demos
