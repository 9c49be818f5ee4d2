/// The pages of the site: which text of the project each of them shows, and how they are grouped.
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace demos {

struct SitePage {
    const char* file;    // in the site's folder
    const char* source;  // of the text; "": made otherwise
    const char* group;   // in the list of pages
    const char* name;
    const char* purpose;  // one line
};

/// In the order of the list of pages.
std::span<const SitePage> sitePages();

/// Null if none shows this text.
const SitePage* pageShowing(std::string_view source);

inline constexpr const char* kGalleryFolder = "gallery";
inline constexpr const char* kGalleryPage = "gallery/index.html";
inline constexpr const char* kKeysPage = "keys.html";

}  // namespace demos
