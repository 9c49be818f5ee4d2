// The archive and the arrays of an .npz, by their bytes; numpy itself reads one in cli_export_test.
#include "demos/export/npz.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "demos/export/zip.h"
#include "tests/demos/recorded.h"
#include "tests/support/unzipped.h"

namespace demos::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

using support::numberAt;
using support::unzipped;

TEST(Zip, HoldsItsEntries) {
    const std::vector<ZipEntry> entries = {
        {"a.npy", Bytes(1000, 7)}, {"empty", {}}, {"b", {1, 2, 3}}};
    const Bytes zip = zipOf(entries);
    EXPECT_LT(zip.size(), 500u);  // a thousand equal bytes are packed
    const auto read = unzipped(zip);
    ASSERT_EQ(read.size(), 3u);
    for (const ZipEntry& entry : entries) EXPECT_EQ(read.at(entry.name), entry.bytes);
    EXPECT_EQ(zipOf(entries), zip);
}

TEST(Zip, WithoutEntriesIsItsEnd) { EXPECT_TRUE(unzipped(zipOf({})).empty()); }

/// An array's header and its numbers.
struct Npy {
    std::string header;
    Bytes values;

    std::vector<double> doubles() const {
        std::vector<double> numbers(values.size() / sizeof(double));
        std::memcpy(numbers.data(), values.data(), values.size());
        return numbers;
    }
};

Npy npyFrom(const Bytes& bytes) {
    EXPECT_EQ(std::string(bytes.begin(), bytes.begin() + 8), std::string("\x93NUMPY\x01\x00", 8));
    const std::size_t start = 10 + numberAt(bytes, 8, 2);
    EXPECT_EQ(start % 64, 0u);
    EXPECT_EQ(bytes[start - 1], '\n');
    const auto middle = bytes.begin() + static_cast<std::ptrdiff_t>(start);
    return {std::string(bytes.begin() + 10, middle), Bytes(middle, bytes.end())};
}

class Npz : public testing::Test {
protected:
    Npz() : arrays(unzipped(npzOf(one.run))) {}
    /// With a name that only imported models may have.
    static SceneDescription scene() {
        SceneDescription scene = read(kFloor + kBall +
                                      "[[body]]\nname = 'cage'\nat = [3, 0.495, 0]\n"
                                      "shape = { box = [1, 1, 1] }\n");
        scene.bodies[2].name = "Käfig";
        return scene;
    }
    Npy array(const std::string& name) const { return npyFrom(arrays.at(name + ".npy")); }

    Recorded one{scene(), 20, 2};
    std::map<std::string, Bytes> arrays;
};

TEST_F(Npz, TellsTypesAndShapes) {
    const auto expect = [&](const char* name, const char* type, const char* shape) {
        const std::string header = array(name).header;
        EXPECT_NE(header.find(std::string("'descr': '") + type + "'"), std::string::npos) << header;
        EXPECT_NE(header.find(std::string("'shape': ") + shape), std::string::npos) << header;
        EXPECT_NE(header.find("'fortran_order': False"), std::string::npos);
    };
    expect("time", "<f8", "(11,)");
    expect("names", "<U5", "(3,)");
    expect("mass", "<f8", "(3,)");
    expect("position", "<f8", "(11, 3, 3)");
    expect("rotation", "<f8", "(11, 3, 4)");
    expect("velocity", "<f8", "(11, 3, 3)");
    expect("spin", "<f8", "(11, 3, 3)");
    expect("energy", "<f8", "(11, 3)");
    EXPECT_EQ(arrays.size(), 15u);
}

TEST_F(Npz, HoldsTheEnginesNumbersBitForBit) {
    const std::vector<double> positions = array("position").doubles(),
                              rotations = array("rotation").doubles();
    for (std::size_t frame = 0; frame < 11; ++frame)
        for (std::size_t body = 0; body < 3; ++body) {
            const engine::Pose& pose = one.run.frames[frame].bodies[body].pose;
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_EQ(positions[(frame * 3 + body) * 3 + k],
                          pose.position[static_cast<int>(k)]);
            EXPECT_EQ(rotations[(frame * 3 + body) * 4], pose.rotation.w());
            EXPECT_EQ(rotations[(frame * 3 + body) * 4 + 3], pose.rotation.z());
        }
    EXPECT_EQ(array("mass").doubles()[1], one.player.stage().world.mass(one.player.stage().bodies[1]));
    EXPECT_EQ(array("time").doubles()[10], 20.0 / 60.0);
    EXPECT_EQ(array("energy").doubles()[1], one.run.frames[0].measures.energy.potential);
}

// Four bytes a letter: 'Käfig' has five letters and six bytes.
TEST_F(Npz, NamesAreLetters) {
    const Bytes values = array("names").values;
    ASSERT_EQ(values.size(), 3u * 5u * 4u);
    EXPECT_EQ(numberAt(values, 2 * 20 + 4, 4), 0xe4u);
    EXPECT_EQ(numberAt(values, 1 * 20, 4), static_cast<std::uint32_t>('b'));
    EXPECT_EQ(numberAt(values, 1 * 20 + 16, 4), 0u);  // 'ball' is one shorter
}

// The box lies on the floor all the time: four points in every frame but the first.
TEST_F(Npz, ContactsKnowTheirFrameAndBodies) {
    const Npy frames = array("contact_frame"), bodies = array("contact_bodies");
    std::vector<std::int64_t> frame(frames.values.size() / 8), body(bodies.values.size() / 8);
    std::memcpy(frame.data(), frames.values.data(), frames.values.size());
    std::memcpy(body.data(), bodies.values.data(), bodies.values.size());
    ASSERT_EQ(frame.size(), 40u);
    ASSERT_EQ(body.size(), 80u);
    for (std::size_t i = 0; i < 40; ++i) {
        EXPECT_EQ(frame[i], static_cast<std::int64_t>(1 + i / 4));
        EXPECT_EQ(body[2 * i] + body[2 * i + 1], 2);  // the floor is 0, the box 2
    }
    const std::vector<double> impulses = array("contact_impulse").doubles();
    double last = 0.0;
    for (std::size_t i = 36; i < 40; ++i) last += impulses[i];
    EXPECT_NEAR(last, 1000.0 * 9.81 / 60, 1.0);  // N s: its weight over a step
}

}  // namespace
}  // namespace demos::test
