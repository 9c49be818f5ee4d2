#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "demos/commands/commands.h"
#include "demos/commands/shared_options.h"
#include "demos/film/progress.h"
#include "demos/text/version.h"
#ifdef IMPULSE_HAVE_SLIDES
#include "demos/slides/deck_files.h"
#endif
#include "render/driver_environment.h"
#include "render/encode/ffmpeg.h"
#include "render/encode/png.h"
#include "render/renderer.h"

namespace demos {
namespace {

struct Finding {
    std::string name, value;
    bool good = true;
    std::string advice;  // what to do when it is not
    bool needed = true;  // false: the rest works without it
};

/// 200 boxes on the ground: about what a demo shows.
render::Frame testFrame() {
    render::Frame frame;
    frame.grounds.push_back({});
    for (int i = 0; i < 200; ++i) {
        render::Solid solid;
        solid.position = {static_cast<float>(i % 10) * 1.2f - 5.4f,
                          0.5f + static_cast<float>(i / 100) * 1.1f,
                          static_cast<float>(i / 10 % 10) * 1.2f - 5.4f};
        frame.solids.push_back(solid);
    }
    return frame;
}

/// Milliseconds for a picture and its PNG, the second of two (the first compiles shaders).
double pictureTime(render::Renderer& renderer) {
    using Clock = std::chrono::steady_clock;
    const render::Frame frame = testFrame();
    renderer.draw(frame);
    const Clock::time_point start = Clock::now();
    render::encodePng(renderer.draw(frame));
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// True when it works. One working kind is enough, and only one is timed: all share one driver.
bool findContext(render::ContextKind kind, bool timed, std::vector<Finding>& findings) try {
    render::RendererSettings settings;
    settings.threads = 0;
    settings.context = kind;
    render::Renderer renderer(settings);
    const double one = pictureTime(renderer);
    findings.push_back({nameOf(kind), renderer.describe(), true, ""});
    if (!timed) return true;
    const int cores = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u));
    findings.push_back({"picture",
                        fmt::format("{:.0f} ms for 1280x720 on one core; 10 s of film "
                                    "in about {:.0f} s on all {}",
                                    one, 300 * one / 1000 / cores, cores),
                        true, ""});
    return true;
} catch (const std::exception& error) {
    findings.push_back(
        {nameOf(kind), error.what(), false, "one of osmesa and egl is enough", false});
    return false;
}

void findContexts(std::vector<Finding>& findings) {
    int working = 0;
    for (const render::ContextKind kind : render::contextKinds())
        working += findContext(kind, working == 0, findings);
    findings.push_back(
        {"OpenGL",
         fmt::format("from {} of {} contexts (--context)", working, render::contextKinds().size()),
         working > 0, "install libosmesa6 or libegl-mesa0; 'sim' works without it"});
}

std::vector<Finding> examine() {
    std::vector<Finding> findings;
    findings.push_back(
        {"impulse", fmt::format("{}, compiled by {}", kVersion, __VERSION__), true, ""});
    findings.push_back({"cores", fmt::format("{}", std::thread::hardware_concurrency()), true, ""});
    findings.push_back({"pixels",
                        fmt::format("class '{}' (see --reproducible)", render::pixelClass(false)),
                        true, ""});
    findContexts(findings);
    const bool ffmpeg = render::haveFfmpeg();
    findings.push_back({"ffmpeg", ffmpeg ? "found" : "not found", ffmpeg,
                        "install ffmpeg for .mp4 .webm .gif; PNG frames work without it"});
#ifdef IMPULSE_HAVE_SLIDES
    const bool chromium = !pdfBrowser().empty();
    findings.push_back({"chromium", chromium ? "found" : "not found", chromium,
                        "install chromium for slides as .pdf or .pptx; .html and folders work "
                        "without it",
                        false});
#endif
    std::error_code error;
    const auto space = std::filesystem::space(".", error);
    const double free = error ? 0.0 : static_cast<double>(space.available) / 1e9;
    findings.push_back({"disk", fmt::format("{:.1f} GB free here", free), free > 0.1,
                        "a 10 s film needs about 70 MB as PNG files"});
    return findings;
}

Exit doctor(const Options& options) {
    const Talk talk(options, false);
    bool allGood = true;
    for (const Finding& finding : examine()) {
        allGood = allGood && (finding.good || !finding.needed);
        talk.json(fmt::format(R"({{"name":{},"value":{},"ok":{}}})", jsonString(finding.name),
                              jsonString(finding.value), finding.good));
        talk.say(fmt::format("{:7}  {:8} {}", finding.good ? "ok" : "missing", finding.name,
                             finding.value));
        if (!finding.good) talk.say(fmt::format("{:16}  {}", "", finding.advice));
    }
    talk.say(allGood ? "next: impulse render stack -q draft" : "next: impulse sim stack");
    return allGood ? Exit::ok : Exit::environment;
}

Run addDoctor(CLI::App& app) {
    const auto asked = std::make_shared<Asked<Options>>();
    auto& options = asked->options;
    addFeedback(app, options);
    return [asked](const std::string& commandLine) { return doctor(settled(*asked, commandLine)); };
}

}  // namespace

Command doctorCommand() {
    return {"doctor",
            "what this machine can do",
            {"impulse doctor", "impulse doctor --json",
             "impulse doctor --quiet && impulse render stack"},
            addDoctor};
}

}  // namespace demos
