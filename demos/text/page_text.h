/// Pages of one file: a folder page/ has the html, its style and its scripts, which are built in
/// (embed_page.cmake); a page's data come between.
#pragma once
#include <string>

namespace demos {

struct PageText {
    std::string before, after;  // the data
};
PageText reportPageText();   // demos/regression/page
PageText replayPageText();   // demos/export/page
PageText galleryPageText();  // demos/gallery/page
PageText slidesPageText();   // demos/slides/page

}  // namespace demos
