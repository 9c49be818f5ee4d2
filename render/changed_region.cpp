// Bodies are compared one by one. What a body may change lies within the box around it, before and
// after; its shadow within the column that this box covers along the light, from the box down to
// the last body or ground below it.
#include "render/changed_region.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "render/meshes.h"
#include "render/solid_mesh.h"
#include "render/trails.h"

namespace render {
namespace {

constexpr std::size_t kTogether = 16;  // rods in one box
constexpr float kEverything = 1e6f;    // m

/// Bit by bit: -0 is not 0.
template <class Values>
bool same(const Values& a, const Values& b) {
    const auto count = static_cast<std::size_t>(a.size());
    return std::memcmp(a.data(), b.data(), count * sizeof(a.coeff(0))) == 0;
}
bool same(const Color& a, const Color& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

bool same(const Camera& a, const Camera& b) {
    return same(a.from, b.from) && same(a.lookAt, b.lookAt) && same(a.up, b.up) &&
           a.fovDegrees == b.fovDegrees && a.aperture == b.aperture && a.focus == b.focus;
}

bool same(const Look& a, const Look& b) {
    return same(a.sunDirection, b.sunDirection) && same(a.skyTop, b.skyTop) &&
           same(a.skyHorizon, b.skyHorizon) && same(a.fog, b.fog) && same(a.ground, b.ground) &&
           a.shadows == b.shadows && a.ambientOcclusion == b.ambientOcclusion &&
           a.edges == b.edges && a.dither == b.dither && a.transparent == b.transparent &&
           a.lineStrength == b.lineStrength && a.reflection == b.reflection && a.grain == b.grain &&
           a.gridReach == b.gridReach && a.unit == b.unit && a.edgePixels == b.edgePixels;
}

bool same(const Ground& a, const Ground& b) {
    return a.visible == b.visible && same(a.normal, b.normal) && a.offset == b.offset;
}

bool samePlace(const Solid& a, const Solid& b) {
    return a.shape == b.shape && same(a.halfSize, b.halfSize) && same(a.position, b.position) &&
           same(a.rotation.coeffs(), b.rotation.coeffs()) && a.mesh == b.mesh;
}
bool same(const Solid& a, const Solid& b) {
    return samePlace(a, b) && same(a.color, b.color) && a.material == b.material;
}

/// Beyond, the arithmetic is too coarse for a margin of pixels.
bool isNear(const Solid& s) { return s.position.cwiseAbs().maxCoeff() < 1e5f; }

bool samePlace(const Rod& a, const Rod& b) {
    return same(a.from, b.from) && same(a.to, b.to) && a.radius == b.radius;
}
bool same(const Rod& a, const Rod& b) { return samePlace(a, b) && same(a.color, b.color); }

bool same(const Trail& a, const Trail& b) {
    return a.points.size() == b.points.size() && a.pixels == b.pixels && same(a.color, b.color) &&
           std::equal(a.points.begin(), a.points.end(), b.points.begin(),
                      [](const Vec3& p, const Vec3& q) { return same(p, q); });
}

/// Meshes in the order in which they are drawn, by their solids.
std::vector<std::size_t> meshOrder(const Frame& frame) {
    std::map<const SolidMesh*, std::size_t> known;  // for lookup only
    std::vector<std::size_t> order;
    for (const Solid& s : frame.solids)
        if (s.shape == SolidShape::mesh && s.mesh)
            order.push_back(known.insert({s.mesh.get(), known.size()}).first->second);
    return order;
}

/// Whether the same bodies are drawn in the same way and order, wherever they are. Images in the floor
/// are not searched for.
bool comparable(const Frame& a, const Frame& b) {
    return a.look.reflection == 0.0f && same(a.camera, b.camera) && same(a.look, b.look) &&
           a.solids.size() == b.solids.size() && a.rods.size() == b.rods.size() &&
           a.grounds.size() == b.grounds.size() &&
           std::equal(a.grounds.begin(), a.grounds.end(), b.grounds.begin(),
                      [](const Ground& p, const Ground& q) { return same(p, q); }) &&
           meshOrder(a) == meshOrder(b);
}

/// The search for what differs.
class ChangeSearch {
public:
    ChangeSearch(const Frame& before, const Frame& now, const View& view, int width, int height,
           const ShadowFit* sun)
        : before_(before), now_(now), view_(view), width_(width), height_(height), sun_(sun),
          shape_(view, width, height, kTile), standing_(width, height, kTile),
          found_{TileSet(width, height, kTile), TileSet(width, height, kTile),
                 sun ? texelTiles(*sun) : TileSet{}} {
        if (sun) toLight_ = sun->worldToLight.block<3, 3>(0, 0);
    }

    std::optional<ChangedRegion> find() {
        compareSolids();
        compareRods();
        compareTrails();
        if (sun_ && !casters_.empty() && !everything_) castShadows();
        if (everything_) return {};
        return std::move(found_);
    }

private:
    /// A body that stays, below which a shadow may end.
    struct Receiver {
        LightBox box;            // in the light's axes
        const Solid* solid;  // null: rods
    };

    void addTo(TileSet& set, const Solid& s) {
        addShape(s, shape_);
        shape_.moveTo(set);
    }

    void addTo(TileSet& set, const Rod& rod) {
        if (!addShape(rod, view_, height_, shape_)) return set.addAll();
        shape_.moveTo(set);
    }

    void compareSolids() {
        for (std::size_t i = 0; i < now_.solids.size(); ++i) {
            const Solid &a = before_.solids[i], &b = now_.solids[i];
            if (same(a, b)) {
                if (!sun_) continue;
                addTo(standing_, b);
                receivers_.push_back({lightBox(b, toLight_), &b});
                continue;
            }
            addTo(found_.bodies, a);
            addTo(found_.bodies, b);
            everything_ = everything_ || !isNear(a) || !isNear(b);
            const auto isGlass = [](const Solid& s) { return s.material == Material::glass; };
            if (samePlace(a, b) && isGlass(a) == isGlass(b)) continue;
            for (const Solid* s : {&a, &b})
                if (sun_ && !isGlass(*s))
                    casters_.push_back(lightBox(*s, toLight_));
        }
    }

    LightBox boxOf(const Rod& rod) const {
        return lightBox(rod, drawnRadius(rod, view_.eye, pixelsAMeter(view_, height_)), toLight_);
    }

    /// Neighbours are often parts of one rope or coil.
    void compareRods() {
        for (std::size_t i = 0; i < now_.rods.size(); i += kTogether) {
            LightBox casts, stands;
            for (std::size_t k = i; k < std::min(i + kTogether, now_.rods.size()); ++k) {
                const Rod &a = before_.rods[k], &b = now_.rods[k];
                if (same(a, b)) {
                    if (!sun_) continue;
                    addTo(standing_, b);
                    stands.extend(boxOf(b));
                    continue;
                }
                for (const Rod* rod : {&a, &b}) {
                    addTo(found_.bodies, *rod);
                    if (sun_ && !samePlace(a, b)) casts.extend(boxOf(*rod));
                }
            }
            if (!casts.isEmpty()) casters_.push_back(casts);
            if (!stands.isEmpty()) receivers_.push_back({stands, nullptr});
        }
    }

    void addTrail(const Trail& trail) {
        Frame alone;
        alone.look = now_.look;
        alone.trails = {trail};
        const std::vector<TrailVertex> band = trailBands(alone, view_, width_, height_);
        for (std::size_t i = 0; i < band.size(); i += 6) {
            Eigen::Vector2f low(1e9f, 1e9f), high(-1e9f, -1e9f);
            for (std::size_t k = i; k < i + 6; ++k) {
                const Eigen::Vector4f& p = band[k].clip;
                const Eigen::Vector2f at(
                    (0.5f + 0.5f * p.x() / p.w()) * static_cast<float>(width_),
                    (0.5f - 0.5f * p.y() / p.w()) * static_cast<float>(height_));
                low = low.cwiseMin(at);
                high = high.cwiseMax(at);
            }
            const auto pixel = [](float x) {
                return static_cast<int>(std::floor(std::clamp(x, -1e6f, 1e6f)));
            };
            const int border = static_cast<int>(ShapeTiles::kMargin);
            found_.bodies.add(PixelRect{pixel(low.x()) - border, pixel(low.y()) - border,
                                        pixel(high.x()) + border + 1,
                                        pixel(high.y()) + border + 1});
        }
    }

    void compareTrails() {
        const std::size_t most = std::max(before_.trails.size(), now_.trails.size());
        for (std::size_t i = 0; i < most; ++i) {
            const Trail* a = i < before_.trails.size() ? &before_.trails[i] : nullptr;
            const Trail* b = i < now_.trails.size() ? &now_.trails[i] : nullptr;
            if (a && b && same(*a, *b)) continue;
            if (a) addTrail(*a);
            if (b) addTrail(*b);
        }
    }

    void castShadows() {
        TileSet columns(width_, height_, kTile);
        for (const LightBox& caster : casters_) {
            const PixelRect texels = texelsUnder(caster, *sun_);
            if (texels.empty()) continue;
            found_.texels.add(texels);
            castOnBodies(caster, columns);
            for (const Ground& ground : now_.grounds)
                if (ground.visible) castOnGround(caster, ground);
        }
        columns.keepOnly(standing_);
        found_.shadows.add(columns);
    }

    float margin() const { return shadowMargin(*sun_); }

    /// The column under a box, with all whose shadow may change.
    void addColumn(const LightBox& box, float bottom, TileSet& set) {
        const Eigen::Matrix3f back = toLight_.transpose();
        const Vec3 low(box.min().x() - margin(), box.min().y() - margin(), bottom - margin());
        const Vec3 high = box.max().array() + margin();
        const Vec3 half = 0.5f * (high - low);
        shape_.addBox(back * (0.5f * (low + high)), half.x() * back.col(0), half.y() * back.col(1),
                      half.z() * back.col(2));
        shape_.moveTo(set);
    }

    void castOnBodies(const LightBox& box, TileSet& columns) {
        const float top = box.max().z() + margin();
        float bottom = kEverything;
        for (const Receiver& receiver : receivers_) {
            const LightBox& r = receiver.box;
            if (r.min().z() > top || r.min().x() > box.max().x() + margin() ||
                r.max().x() < box.min().x() - margin() ||
                r.min().y() > box.max().y() + margin() || r.max().y() < box.min().y() - margin())
                continue;
            bottom = std::min(bottom, receiver.solid ? bottomOf(*receiver.solid, box)
                                                     : receiver.box.min().z());
        }
        if (bottom < top) addColumn(box, bottom, columns);
    }

    /// The lowest point of the part of a solid that is under the box; very high if there is none.
    float bottomOf(const Solid& solid, const LightBox& box) const {
        const Eigen::Matrix3f axes = toLight_ * solid.rotation.toRotationMatrix();
        const Vec3 size = box.sizes();
        const float radius = 0.5f * std::hypot(size.x(), size.y()) + 1.5f * margin();
        const Vec3 half = holdingHalfSize(solid).array() + radius;
        Vec3 from = box.center() - toLight_ * solid.position;
        from.z() = 0.0f;
        const Vec3 middle = toLight_ * solid.position;
        const Vec3 local = axes.transpose() * from, along = axes.row(2).transpose();
        float in = -kEverything, out = kEverything;
        for (int i = 0; i < 3; ++i) {
            if (std::abs(along[i]) < 1e-5f) {
                if (std::abs(local[i]) > half[i] * 1.01f) return kEverything;
                continue;
            }
            const float a = (-half[i] - local[i]) / along[i], b = (half[i] - local[i]) / along[i];
            in = std::max(in, std::min(a, b));
            out = std::min(out, std::max(a, b));
        }
        const bool missed = in > out || middle.z() + in > box.max().z() + margin();
        return missed ? kEverything : middle.z() + in;
    }

    void castOnGround(const LightBox& box, const Ground& ground) {
        if (!addShadow(box, ground, *sun_, shape_)) everything_ = true;
        shape_.moveTo(found_.shadows);
    }

    const Frame &before_, &now_;
    const View& view_;
    int width_, height_;
    const ShadowFit* sun_;
    Eigen::Matrix3f toLight_ = Eigen::Matrix3f::Identity();
    ShapeTiles shape_;
    TileSet standing_;  // bodies that stay, if shadows matter
    std::vector<Receiver> receivers_;
    std::vector<LightBox> casters_;  // in the light's axes
    bool everything_ = false;
    ChangedRegion found_;
};

}  // namespace

std::optional<ChangedRegion> changedRegion(const Frame& before, const Frame& now, const View& view,
                                           int width, int height, const ShadowFit* sun) {
    if (!comparable(before, now)) return {};
    return ChangeSearch(before, now, view, width, height, sun).find();
}

}  // namespace render
