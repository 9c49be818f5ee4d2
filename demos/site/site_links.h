/// Where links between the project's texts lead on the site.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "demos/site/document_html.h"
#include "demos/site/site_pages.h"

namespace demos {

/// The links of the text that `page` shows. `scenes`: names of those in the gallery.
DocumentLinks linksOf(const SitePage& page, const std::vector<std::string>& scenes);

/// "../scene/README.md#values" in "demos/scenes/recipes.md" -> "demos/scene/README.md"
std::string pathFrom(const std::string& source, const std::string& url);

}  // namespace demos
