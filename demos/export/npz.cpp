// An .npy is a line of Python with type and shape, and the numbers as they are in memory
// (numpy/lib/format.py, version 1.0); an .npz is a ZIP of them.
#include "demos/export/npz.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <span>
#include <string>

#include "demos/export/zip.h"
#include "render/glyphs.h"

namespace demos {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are declared little-endian");

using Shape = std::vector<std::size_t>;

/// "(3, 4)", and with its comma "(3,)".
std::string shapeText(const Shape& shape) {
    return fmt::format("({}{})", fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
}

std::vector<std::uint8_t> npyOf(const std::string& type, const Shape& shape,
                                std::span<const std::byte> values) {
    constexpr std::size_t kAlignment = 64, kBefore = 10;  // bytes
    std::string header = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}",
                                     type, shapeText(shape));
    header.append(kAlignment - 1 - (kBefore + header.size()) % kAlignment, ' ');
    header += '\n';
    const auto length = static_cast<unsigned>(header.size());
    std::string text("\x93NUMPY\x01\x00", 8);
    text += static_cast<char>(length & 0xffu);
    text += static_cast<char>(length >> 8);
    text += header;
    std::vector<std::uint8_t> bytes(text.begin(), text.end());
    const auto* first = reinterpret_cast<const std::uint8_t*>(values.data());
    bytes.insert(bytes.end(), first, first + values.size());
    return bytes;
}

/// The arrays of one file.
class Arrays {
public:
    void add(const std::string& name, const Shape& shape, const std::vector<double>& values) {
        add(name, "<f8", shape, std::as_bytes(std::span(values)));
    }
    void add(const std::string& name, const Shape& shape, const std::vector<std::int64_t>& values) {
        add(name, "<i8", shape, std::as_bytes(std::span(values)));
    }
    /// Four bytes per letter; all texts are as long as the longest.
    void add(const std::string& name, const std::vector<std::string>& texts) {
        std::size_t longest = 1;
        for (const std::string& text : texts)
            longest = std::max(longest, render::codepoints(text).size());
        std::vector<std::int32_t> letters;
        for (const std::string& text : texts) {
            const std::vector<int> codes = render::codepoints(text);
            letters.insert(letters.end(), codes.begin(), codes.end());
            letters.insert(letters.end(), longest - codes.size(), 0);
        }
        add(name, fmt::format("<U{}", longest), {texts.size()}, std::as_bytes(std::span(letters)));
    }
    std::vector<std::uint8_t> archive() const { return zipOf(entries_); }

private:
    void add(const std::string& name, const std::string& type, const Shape& shape,
             std::span<const std::byte> values) {
        entries_.push_back({name + ".npy", npyOf(type, shape, values)});
    }
    std::vector<ZipEntry> entries_;
};

void append(std::vector<double>& values, const Vec3& v) {
    values.insert(values.end(), {v.x(), v.y(), v.z()});
}

void addMotions(const Recording& recording, std::size_t bodies, Arrays& arrays) {
    std::vector<double> positions, rotations, velocities, spins;
    for (const RecordedFrame& frame : recording.frames)
        for (const BodyMotion& body : frame.bodies) {
            const Quat& q = body.pose.rotation;
            append(positions, body.pose.position);
            rotations.insert(rotations.end(), {q.w(), q.x(), q.y(), q.z()});
            append(velocities, body.velocity);
            append(spins, body.spin);
        }
    const std::size_t frames = recording.frames.size();
    arrays.add("position", {frames, bodies, 3}, positions);
    arrays.add("rotation", {frames, bodies, 4}, rotations);
    arrays.add("velocity", {frames, bodies, 3}, velocities);
    arrays.add("spin", {frames, bodies, 3}, spins);
}

/// One row per point, for all frames one after the other: each frame has its own number of points.
void addContacts(const Recording& recording, std::size_t bodyCount, Arrays& arrays) {
    std::vector<std::int64_t> frames, bodies;
    std::vector<double> positions, normals, penetrations, impulses, frictions;
    const auto numberOf = [bodyCount](engine::BodyId id) {
        return static_cast<std::size_t>(id.index) < bodyCount ? id.index : -1;  // -1: the world
    };
    for (std::size_t i = 0; i < recording.frames.size(); ++i)
        for (const engine::ContactState& contact : recording.frames[i].contacts) {
            frames.push_back(static_cast<std::int64_t>(i));
            bodies.insert(bodies.end(), {numberOf(contact.a), numberOf(contact.b)});
            append(positions, contact.position);
            append(normals, contact.normal);
            penetrations.push_back(contact.penetration);
            impulses.push_back(contact.impulse);
            append(frictions, contact.friction);
        }
    const std::size_t count = frames.size();
    arrays.add("contact_frame", {count}, frames);
    arrays.add("contact_bodies", {count, 2}, bodies);
    arrays.add("contact_position", {count, 3}, positions);
    arrays.add("contact_normal", {count, 3}, normals);
    arrays.add("contact_penetration", {count}, penetrations);
    arrays.add("contact_impulse", {count}, impulses);
    arrays.add("contact_friction", {count, 3}, frictions);
}

}  // namespace

std::vector<std::uint8_t> npzOf(const Recording& recording) {
    std::vector<std::string> names;
    std::vector<double> masses, times, energies;
    for (const RecordedBody& body : recording.bodies) {
        names.push_back(body.name);
        masses.push_back(body.mass);
    }
    for (const RecordedFrame& frame : recording.frames) {
        const engine::Energy& energy = frame.measures.energy;
        times.push_back(frame.time);
        energies.insert(energies.end(), {energy.kinetic, energy.potential, energy.elastic});
    }
    Arrays arrays;
    arrays.add("time", {times.size()}, times);
    arrays.add("names", names);
    arrays.add("mass", {masses.size()}, masses);
    addMotions(recording, names.size(), arrays);
    arrays.add("energy", {times.size(), 3}, energies);
    addContacts(recording, names.size(), arrays);
    return arrays.archive();
}

}  // namespace demos
