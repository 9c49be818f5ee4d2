#include "demos/gallery/gallery_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "demos/film/frame_source.h"
#include "demos/gallery/gallery_film.h"
#include "demos/gallery/gallery_work.h"
#include "demos/processes/signals.h"
#include "demos/text/complaints.h"
#include "demos/text/plural.h"
#include "demos/text/table.h"
#include "render/encode/png.h"
#include "render/encode/png_read.h"

namespace demos {
namespace {

constexpr PictureSize kTile{480, 270};

/// The shares of a large picture's pixels that one small pixel covers, along one side.
struct Cover {
    int first = 0;
    std::vector<float> shares;  // of the pixels from `first` on
};

std::vector<Cover> coversOf(int large, int small) {
    const float step = static_cast<float>(large) / static_cast<float>(small);
    std::vector<Cover> covers;
    for (int i = 0; i < small; ++i) {
        const float from = static_cast<float>(i) * step, to = static_cast<float>(i + 1) * step;
        Cover cover;
        cover.first = static_cast<int>(from);
        for (int k = cover.first; k < large && static_cast<float>(k) < to; ++k)
            cover.shares.push_back(std::min(to, static_cast<float>(k + 1)) -
                                   std::max(from, static_cast<float>(k)));
        covers.push_back(std::move(cover));
    }
    return covers;
}

void average(const render::Image& picture, const Cover& across, const Cover& down,
             std::uint8_t* pixel) {
    std::array<float, 4> sums{};
    float weight = 0.0f;
    for (std::size_t y = 0; y < down.shares.size(); ++y)
        for (std::size_t x = 0; x < across.shares.size(); ++x) {
            const float share = down.shares[y] * across.shares[x];
            const std::uint8_t* from =
                picture.at(across.first + static_cast<int>(x), down.first + static_cast<int>(y));
            for (std::size_t c = 0; c < 4; ++c) sums[c] += share * static_cast<float>(from[c]);
            weight += share;
        }
    for (std::size_t c = 0; c < 4; ++c)
        pixel[c] = static_cast<std::uint8_t>(sums[c] / weight + 0.5f);
}

struct NamedPoster {
    std::string name;
    render::Image picture;
};

/// The posters of the scenes that can be drawn.
std::vector<NamedPoster> postersOf(GalleryOptions options, GalleryTroubles& troubles) {
    if (!options.size && !options.qualityAsked) options.size = kTile;
    const std::vector<GalleryChoice> choices = chooseGallery(options.scenes);
    const int count = static_cast<int>(choices.size());
    std::vector<NamedPoster> posters;
    const auto draw = [&](int i) {
        return attempted([&] {
            const GalleryOptions own = optionsOfFilm(choices[i], options);
            const DrawnPoster poster = drawPoster(planPictures(own));
            const auto png = render::encodePng(poster.image);
            return printable(poster.incident) + "\n" + std::string(png.begin(), png.end());
        });
    };
    const auto take = [&](int i, const PoolResult& result) {
        std::string png;
        if (!troubles.take(choices[i], result, png)) return;
        const std::size_t end = png.find('\n');  // of the incident's line
        troubles.tellIncident(choices[i].name, png.substr(0, end));
        png.erase(0, end + 1);
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(png.data());
        posters.push_back({choices[i].name, render::decodePng({bytes, png.size()})});
    };
    runInProcesses(count, workerCount(options.jobs, count), draw, take);
    return posters;
}

}  // namespace

render::Image shrunk(const render::Image& picture, PictureSize size) {
    render::Image small{size.width, size.height, {}};
    small.pixels.resize(4 * static_cast<std::size_t>(size.width) * size.height);
    const std::vector<Cover> across = coversOf(picture.width, size.width),
                             down = coversOf(picture.height, size.height);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) average(picture, across[x], down[y], small.at(x, y));
    return small;
}

GallerySheet::GallerySheet(int count, int columns, PictureSize tile)
    : layout_(stripLayout(count, columns, tile, true)),
      inks_(inksOf("studio")),
      paper_(stripPaper(layout_, inks_.ground)) {}

void GallerySheet::add(const render::Image& picture, const std::string& name) {
    const PictureSize tile = layout_.picture;
    const bool fits = picture.width == tile.width && picture.height == tile.height;
    placeMoment(layout_, count_++, fits ? picture : shrunk(picture, tile), name, inks_.ink, paper_);
}

Exit galleryOfOnePicture(const GalleryOptions& options) {
    const std::string target = options.outputs.front();
    checkFree(target, options.overwrite);
    const Talk talk(options, target == "-");
    watchSignals();
    GalleryTroubles troubles(talk);
    const std::vector<NamedPoster> posters = postersOf(options, troubles);
    if (posters.empty()) return troubles.code();
    const render::Image& first = posters.front().picture;
    GallerySheet sheet(static_cast<int>(posters.size()), options.columns,
                       {first.width, first.height});
    for (const NamedPoster& poster : posters) sheet.add(poster.picture, poster.name);
    writeResult(target, render::encodePng(sheet.paper()), existingFiles(options.overwrite));
    const int width = sheet.paper().width, height = sheet.paper().height;
    talk.json(fmt::format(R"({{"event":"done","file":{},"scenes":{},"size":[{},{}]}})",
                          jsonString(target), posters.size(), width, height));
    talk.say(fmt::format("wrote {} ({}, {}x{})", printable(target), plural(posters.size(), "scene"),
                         width, height));
    talk.say("next: impulse list NAME, or impulse render NAME");
    return troubles.code();
}

}  // namespace demos
