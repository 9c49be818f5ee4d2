#include "demos/slides/slide_media.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/text/base64.h"
#include "demos/text/file_content.h"
#include "render/error.h"

namespace demos {
namespace {

std::string dataUri(const char* type, std::span<const std::uint8_t> bytes) {
    return fmt::format("data:{};base64,{}", type, toBase64(bytes));
}

std::string dataUri(const MadePicture& picture) {
    if (picture.svg.empty()) return dataUri("image/png", picture.png);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(picture.svg.data());
    return dataUri("image/svg+xml", {bytes, picture.svg.size()});
}

}  // namespace

std::vector<const MadePicture*> picturesOf(const MadeSlide& slide) {
    std::vector<const MadePicture*> pictures;
    if (slide.film) pictures.push_back(&slide.film->poster);
    for (const MadePicture& picture : slide.pictures) pictures.push_back(&picture);
    return pictures;
}

double aspectOf(const MadePicture& picture) {
    return static_cast<double>(std::max(picture.size.width, 1)) /
           static_cast<double>(std::max(picture.size.height, 1));
}

bool hasFilm(const MadeSlide& slide) { return slide.film && !slide.film->file.empty(); }

std::string filmName(const MadeSlide& slide) { return "media/" + slide.slide.id + ".mp4"; }

std::string pictureName(const MadeSlide& slide, std::size_t i, const char* ending) {
    if (i == 0) return fmt::format("media/{}.{}", slide.slide.id, ending);
    return fmt::format("media/{}-{}.{}", slide.slide.id, i + 1, ending);
}

SlideMedia embeddedMedia(const MadeSlide& slide) {
    SlideMedia media;
    if (hasFilm(slide)) {
        const std::vector<std::uint8_t> film = contentOf(slide.film->file);
        if (film.empty()) throw render::Error("cannot read '" + slide.film->file.string() + "'");
        media.film = dataUri("video/mp4", film);
    }
    for (const MadePicture* picture : picturesOf(slide))
        media.pictures.push_back(dataUri(*picture));
    return media;
}

SlideMedia linkedMedia(const MadeSlide& slide) {
    SlideMedia media;
    if (hasFilm(slide)) media.film = filmName(slide);
    const std::vector<const MadePicture*> pictures = picturesOf(slide);
    for (std::size_t i = 0; i < pictures.size(); ++i)
        media.pictures.push_back(pictureName(slide, i, pictures[i]->svg.empty() ? "png" : "svg"));
    return media;
}

}  // namespace demos
