// colour = 1/n sum over rays of  colour of the nearest pixel, of 3 x 3, with the surface it hits
#include "render/edge_samples.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>

#include "render/joined_faces.h"
#include "render/sampling.h"
#include "render/seen_surfaces.h"

namespace render {
namespace {

constexpr std::size_t kAround = 9;  // a pixel and its neighbours, row by row
constexpr std::size_t kMiddle = 4;

/// The places around a pixel, nearest to an offset first.
std::array<std::size_t, kAround> nearestFirst(const SampleOffset& offset) {
    std::array<std::size_t, kAround> order{};
    std::iota(order.begin(), order.end(), 0);
    const auto distance = [&offset](std::size_t place) {
        const float dx = static_cast<float>(place % 3) - 1.0f - offset.x;
        const float dy = static_cast<float>(place / 3) - 1.0f - offset.y;
        return dx * dx + dy * dy;
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
    return order;
}

class EdgeSamples {
public:
    /// `fresh`: the part of the map whose faces are not joined yet.
    EdgeSamples(const Image& image, SurfaceMap& map, const PixelRect& fresh, const Frame& frame,
                const View& view, int samples)
        : image_(image),
          seen_(frame, view, map.width, map.height),
          joined_(joinedFaces(seen_.surfaces(), view.eye)),
          map_(map) {
        joinFaces(map, fresh, joined_);
        const std::vector<SampleOffset> all = sampleOffsets(samples);
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (i % kFour == 0) x_.emplace_back(), y_.emplace_back();
            x_.back()[i % kFour] = all[i].x;
            y_.back()[i % kFour] = all[i].y;
            order_.push_back(nearestFirst(all[i]));
        }
    }

    std::array<std::uint8_t, 4> color(int x, int y);

private:
    void look(int x, int y);
    FourInts packedFaces(int surface, FourInts faces) const;
    FourInts meet(Four x, Four y, int count);
    std::size_t placeOf(std::int32_t surface, std::size_t sample) const;
    std::array<std::uint8_t, 4> mean(const std::array<int, kAround>& times) const;

    const Image& image_;
    SeenSurfaces seen_;
    const FaceTables joined_;
    const SurfaceMap& map_;
    std::vector<Four> x_, y_;                       // of the samples
    std::vector<std::array<std::size_t, kAround>> order_;   // by sample
    std::array<std::int32_t, kAround> around_{};    // packed surfaces
    std::array<std::size_t, kAround> at_{};         // where their pixels begin
    std::array<int, kAround> candidates_{};         // surfaces, each once, without the sky
};

void EdgeSamples::look(int x, int y) {
    for (std::size_t place = 0; place < kAround; ++place) {
        const int px = std::clamp(x + static_cast<int>(place % 3) - 1, 0, map_.width - 1);
        const int py = std::clamp(y + static_cast<int>(place / 3) - 1, 0, map_.height - 1);
        const std::size_t i = static_cast<std::size_t>(py) * map_.width + px;
        around_[place] = map_.packed[i];
        at_[place] = 4 * i;
    }
}

FourInts EdgeSamples::packedFaces(int surface, FourInts faces) const {
    if (!joined_.empty() && !joined_[surface].empty())
        for (int i = 0; i < kFour; ++i) faces[i] = joined_[surface][faces[i]];
    return faces + packedSurface(surface, 0);
}

/// The packed surface that each of four rays hits first.
FourInts EdgeSamples::meet(Four x, Four y, int count) {
    Four nearest = fourOf(std::numeric_limits<float>::infinity());
    FourInts met = FourInts{} + kNoSurface;
    for (int i = 0; i < count; ++i) {
        const FourHits hits = seen_[candidates_[i]].enter(x, y);
        const FourInts nearer = hits.t < nearest;
        nearest = nearer ? hits.t : nearest;
        met = nearer ? packedFaces(candidates_[i], hits.face) : met;
    }
    return met;
}

/// The nearest pixel with this surface; if none shows this face, one with the same body; else the
/// middle.
std::size_t EdgeSamples::placeOf(std::int32_t surface, std::size_t sample) const {
    for (const std::size_t place : order_[sample])
        if (around_[place] == surface) return place;
    for (const std::size_t place : order_[sample])
        if (surfaceIn(around_[place]) == surfaceIn(surface)) return place;
    return kMiddle;
}

std::array<std::uint8_t, 4> EdgeSamples::color(int x, int y) {
    look(x, y);
    int count = 0;
    for (const std::int32_t packed : around_) {
        const int surface = surfaceIn(packed);
        const auto end = candidates_.begin() + count;
        if (surface >= 0 && std::find(candidates_.begin(), end, surface) == end)
            candidates_[count++] = surface;
    }
    std::array<int, kAround> times{};
    for (std::size_t group = 0; group < x_.size(); ++group) {
        const FourInts met = meet(x_[group] + (static_cast<float>(x) + 0.5f),
                                  y_[group] + (static_cast<float>(y) + 0.5f), count);
        for (std::size_t lane = 0; lane < kFour; ++lane)
            ++times[placeOf(met[lane], group * kFour + lane)];
    }
    return mean(times);
}

std::array<std::uint8_t, 4> EdgeSamples::mean(const std::array<int, kAround>& times) const {
    const int samples = static_cast<int>(order_.size());
    std::array<int, 4> sum;
    sum.fill(samples / 2);
    for (std::size_t place = 0; place < kAround; ++place)
        if (times[place] > 0)
            for (std::size_t c = 0; c < 4; ++c)
                sum[c] += times[place] * image_.pixels[at_[place] + c];
    std::array<std::uint8_t, 4> color{};
    for (std::size_t c = 0; c < 4; ++c) color[c] = static_cast<std::uint8_t>(sum[c] / samples);
    return color;
}

/// Whether any of four numbers differs from the one at the same place in the other four.
bool differ(const std::int32_t* a, const std::int32_t* b) {
    std::uint64_t x[2], y[2];
    std::memcpy(x, a, sizeof x);
    std::memcpy(y, b, sizeof y);
    return ((x[0] ^ y[0]) | (x[1] ^ y[1])) != 0;
}

/// Pixels x0 <= x < x1 of a row with another surface next to, above or below them, in order.
void findEdges(const SurfaceMap& map, int y, int x0, int x1, std::vector<int>& found) {
    const int w = map.width;
    const std::int32_t* row = &map.packed[static_cast<std::size_t>(y) * w];
    const std::int32_t* above = y > 0 ? row - w : row;
    const std::int32_t* below = y + 1 < map.height ? row + w : row;
    const auto add = [&](int x) {
        if ((x > 0 && row[x - 1] != row[x]) || (x + 1 < w && row[x + 1] != row[x]) ||
            above[x] != row[x] || below[x] != row[x])
            found.push_back(x);
    };
    found.clear();
    int x = x0;
    if (x < x1) add(x++);
    for (; x + kFour < std::min(x1 + 1, w); x += kFour)
        if (differ(row + x, row + x - 1) || differ(row + x, row + x + 1) ||
            differ(row + x, above + x) || differ(row + x, below + x))
            for (int i = 0; i < kFour; ++i) add(x + i);
    for (; x < x1; ++x) add(x);
}

}  // namespace

void smoothEdges(const Image& image, SurfaceMap& map, const PixelRect& fresh,
                 const std::vector<PixelRect>& where, const Frame& frame, const View& view,
                 int samples, Image& smooth) {
    EdgeSamples edges(image, map, fresh, frame, view, samples);
    std::vector<int> found;
    for (const PixelRect& rect : where)
        for (int y = rect.y0; y < rect.y1; ++y) {
            std::copy_n(image.at(rect.x0, y), 4 * (rect.x1 - rect.x0), smooth.at(rect.x0, y));
            findEdges(map, y, rect.x0, rect.x1, found);
            for (const int x : found) {
                const std::array<std::uint8_t, 4> color = edges.color(x, y);
                std::copy(color.begin(), color.end(), smooth.at(x, y));
            }
        }
}

void smoothEdges(Image& image, SurfaceMap map, const Frame& frame, const View& view, int samples) {
    if (samples == 1) return;
    const Image before = image;
    const PixelRect all{0, 0, map.width, map.height};
    smoothEdges(before, map, all, {all}, frame, view, samples, image);
}

}  // namespace render
