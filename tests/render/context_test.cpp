// Every kind of context gives the same picture, whatever driver variables the user has set.
#include "render/context.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "render/difference.h"
#include "render/driver_environment.h"
#include "render/encode/file.h"
#include "render/encode/png.h"
#include "render/encode/png_read.h"
#include "render/palette.h"
#include "render/renderer.h"
#include "tests/support/temporary_folder.h"

namespace render {
namespace {

/// Shadows, occlusion, round and square shapes, and a trail.
Frame stillLife() {
    Frame frame;
    frame.camera = {{4, 3, 7}, {0, 1.1f, 0}, {0, 1, 0}, 35};
    frame.grounds.push_back({});
    for (int i = 0; i < 4; ++i) {
        Solid solid;
        solid.shape = i == 3 ? SolidShape::sphere : SolidShape::box;
        solid.position = {i == 3 ? 1.6f : 0.1f * static_cast<float>(i),
                          0.5f + static_cast<float>(i % 3), 0};
        solid.color = paletteColor(i);
        frame.solids.push_back(solid);
    }
    Trail trail;
    for (int i = 0; i < 20; ++i)
        trail.points.push_back({1.6f, 0.5f + 0.1f * static_cast<float>(i), 0.4f});
    frame.trails.push_back(trail);
    return frame;
}

class Contexts : public testing::Test {
protected:
    /// The PNG from a separate process: the driver reads its environment once. Empty: it failed.
    std::vector<std::uint8_t> drawn(
        ContextKind kind, bool reproducible, void (*before)() = [] {}, int threads = 0) {
        const std::filesystem::path file = folder_ / std::to_string(++drawn_);
        const pid_t child = fork();
        if (child == 0) {
            before();
            try {
                RendererSettings s;
                s.width = 320, s.height = 180, s.threads = threads;
                s.reproducible = reproducible, s.context = kind;
                Renderer renderer(s);
                writeFileAtomically(file, encodePng(renderer.draw(stillLife())));
                _exit(0);
            } catch (const std::exception& error) {
                std::fprintf(stderr, "%s: %s\n", nameOf(kind), error.what());
                _exit(1);
            }
        }
        int status = 0;
        waitpid(child, &status, 0);
        if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return {};
        std::ifstream in(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

private:
    support::TemporaryFolder folder_;
    int drawn_ = 0;
};

TEST_F(Contexts, AllGiveTheSamePicture) {
    for (const bool reproducible : {true, false}) {
        const auto first = drawn(contextKinds().front(), reproducible);
        ASSERT_FALSE(first.empty());
        for (const ContextKind kind : contextKinds()) {
            const auto other = drawn(kind, reproducible);
            ASSERT_FALSE(other.empty()) << nameOf(kind);
            const Difference d = compare(decodePng(first), decodePng(other));
            EXPECT_TRUE(samePicture(d, Gate{}))
                << nameOf(kind) << ": worst window " << d.worstWindow << ", SSIM " << d.worstSsim;
            RecordProperty(nameOf(kind), other == first ? "identical" : "within the gate");
        }
    }
}

TEST_F(Contexts, TheUsersEnvironmentDoesNotReachTheDriver) {
    const auto hostile = [] {
        for (const char* entry : {"LP_NATIVE_VECTOR_WIDTH=512",
                                  "LP_NUM_THREADS=x",
                                  "LP_NO_RAST=1",
                                  "LP_PERF=no_mipmap",
                                  "DRAW_USE_LLVM=false",
                                  "GALLIUM_OVERRIDE_CPU_CAPS=nosse",
                                  "GALLIUM_DRIVER=softpipe",
                                  "GALLIUM_NOOP=1",
                                  "GALLIUM_HUD=fps",
                                  "GALLIVM_PERF=no_filter_hacks,nopt",
                                  "MESA_GL_VERSION_OVERRIDE=2.1",
                                  "MESA_GLSL_VERSION_OVERRIDE=110",
                                  "MESA_EXTENSION_OVERRIDE=-GL_ARB_texture_multisample",
                                  "MESA_NO_ERROR=1",
                                  "MESA_LOADER_DRIVER_OVERRIDE=i965",
                                  "MESA_GLSL=errors",
                                  "MESA_DEBUG=context",
                                  "MESA_SHADER_READ_PATH=/nonexistent",
                                  "ST_DEBUG=wf",
                                  "NIR_DEBUG=clone",
                                  "LIBGL_ALWAYS_SOFTWARE=0",
                                  "EGL_PLATFORM=x11",
                                  "force_glsl_version=110"}) {
            const std::string text = entry;
            const std::size_t equals = text.find('=');
            setenv(text.substr(0, equals).c_str(), text.substr(equals + 1).c_str(), 1);
        }
    };
    for (const ContextKind kind : contextKinds())
        for (const bool reproducible : {true, false}) {
            const auto calm = drawn(kind, reproducible);
            ASSERT_FALSE(calm.empty()) << nameOf(kind);
            EXPECT_TRUE(drawn(kind, reproducible, hostile) == calm)
                << nameOf(kind) << (reproducible ? ", reproducible" : "");
        }
}

TEST_F(Contexts, ThreadsDoNotChangePixels) {
    const auto drawnBy = [&](int threads) {
        return drawn(ContextKind::automatic, true, [] {}, threads);
    };
    const auto alone = drawnBy(0);
    ASSERT_FALSE(alone.empty());
    EXPECT_EQ(drawnBy(2), alone);
}

TEST_F(Contexts, AutoTakesTheFirst) {
    EXPECT_EQ(drawn(ContextKind::automatic, true), drawn(contextKinds().front(), true));
}

TEST(ContextKinds, HaveNamesThatReadBack) {
    ASSERT_FALSE(contextKinds().empty());
    for (const ContextKind kind : contextKinds()) EXPECT_EQ(contextCalled(nameOf(kind)), kind);
    EXPECT_EQ(contextCalled("auto"), ContextKind::automatic);
}

TEST(DriverEnvironment, KnowsWhatMesaListensTo) {
    for (const char* name : {"LP_NUM_THREADS", "GALLIUM_HUD", "MESA_DEBUG", "LIBGL_DEBUG",
                             "GALLIVM_PERF", "DRAW_FSE", "force_glsl_extensions_warn"})
        EXPECT_TRUE(isDriverVariable(name)) << name;
    for (const char* name : {"PATH", "HOME", "LIBGL_DRIVERS_PATH", "LPATH", "MESA", ""})
        EXPECT_FALSE(isDriverVariable(name)) << name;
}

}  // namespace
}  // namespace render
