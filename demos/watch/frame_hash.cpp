// Every struct is taken apart by structured bindings: this file does not compile if a frame has a
// member that is missing here.

#include "demos/watch/frame_hash.h"

#include <span>
#include <type_traits>

#include "demos/text/text_hash.h"
#include "render/solid_mesh.h"

namespace demos {
namespace {

class FrameSum {
public:
    template <class... Values>
    void add(const Values&... values) {
        (one(values), ...);
    }
    std::uint64_t value() const { return hash_.value(); }

private:
    /// Numbers and enumerations; 0.0f and -0.0f differ, which at worst draws a frame again.
    template <class Value>
    requires std::is_arithmetic_v<Value> || std::is_enum_v<Value>
    void one(const Value& value) {
        hash_.add(std::span(reinterpret_cast<const std::uint8_t*>(&value), sizeof value));
    }
    void one(const std::string& text) { hash_.add(text); }
    void one(const render::Vec3& v) { add(v.x(), v.y(), v.z()); }
    void one(const render::Quat& q) { add(q.w(), q.x(), q.y(), q.z()); }

    template <class Item>
    void one(const std::vector<Item>& items) {
        one(items.size());
        for (const Item& item : items) one(item);
    }

    void one(const render::Color& color) {
        const auto& [r, g, b, a] = color;
        add(r, g, b, a);
    }
    void one(const render::Camera& camera) {
        const auto& [from, lookAt, up, fovDegrees, aperture, focus] = camera;
        add(from, lookAt, up, fovDegrees, aperture, focus);
    }
    void one(const render::Look& look) {
        const auto& [sun, skyTop, skyHorizon, fog, ground, shadows, occlusion, edges, dither, transparent,
                     lineStrength, reflection, grain, gridReach, unit, edgePixels, ink, plate] = look;
        add(sun, skyTop, skyHorizon, fog, ground, shadows, occlusion, edges, dither, transparent,
            lineStrength, reflection, grain, gridReach, unit, edgePixels, ink, plate);
    }
    void one(const render::Ground& ground) {
        const auto& [visible, normal, offset, id] = ground;
        add(visible, normal, offset, id);
    }
    /// FrameHasher adds the mesh, whose sum it may know already.
    void one(const render::Solid& solid) {
        const auto& [shape, halfSize, position, rotation, color, material, id, mesh] = solid;
        add(shape, halfSize, position, rotation, color, material, id, mesh != nullptr);
    }
    void one(const render::Rod& rod) {
        const auto& [from, to, radius, color, id] = rod;
        add(from, to, radius, color, id);
    }
    void one(const render::Arrow& arrow) {
        const auto& [from, to, color, reach] = arrow;
        add(from, to, color, reach);
    }
    void one(const render::Marker& marker) {
        const auto& [position, pixels, color, largest, reach, shape] = marker;
        add(position, pixels, color, largest, reach, shape);
    }
    void one(const render::Line& line) {
        const auto& [from, to, pixels, color] = line;
        add(from, to, pixels, color);
    }
    void one(const render::Label& label) {
        const auto& [text, position, reach, size, below, subscript, value, beside, clearOf, color] =
            label;
        add(text, position, reach, size, below, subscript, value, beside, clearOf, color);
    }
    void one(const render::Trail& trail) {
        const auto& [points, pixels, color] = trail;
        add(points, pixels, color);
    }
    void one(const render::Text& text) {
        const auto& [words, corner, size, color, plate, heading, headingColor, formulas, needed] = text;
        add(words, corner, size, color, plate, heading, headingColor, formulas, needed);
    }
    void one(const render::Formula& formula) {
        const auto& [width, ascent, descent, letters, strokes] = formula;
        add(width, ascent, descent, letters, strokes);
    }
    void one(const render::FormulaLetter& letter) {
        const auto& [codepoint, x, y, size, stretch, italic, bold] = letter;
        add(codepoint, x, y, size, stretch, italic, bold);
    }
    void one(const render::FormulaStroke& stroke) { one(stroke.corners); }
    void one(const render::FormulaStroke::Corner& corner) { add(corner.x, corner.y); }
    void one(const render::BarPart& part) {
        const auto& [share, color] = part;
        add(share, color);
    }
    void one(const render::PlateRow& row) {
        const auto& [name, value, swatch, color, meters, bar, ramp] = row;
        add(name, value, swatch, color, meters, bar, ramp);
    }
    void one(const render::Plate& plate) {
        const auto& [corner, size, rows] = plate;
        add(corner, size, rows);
    }

    TextHash hash_;
};

/// Everything else in a mesh follows from these.
std::uint64_t sumOf(const render::SolidMesh& mesh) {
    FrameSum sum;
    sum.add(mesh.vertices, mesh.triangles.size(), mesh.convex, mesh.facets);
    for (const auto& [a, b, c] : mesh.triangles) sum.add(a, b, c);
    for (const auto& [a, b, c] : mesh.crisp) sum.add(a, b, c);
    return sum.value();
}

}  // namespace

std::uint64_t FrameHasher::of(const std::shared_ptr<const render::SolidMesh>& mesh) {
    const auto [known, added] = meshes_.try_emplace(mesh, 0);
    if (added && mesh) known->second = sumOf(*mesh);
    return known->second;
}

std::uint64_t FrameHasher::of(const render::Frame& frame) {
    const auto& [camera, look, grounds, solids, rods, arrows, markers, lines, ghosts, labels,
                 trails, texts, plates] = frame;
    FrameSum sum;
    sum.add(camera, look, grounds, solids, rods, arrows, markers, lines, ghosts, labels, trails,
            texts, plates);
    for (const std::vector<render::Solid>* list : {&solids, &ghosts})
        for (const render::Solid& solid : *list) sum.add(of(solid.mesh));
    return sum.value();
}

}  // namespace demos
