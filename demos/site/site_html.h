/// A page of the site, and the index that its search reads.
#pragma once
#include <string>
#include <vector>

#include "demos/gallery/gallery_card.h"
#include "demos/site/document_html.h"
#include "demos/site/site_pages.h"

namespace demos {

/// The whole file. `page`: null for the first page of the site.
std::string sitePageHtml(const SitePage* page, const DocumentHtml& content);

/// The first page: what there is to read and some scenes to see.
DocumentHtml frontPage(const std::vector<GalleryCard>& scenes);

/// search.js: sections of all pages, for the search of each.
class SearchIndex {
public:
    void add(const SitePage& page, const DocumentHtml& content);
    void add(const GalleryCard& scene);
    std::string text() const;

private:
    std::vector<std::string> rows_;  // JSON
};

}  // namespace demos
