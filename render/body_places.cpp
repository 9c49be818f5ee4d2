#include "render/body_places.h"

#include <algorithm>
#include <cmath>

#include "render/instances.h"
#include "render/solid_mesh.h"

namespace render {
void addShape(const Solid& s, ShapeTiles& shape) {
    const Vec3 half = holdingHalfSize(s);
    const Eigen::Matrix3f axes = s.rotation.toRotationMatrix();
    shape.addBox(s.position, half.x() * axes.col(0), half.y() * axes.col(1),
                 half.z() * axes.col(2));
}

bool addShape(const Rod& rod, const View& view, int height, ShapeTiles& shape) {
    const auto depthOf = [&view](const Vec3& p) {
        return -(view.view.block<1, 3>(2, 0) * p)(0) - view.view(2, 3);
    };
    const float radius = drawnRadius(rod, view.eye, pixelsAMeter(view, height));
    const float nearest = std::min(depthOf(rod.from), depthOf(rod.to)) - radius;
    if (!(nearest > view.nearest)) return false;
    const float lensX = 1.0f / view.projection(0, 0), lensY = 1.0f / view.projection(1, 1);
    const float aslant = 1.0f + lensX * lensX + lensY * lensY;  // at the picture's corners
    const float pixels = aslant * radius * pixelsAMeter(view, height) / nearest;
    const Vec3 ends[2] = {rod.from, rod.to};
    shape.addFace(ends, 2, ShapeTiles::kMargin + pixels);
    return true;
}

LightBox lightBox(const Rod& rod, float radius, const Eigen::Matrix3f& toLight) {
    LightBox box;
    for (const Vec3& end : {rod.from, rod.to}) box.extend(Vec3(toLight * end));
    box.min().array() -= radius;
    box.max().array() += radius;
    return box;
}

PixelRect texelsUnder(const LightBox& box, const ShadowFit& fit, bool& within) {
    PixelRect rect;
    int* const ends[2][2] = {{&rect.x0, &rect.x1}, {&rect.y0, &rect.y1}};
    within = true;
    bool beside = false;
    for (int i = 0; i < 2; ++i) {
        const float shift = fit.worldToLight(i, 3) + fit.half[i];
        const float low = (box.min()[i] + shift) / fit.texel - 2.0f;
        const float high = (box.max()[i] + shift) / fit.texel + 2.0f;
        const float most = static_cast<float>(fit.used[i]);
        within = within && low >= 1.0f && high <= most - 1.0f;
        beside = beside || !(high >= 0.0f) || !(low <= most);
        *ends[i][0] = static_cast<int>(std::floor(std::clamp(low, 0.0f, most)));
        *ends[i][1] = static_cast<int>(std::ceil(std::clamp(high, 0.0f, most)));
    }
    return beside ? PixelRect{} : rect;
}

std::vector<PixelRect> texelsUnder(const Frame& frame, const View& view, int height,
                                   const ShadowFit& fit) {
    const Eigen::Matrix3f toLight = fit.worldToLight.block<3, 3>(0, 0);
    const float pixels = pixelsAMeter(view, height);
    std::vector<PixelRect> under;
    bool within = true;
    for (const Solid& s : frame.solids)
        under.push_back(texelsUnder(lightBox(s, toLight), fit, within));
    for (const Rod& rod : frame.rods) {
        const float radius = drawnRadius(rod, view.eye, pixels);
        under.push_back(texelsUnder(lightBox(rod, radius, toLight), fit, within));
    }
    return under;
}

std::vector<char> bodiesIn(const TileSet& tiles, const Frame& frame, const View& view, int width,
                           int height) {
    ShapeTiles shape(view, width, height, kTile);
    std::vector<char> in;
    for (const Solid& s : frame.solids) {
        addShape(s, shape);
        in.push_back(shape.meet(tiles));
    }
    for (const Rod& rod : frame.rods)
        in.push_back(!addShape(rod, view, height, shape) || shape.meet(tiles));
    return in;
}

}  // namespace render
