/// index.html of a gallery: its scenes by group, with posters, films, commands and a search.
#pragma once
#include <string>
#include <vector>

#include "demos/gallery/gallery_card.h"
#include "demos/gallery/gallery_options.h"

namespace demos {

/// Options that the commands of a card repeat, word by word.
struct GalleryWords {
    std::vector<std::string> run;      // of what is played
    std::vector<std::string> picture;  // of how it is drawn
};
GalleryWords wordsOf(const GalleryOptions& options);

/// Links go to NAME.png and NAME.mp4 beside it; nothing else is asked for. `renderer`: as OpenGL
/// names it. The command that made it is not told: a page is public, its folders are not.
std::string galleryPage(const std::vector<GalleryCard>& cards, const std::string& renderer,
                        const GalleryWords& words);

}  // namespace demos
