/// The parts of a picture that are drawn or computed, as square tiles.
#pragma once
#include <vector>

#include "render/pixel_rect.h"

namespace render {

class TileSet {
public:
    /// Empty; `side`: of a tile, in pixels.
    TileSet(int width, int height, int side);
    TileSet() : TileSet(0, 0, 1) {}

    void add(const PixelRect& rect);
    void addTile(int x, int y) { held_[static_cast<std::size_t>(y) * across_ + x] = 1; }
    /// Of sets of the same size.
    void add(const TileSet& other);
    void keepOnly(const TileSet& other);
    void addAll() { held_.assign(held_.size(), 1); }

    int across() const { return across_; }  // tiles
    int down() const { return down_; }      // tiles
    int side() const { return side_; }      // pixels
    bool holdsTile(int x, int y) const {
        return held_[static_cast<std::size_t>(y) * across_ + x] != 0;
    }
    /// The tile at a pixel.
    bool hold(int x, int y) const { return holdsTile(x / side_, y / side_); }
    bool touches(const PixelRect& rect) const;
    bool touches(const TileSet& other) const;
    bool empty() const;
    /// 0..1 of all tiles.
    double share() const;
    /// The tiles as rectangles that do not overlap, row by row, clipped to the picture.
    std::vector<PixelRect> rects() const;
    /// The tile, clipped to the picture.
    PixelRect rectOf(int x, int y, int wide = 1) const;

private:
    int width_, height_, side_, across_, down_;
    std::vector<char> held_;  // row by row
};

/// A convex body in the picture: collects its faces, and adds the tiles they touch.
class ShapeTiles {
public:
    /// Pixels around every face: an edge is smoothed over two, and a body is drawn with whole ones.
    static constexpr float kMargin = 4.0f;

    /// `width`, `height`, `side`: pixels, as of the set.
    ShapeTiles(const View& view, int width, int height, int side);
    /// A convex face or a line, with all within `margin` pixels; what is behind the eye is cut off.
    void addFace(const Vec3* corners, int count, float margin = kMargin);
    /// `u`, `v`, `w`: half axes, m.
    void addBox(const Vec3& middle, const Vec3& u, const Vec3& v, const Vec3& w);
    /// Adds all tiles that the faces touch, or that lie between them, and removes the faces.
    void moveTo(TileSet& set);
    /// Whether the set has any of these tiles; removes the faces.
    bool meet(const TileSet& set);

private:
    struct Extent {
        float low, high;
    };
    /// Calls visit(x, y) for the tiles until it returns true, and removes the faces.
    template <class Visit>
    bool visitTiles(Visit visit);
    void addEdge(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double margin);

    Eigen::Matrix4d toClip_;
    double nearest_;  // m
    int width_, height_, side_;
    std::vector<Extent> rows_;  // pixels, by row of tiles
    int first_, last_;          // rows with an extent
    std::vector<Eigen::Vector4d> clip_;
};

}  // namespace render
