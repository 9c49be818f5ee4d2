/// index.html of a gallery: its scenes by group, with posters, films, commands and a search.
#pragma once
#include <string>
#include <vector>

#include "demos/gallery/gallery_card.h"
#include "demos/gallery/gallery_options.h"

namespace demos {

/// Options that the commands of a card repeat, one word each.
struct GalleryWords {
    std::vector<std::string> run;      // what is simulated
    std::vector<std::string> picture;  // how it is drawn
};
GalleryWords wordsOf(const GalleryOptions& options);

/// Links go to NAME.png and NAME.mp4 next to it; it loads nothing else. `renderer`: as OpenGL names
/// it. Leaves out the command that made it: a page may be public, its folders are not.
std::string galleryPage(const std::vector<GalleryCard>& cards, const std::string& renderer,
                        const GalleryWords& words, const std::vector<GalleryLink>& links = {});

}  // namespace demos
