/// index.html of a gallery: its scenes by group, with posters, films, commands and a search.
#pragma once
#include <string>
#include <vector>

#include "demos/gallery/gallery_card.h"

namespace demos {

struct GalleryMaking {
    std::string command, renderer;
};

/// Links go to NAME.png and NAME.mp4 beside it; nothing else is asked for.
std::string galleryPage(const std::vector<GalleryCard>& cards, const GalleryMaking& making);

}  // namespace demos
