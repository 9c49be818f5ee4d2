// The edges of shadows, against a picture with 64 times the samples: no stairs, slits or leaks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "demos/load/load_scene.h"
#include "demos/snapshot/player.h"
#include "render/renderer.h"

namespace demos {
namespace {

constexpr int kWidth = 480, kHeight = 270;
constexpr int kFiner = 8;      // times as many pixels in both directions
constexpr int kCoarse = 384;   // texels of a shadow map with stairs; that of this size has 768
constexpr float kSeen = 0.1f;  // of full light: a difference that is seen

/// Places where shadows once had stairs and slits.
struct ShadowMoment {
    const char* scene;
    double time;  // s
    double most;  // measured 0.0048, 0.0003, 0.0002 and 0.0034: edges are a pixel softer or harder
};

render::Frame frameOf(const ShadowMoment& scenario) {
    const SceneDescription scene = loadScene(scenario.scene);
    Overlays bare;
    bare.trails = bare.text = false;
    Player player(scene, bare);
    player.step(static_cast<int>(std::lround(scenario.time * scene.hz)));
    render::Frame frame = player.frame(scenario.time);
    frame.look.lineStrength = 0.0f;  // neither grid nor edges: they depend on the pixel's size
    return frame;
}

render::RendererSettings settingsOf(int finer, int shadowSize) {
    render::RendererSettings settings;
    settings.width = finer * kWidth;
    settings.height = finer * kHeight;
    settings.shadowSize = shadowSize;
    return settings;
}

/// Green, of full light: means of the picture's blocks of `finer` x `finer` pixels.
std::vector<float> levels(const render::Image& picture, int finer) {
    std::vector<float> means(static_cast<std::size_t>(kWidth) * kHeight, 0.0f);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            means[static_cast<std::size_t>(y / finer) * kWidth + x / finer] += picture.at(x, y)[1];
    for (float& mean : means) mean /= 255.0f * static_cast<float>(finer * finer);
    return means;
}

/// No silhouette and no edge of a body is within two pixels.
bool isWithinFace(const render::SurfaceMap& map, int x, int y) {
    for (int v = y - 2; v <= y + 2; ++v)
        for (int u = x - 2; u <= x + 2; ++u)
            if (map.at(u, v) != map.at(x, y)) return false;
    return map.at(x, y) != render::kNoSurface;
}

/// The share of the pixels within faces where the picture differs visibly from the finer one.
double differing(const render::Frame& frame, const std::vector<float>& fine, int shadowSize) {
    render::Renderer renderer(settingsOf(1, shadowSize));
    const render::SurfaceMap map = renderer.surfaces(frame);
    const std::vector<float> drawn = levels(renderer.draw(frame), 1);
    int within = 0, seen = 0;
    for (int y = 2; y < kHeight - 2; ++y)
        for (int x = 2; x < kWidth - 2; ++x) {
            if (!isWithinFace(map, x, y)) continue;
            const std::size_t at = static_cast<std::size_t>(y) * kWidth + x;
            ++within;
            seen += std::abs(drawn[at] - fine[at]) > kSeen;
        }
    EXPECT_GT(within, kWidth * kHeight / 2);
    return static_cast<double>(seen) / std::max(within, 1);
}

class ShadowEdges : public testing::TestWithParam<ShadowMoment> {};

TEST_P(ShadowEdges, AreThoseOfAFinerPicture) {
    const render::Frame frame = frameOf(GetParam());
    const std::vector<float> fine =
        levels(render::Renderer(settingsOf(kFiner, 0)).draw(frame), kFiner);
    EXPECT_LT(differing(frame, fine, 0), GetParam().most);
    EXPECT_GT(differing(frame, fine, kCoarse), GetParam().most);  // stairs would be noticed
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShadowEdges,
                         testing::Values(ShadowMoment{"gears", 1.8, 0.0065},
                                         ShadowMoment{"bridge", 2.0, 0.0007},
                                         ShadowMoment{"ragdoll", 1.6, 0.0004},
                                         ShadowMoment{"rope-bridge", 2.0, 0.005}),
                         [](const testing::TestParamInfo<ShadowMoment>& scenario) {
                             std::string name = scenario.param.scene;
                             std::erase(name, '-');
                             return name;
                         });

}  // namespace
}  // namespace demos
