// Frames that would be drawn differently have different sums.
#include "demos/watch/frame_hash.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "render/solid_mesh.h"

namespace {

using namespace render;
using demos::FrameHasher;

std::shared_ptr<const SolidMesh> pyramid(float height) {
    return makeMesh({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, height, 0}},
                    {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}, true);
}

/// One of everything.
Frame full() {
    Frame frame;
    frame.grounds.resize(1);
    frame.solids.resize(2);
    frame.solids[1].shape = SolidShape::mesh;
    frame.solids[1].mesh = pyramid(1.0f);
    frame.rods.resize(1);
    frame.arrows.resize(1);
    frame.markers.resize(1);
    frame.lines.resize(1);
    frame.ghosts.resize(1);
    frame.labels.resize(1);
    frame.trails.resize(1);
    frame.trails[0].points.resize(2, render::Vec3(0, 0, 0));
    frame.texts.resize(1);
    frame.plates.resize(1);
    frame.plates[0].rows.resize(1);
    frame.plates[0].rows[0].bar.resize(1);
    frame.plates[0].rows[0].ramp.resize(1);
    return frame;
}

const std::vector<std::function<void(Frame&)>> kChanges = {
    [](Frame& f) { f.camera.from.x() += 1e-6f; },
    [](Frame& f) { f.camera.fovDegrees += 1; },
    [](Frame& f) { f.camera.focus += 1; },
    [](Frame& f) { f.look.sunDirection.z() += 1; },
    [](Frame& f) { f.look.edges = false; },
    [](Frame& f) { f.look.dither = true; },
    [](Frame& f) { f.look.plate.a = 0; },
    [](Frame& f) { f.grounds[0].offset = 1; },
    [](Frame& f) { f.grounds.clear(); },
    [](Frame& f) { f.solids[0].shape = SolidShape::sphere; },
    [](Frame& f) { f.solids[0].halfSize.y() = 1; },
    [](Frame& f) { f.solids[0].position.y() = 1e-7f; },
    [](Frame& f) { f.solids[0].rotation.x() = 1e-7f; },
    [](Frame& f) { f.solids[0].color.g = 0; },
    [](Frame& f) { f.solids[1].mesh = pyramid(1.5f); },
    [](Frame& f) { f.solids[1].mesh = nullptr; },
    [](Frame& f) { f.solids.pop_back(); },
    [](Frame& f) { f.rods[0].radius = 1; },
    [](Frame& f) { f.arrows[0].to.x() = 1; },
    [](Frame& f) { f.markers[0].shape = MarkerShape::quartered; },
    [](Frame& f) { f.lines[0].pixels = 9; },
    [](Frame& f) { f.ghosts[0].color.a = 0.5f; },
    [](Frame& f) { f.ghosts[0].mesh = pyramid(1.0f); },
    [](Frame& f) { f.labels[0].text.push_back('a'); },
    [](Frame& f) { f.labels[0].below = 1; },
    [](Frame& f) { f.trails[0].points[1].y() = 1; },
    [](Frame& f) { f.trails[0].points.pop_back(); },
    [](Frame& f) { f.texts[0].text.push_back('t'); },
    [](Frame& f) { f.texts[0].corner = Corner::bottomLeft; },
    [](Frame& f) { f.texts[0].plate = true; },
    [](Frame& f) { f.texts[0].heading = "h"; },
    [](Frame& f) { f.texts[0].formulas.resize(1); },
    [](Frame& f) { f.texts[0].formulas.assign(1, {0, 0, 0, {{'a'}}, {}}); },
    [](Frame& f) { f.texts[0].formulas.assign(1, {0, 0, 0, {}, {{{{1, 2}}}}}); },
    [](Frame& f) { f.texts[0].headingColor.r = 1; },
    [](Frame& f) { f.plates[0].rows[0].value.push_back('1'); },
    [](Frame& f) { f.plates[0].rows[0].bar[0].share = 1; },
    [](Frame& f) { f.plates[0].rows[0].ramp[0].r = 0; },
};

TEST(FrameHash, EveryChangeIsNoticed) {
    FrameHasher hasher;
    std::map<std::uint64_t, int> sums{{hasher.of(full()), -1}};
    for (std::size_t i = 0; i < kChanges.size(); ++i) {
        Frame frame = full();
        kChanges[i](frame);
        const auto [known, added] = sums.emplace(hasher.of(frame), static_cast<int>(i));
        EXPECT_TRUE(added) << "change " << i << " is as " << known->second;
    }
}

TEST(FrameHash, EqualFramesAreEqualWhereverTheirMeshesAre) {
    FrameHasher first, second;
    EXPECT_EQ(first.of(full()), first.of(full()));
    EXPECT_EQ(first.of(full()), second.of(full()));
}

/// "ab" and "c" are not "a" and "bc".
TEST(FrameHash, WhatMovesFromOneTextToTheNextIsNoticed) {
    FrameHasher hasher;
    Frame one = full(), other = full();
    const std::string a = "a", ab = "ab", bc = "bc", c = "c";
    one.plates[0].rows[0].name = ab;
    one.plates[0].rows[0].value = c;
    other.plates[0].rows[0].name = a;
    other.plates[0].rows[0].value = bc;
    EXPECT_NE(hasher.of(one), hasher.of(other));
}

}  // namespace
