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

PixelRect texelsUnder(const LightBox& box, const ShadowFit& fit) {
    PixelRect rect;
    int* const ends[2][2] = {{&rect.x0, &rect.x1}, {&rect.y0, &rect.y1}};
    const auto most = static_cast<float>(fit.size);
    for (int i = 0; i < 2; ++i) {
        const float shift = fit.worldToLight(i, 3) + 0.5f * fit.texel * most;
        const float low = (box.min()[i] + shift) / fit.texel - 2.0f;
        const float high = (box.max()[i] + shift) / fit.texel + 2.0f;
        if (!(high >= 0.0f) || !(low <= most)) return {};
        *ends[i][0] = static_cast<int>(std::floor(std::clamp(low, 0.0f, most)));
        *ends[i][1] = static_cast<int>(std::ceil(std::clamp(high, 0.0f, most)));
    }
    return rect;
}

std::vector<PixelRect> texelsUnder(const Frame& frame, const View& view, int height,
                                   const ShadowFit& fit) {
    const Eigen::Matrix3f toLight = fit.worldToLight.block<3, 3>(0, 0);
    const float pixels = pixelsAMeter(view, height);
    std::vector<PixelRect> under;
    for (const Solid& s : frame.solids)
        under.push_back(texelsUnder(lightBox(s, toLight), fit));
    for (const Rod& rod : frame.rods) {
        const float radius = drawnRadius(rod, view.eye, pixels);
        under.push_back(texelsUnder(lightBox(rod, radius, toLight), fit));
    }
    return under;
}

float shadowMargin(const ShadowFit& fit) {
    constexpr float kReach = 8.0f;  // texels: the kernel, and the lift in shadow_place.glsl
    return kReach * fit.texel + 4.0f * fit.depth / 65536.0f;
}

bool addShadow(const LightBox& box, const Ground& ground, const ShadowFit& fit, ShapeTiles& shape) {
    const Vec3 normal = ground.normal.normalized();
    const float facing = normal.dot(fit.toLight), margin = shadowMargin(fit);
    if (facing <= 0.0f) return true;  // it is dark
    if (facing < 1e-3f) return false;
    const Eigen::Matrix3f back = fit.worldToLight.block<3, 3>(0, 0).transpose();
    Vec3 corners[4];
    bool below = false;
    int count = 0;
    for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
        const Vec3 at((x ? box.max() : box.min()).x() + (x ? margin : -margin),
                      (y ? box.max() : box.min()).y() + (y ? margin : -margin), 0.0f);
        const Vec3 point = back * at;
        const float height = (ground.offset - normal.dot(point)) / facing;
        below = below || height < box.max().z() + margin / facing;
        corners[count++] = point + height * fit.toLight;
    }
    if (below) shape.addFace(corners, 4);
    return true;
}

PixelRect groundShadows(const Frame& frame, const View& view, int width, int height,
                        const ShadowFit& fit) {
    const Eigen::Matrix3f toLight = fit.worldToLight.block<3, 3>(0, 0);
    const float pixels = pixelsAMeter(view, height);
    ShapeTiles shape(view, width, height, kTile);
    TileSet tiles(width, height, kTile);
    const auto add = [&](const LightBox& box) {
        if (texelsUnder(box, fit).empty()) return;
        for (const Ground& ground : frame.grounds) {
            if (!ground.visible) continue;
            if (!addShadow(box, ground, fit, shape)) tiles.addAll();
            shape.moveTo(tiles);
        }
    };
    for (const Solid& s : frame.solids) add(lightBox(s, toLight));
    for (const Rod& rod : frame.rods) add(lightBox(rod, drawnRadius(rod, view.eye, pixels), toLight));
    return render::boundsOf(tiles.rects());
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
