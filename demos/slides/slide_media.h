/// The pictures and films of a slide, the names of their files, and their addresses in a page.
#pragma once
#include <string>
#include <vector>

#include "demos/slides/made_deck.h"

namespace demos {

/// The film's poster first, then the others.
std::vector<const MadePicture*> picturesOf(const MadeSlide& slide);

/// Width over height.
double aspectOf(const MadePicture& picture);

bool hasFilm(const MadeSlide& slide);

/// "media/03-clamp.mp4"
std::string filmName(const MadeSlide& slide);
/// The file of the i-th of picturesOf(): "media/03-clamp.png", "media/03-clamp-2.svg".
std::string pictureName(const MadeSlide& slide, std::size_t i, const char* ending = "png");

/// Addresses for src; pictures in the order of picturesOf(), as SVG if they have one.
struct SlideMedia {
    std::string film;  // empty: none
    std::vector<std::string> pictures;
};
SlideMedia embeddedMedia(const MadeSlide& slide);  // data: URIs. Throws render::Error
SlideMedia linkedMedia(const MadeSlide& slide);

}  // namespace demos
