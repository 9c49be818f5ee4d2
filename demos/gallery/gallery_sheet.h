/// One picture of all scenes of a gallery, each with its name below.
#pragma once
#include <string>

#include "demos/film/film_strip.h"
#include "demos/gallery/gallery_options.h"
#include "demos/text/stop.h"

namespace demos {

/// Each pixel is the mean of those that it covers. `size`: not larger than the picture.
render::Image shrunk(const render::Image& picture, PictureSize size);

class GallerySheet {
public:
    /// `columns` 0: up to six. Throws Stop (usage) if it would be too large for a PNG.
    GallerySheet(int count, int columns, PictureSize tile);
    /// Puts a picture into the next place. One that is larger than a tile is made smaller.
    void add(const render::Image& picture, const std::string& name);
    const render::Image& paper() const { return paper_; }

private:
    StripLayout layout_;
    Inks inks_;
    render::Image paper_;
    int count_ = 0;
};

/// impulse gallery -o FILE.png: the sheet alone, of posters drawn at the tile's size.
Exit galleryOfOnePicture(const GalleryOptions& options);

}  // namespace demos
