// A corpus for the gate: changes that must pass and changes that must fail, on a tower of ten boxes
// drawn by this renderer. Noise is added artificially, since no driver here makes any.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "render/difference.h"
#include "render/palette.h"
#include "render/renderer.h"

namespace render {
namespace {

/// Ten boxes of 1 m; each sinks by `sunk` (m) into the one below.
Frame tower(float sunk = 0.0f) {
    Frame frame;
    frame.camera = {{7, 6.5f, 21}, {0, 4.6f, 0}, {0, 1, 0}, 36};
    frame.grounds.push_back({});
    for (int i = 0; i < 10; ++i) {
        Solid box;
        box.position = {0, 0.5f + static_cast<float>(i) - static_cast<float>(i + 1) * sunk, 0};
        box.color = paletteColor(i);
        frame.solids.push_back(box);
    }
    return frame;
}

Image drawn(const Frame& frame) {
    static Renderer renderer([] {
        RendererSettings settings;
        settings.width = 640, settings.height = 360, settings.threads = 0;
        return settings;
    }());
    return renderer.draw(frame);
}

/// 0 to below `count`. From Numerical Recipes, 'Quick and dirty generators'.
class Dice {
public:
    int roll(int count) {
        state_ = state_ * 1664525u + 1013904223u;
        return static_cast<int>((state_ >> 8) % static_cast<unsigned>(count));
    }

private:
    std::uint32_t state_ = 1;
};

void add(std::uint8_t& value, int levels) {
    value = static_cast<std::uint8_t>(std::clamp(value + levels, 0, 255));
}

struct Case {
    const char* name;
    std::function<Image()> image;
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

std::string nameOf(const testing::TestParamInfo<Case>& info) { return info.param.name; }

Image noisy(const std::function<void(Image&, Dice&)>& change) {
    Image image = drawn(tower());
    Dice dice;
    change(image, dice);
    return image;
}

Image damaged(const std::function<void(Frame&)>& change) {
    Frame frame = tower();
    change(frame);
    return drawn(frame);
}

const Case kShouldMatch[] = {
    {"Itself", [] { return drawn(tower()); }},
    {"SomePixelsByThreeLevels",
     [] {
         return noisy([](Image& image, Dice& dice) {
             for (int i = 0; i < 768; ++i)
                 add(image.at(dice.roll(640), dice.roll(360))[dice.roll(3)], 3 * dice.roll(3) - 3);
         });
     }},
    {"EveryValueByThreeLevels",
     [] {
         return noisy([](Image& image, Dice& dice) {
             for (std::uint8_t& value : image.pixels) add(value, dice.roll(7) - 3);
         });
     }},
    {"TheSkyByTwoLevels",
     [] {
         return noisy([](Image& image, Dice&) {
             for (int y = 0; y < 60; ++y)
                 for (int x = 0; x < 640; ++x)
                     for (int c = 0; c < 3; ++c) add(image.at(x, y)[c], 2);
         });
     }},
    {"LonePixelsByTenLevels",  // an edge that is rounded differently on another processor
     [] {
         return noisy([](Image& image, Dice&) {
             for (int y = 10; y < 360; y += 40)
                 for (int x = 10; x < 640; x += 40) add(image.at(x, y)[1], 10);
         });
     }},
};

const Case kShouldFail[] = {
    {"EveryBoxOneMillimetreDeeper", [] { return drawn(tower(0.001f)); }},
    {"EveryBoxFiveMillimetresDeeper", [] { return drawn(tower(0.005f)); }},
    {"OneBoxAside",
     [] { return damaged([](Frame& f) { f.solids.back().position.x() += 0.012f; }); }},
    {"OneBoxFarAside",
     [] { return damaged([](Frame& f) { f.solids.back().position.x() += 0.12f; }); }},
    {"OneBoxTurned",
     [] {
         return damaged([](Frame& f) {
             f.solids.back().rotation = Quat(Eigen::AngleAxisf(0.02f, Vec3::UnitY()));
         });
     }},
    {"OneBoxHidden", [] { return damaged([](Frame& f) { f.solids.pop_back(); }); }},
    {"OneBoxOfAnotherColor",
     [] { return damaged([](Frame& f) { f.solids.back().color.b += 0.05f; }); }},
    {"OneBoxBluerByTwoPercent",
     [] { return damaged([](Frame& f) { f.solids.back().color.b += 0.02f; }); }},
    {"NoShadows", [] { return damaged([](Frame& f) { f.look.shadows = false; }); }},
    {"NoOcclusion", [] { return damaged([](Frame& f) { f.look.ambientOcclusion = false; }); }},
    {"NoEdges", [] { return damaged([](Frame& f) { f.look.edges = false; }); }},
    {"TheSunFiveDegreesOn",
     [] {
         return damaged([](Frame& f) {
             const Vec3 sun = f.look.sunDirection;
             f.look.sunDirection = Eigen::AngleAxisf(0.0873f, sun.unitOrthogonal()) * sun;
         });
     }},
    {"TheCameraOneCentimetreOn",
     [] {
         return damaged([](Frame& f) {
             f.camera.from.x() += 0.01f;
             f.camera.lookAt.x() += 0.01f;
         });
     }},
};

class ShouldMatch : public testing::TestWithParam<Case> {};
class ShouldFail : public testing::TestWithParam<Case> {};

TEST_P(ShouldMatch, PassesTheGate) {
    const Difference d = compare(drawn(tower()), GetParam().image());
    RecordProperty("window", d.worstWindow);
    RecordProperty("ssim", std::to_string(d.worstSsim));
    EXPECT_TRUE(samePicture(d)) << "window " << d.worstWindow << ", SSIM " << d.worstSsim;
}

TEST_P(ShouldFail, DoesNotPassTheGate) {
    const Difference d = compare(drawn(tower()), GetParam().image());
    RecordProperty("window", d.worstWindow);
    RecordProperty("ssim", std::to_string(d.worstSsim));
    EXPECT_FALSE(samePicture(d)) << "window " << d.worstWindow << ", SSIM " << d.worstSsim;
}

INSTANTIATE_TEST_SUITE_P(Gate, ShouldMatch, testing::ValuesIn(kShouldMatch), nameOf);
INSTANTIATE_TEST_SUITE_P(Gate, ShouldFail, testing::ValuesIn(kShouldFail), nameOf);

}  // namespace
}  // namespace render
