/// Pages in a single file: the html, style and scripts of a folder page/ are built in
/// (embed_page.cmake), and the data are inserted.
#pragma once
#include <string>

namespace demos {

struct PageText {
    std::string before, after;  // what comes before and after the data
};
PageText reportPageText();   // demos/regression/page
PageText replayPageText();   // demos/export/page
PageText galleryPageText();  // demos/gallery/page
PageText slidesPageText();   // demos/slides/page
PageText sitePageText();     // demos/site/page

}  // namespace demos
