#include "demos/film/film_needs.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "demos/film/progress.h"
#include "demos/text/complaints.h"
#include "demos/text/stop.h"

namespace demos {
namespace {

constexpr double kMiB = 1024.0 * 1024.0;
constexpr double kShare = 0.8;  // of the machine's memory; the rest is for others and caches

// Peak sizes (VmHWM in /proc) of the processes of `impulse render stack --jobs 2`, at 320x180,
// 1280x720, 1920x1080 and 3840x2160, as PNG files and as .mp4, with --blur 4 and with every --pass.
// bytes = fixed + pixels * each; the fixed parts are mostly libraries, which the processes share.
// The number of samples makes no difference.
constexpr double kWorker = 74.0 * kMiB;  // plus the shadow map
constexpr double kProgram = 57.0 * kMiB;
constexpr double kEncoder = 58.0 * kMiB;
constexpr double kPixel = 31.0;        // buffers, the picture, what is kept of it, a message
constexpr double kSum = 18.0;          // with several moments: four sums and one more picture
constexpr double kPngPixel = 6.5;      // RGB and the compressed data
constexpr double kMessagePixel = 9.5;  // raw frames in the program: one in use, one arriving; YUV
constexpr double kPassKept = 5.0;      // for every data pass but the largest

double pixelsOf(int width, int height) { return static_cast<double>(width) * height; }

/// Bytes per pixel.
struct PassBytes {
    double worker = 0.0, program = 0.0;
};

PassBytes bytesOf(Pass pass) {
    switch (pass) {
        case Pass::depth: return {15.0, 12.0};
        case Pass::depth16: return {16.0, 0.0};
        case Pass::normal: return {42.0, 0.0};
        case Pass::id: return {14.0, 0.0};
        case Pass::flow: return {27.0, 16.0};
        case Pass::camera:
        case Pass::poses:
        case Pass::contacts:
        case Pass::events: return {};
    }
    return {};
}

/// Passes are made one after the other; each is kept until the frame is complete.
PassBytes passBytes(const std::vector<Pass>& passes) {
    PassBytes all;
    for (const Pass pass : passes) {
        const PassBytes one = bytesOf(pass);
        if (one.worker == 0.0) continue;
        const double before = all.worker;
        all.worker = std::max(before, one.worker) + (before > 0.0 ? kPassKept : 0.0);
        all.program += one.program;
    }
    return all;
}

/// Panels are drawn one at a time and copied into the whole picture.
double workerBytes(const FilmPlan& plan, bool png) {
    const render::RendererSettings& picture = plan.picture;
    const double drawn = pixelsOf(picture.width, picture.height);
    const double whole = pixelsOf(plan.layout.width, plan.layout.height);
    const double shadow = 2.0 * std::pow(1.25 * render::shadowTexels(picture) + 4.0, 2);
    const double sums = plan.shutter.moments > 1 ? kSum * drawn : 0.0;
    const double panels = plan.panels.size() > 1 ? 4.0 * whole : 0.0;
    return kWorker + shadow + sums + drawn * (kPixel + passBytes(plan.passes).worker) + panels +
           (png ? kPngPixel * whole : 0.0);
}

/// Encoders buffer frames to look ahead; x264 buffers the most: 40, and 20 in B-frames and threads.
double encoderBytes(const FilmPlan& plan) {
    const double pixels = pixelsOf(plan.layout.width, plan.layout.height);
    return kEncoder + pixels * (25.0 + 4.5 * std::min(plan.frames, 60));
}

/// From the bytes per pixel and frame of the built-in scenes, rounded up.
double diskBytes(const FilmPlan& plan, const Output& output) {
    const double pixels = pixelsOf(plan.layout.width, plan.layout.height) * plan.frames;
    if (output.kind == OutputKind::raw) return 0.0;
    if (output.kind == OutputKind::frames) return 0.3 * pixels;
    const std::string ending = output.path.extension().string();
    return (ending == ".mp4" || ending == ".webm" ? 0.02 : 0.2) * pixels;
}

std::string bytesText(double bytes) {
    if (bytes >= 1e9) return fmt::format("{:.1f} GB", bytes / 1e9);
    return fmt::format("{:.0f} MB", std::max(bytes / 1e6, 1.0));
}

std::string pictureText(const FilmPlan& plan) {
    return fmt::format("{}x{}", plan.layout.width, plan.layout.height);
}

/// The limit of a control group, as container engines set it; 0 = none.
double groupMemory() {
    double limit = 0.0;
    for (const char* name :
         {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"})
        if (std::FILE* file = std::fopen(name, "r")) {
            double bytes = 0.0;  // "max" reads as nothing
            if (std::fscanf(file, "%lf", &bytes) == 1) limit = bytes;
            std::fclose(file);
            break;
        }
    return limit;
}

/// The address space of one process, as `ulimit -v` sets it; 0 = no limit.
double processMemory() {
    rlimit limit{};
    const bool known = getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
    return known ? static_cast<double>(limit.rlim_cur) : 0.0;
}

/// Refuses what one process could not allocate.
void checkProcess(const FilmNeeds& needs, const FilmPlan& plan) {
    const double most = processMemory(), needed = std::max(needs.worker, needs.program);
    if (most <= 0.0 || needed <= most) return;
    throw Stop(Exit::environment,
               fmt::format("a drawing process at {} needs {} of memory; a process may have {} here "
                           "(ulimit -v); a smaller --size fits",
                           pictureText(plan), bytesText(needed), bytesText(most)));
}

std::string targetText(const FilmPlan& plan, const Output& output) {
    if (output.kind == OutputKind::raw) return "standard output, raw RGBA";
    if (output.kind == OutputKind::film) return output.path.string();
    return expandPattern(output.pattern, valuesOf(plan, 0)) + " ...";
}

}  // namespace

FilmNeeds needsOf(const FilmPlan& plan, int workers, const std::vector<Output>& outputs) {
    const bool png = has(outputs, OutputKind::frames);
    const bool moving = has(outputs, OutputKind::film) || has(outputs, OutputKind::raw);
    const double pixels = pixelsOf(plan.layout.width, plan.layout.height);
    FilmNeeds needs;
    needs.workers = workers;
    needs.worker = workerBytes(plan, png || outputs.empty());
    needs.program = kProgram + pixels * ((png ? 0.6 : 0.0) + (moving ? kMessagePixel : 0.0) +
                                         passBytes(plan.passes).program);
    for (const Output& output : outputs) {
        if (output.kind == OutputKind::film) needs.encoders += encoderBytes(plan);
        needs.disk += diskBytes(plan, output);
    }
    return needs;
}

double machineMemory() {
    const double machine =
        static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    const double group = groupMemory();
    return group > 0.0 ? std::min(group, machine) : machine;
}

void checkNeeds(const FilmNeeds& needs, const FilmPlan& plan) {
    checkProcess(needs, plan);
    const double have = machineMemory();
    if (have <= 0.0 || needs.memory() <= kShare * have) return;
    const double room = kShare * have - needs.program - needs.encoders;
    const int fitting = static_cast<int>(std::clamp(room / needs.worker, 0.0, 256.0));
    throw Stop(
        Exit::environment,
        fmt::format(
            "{} drawing process{} at {} need{} {} of memory; this machine has {}, of "
            "which {:.0f} % may be used; {}",
            needs.workers, needs.workers == 1 ? "" : "es", pictureText(plan),
            needs.workers == 1 ? "s" : "", bytesText(needs.memory()), bytesText(have), 100 * kShare,
            fitting > 0 ? fmt::format("--jobs {} fits", fitting) : "a smaller --size fits"));
}

std::string needsText(const FilmNeeds& needs, const FilmPlan& plan,
                      const std::vector<Output>& outputs) {
    std::string text =
        fmt::format("{}: {} frames of {}, {} a second, {:.3g} s\n", printable(plan.name),
                    plan.frames, pictureText(plan), plan.fps, plan.seconds());
    text += fmt::format("memory: {} drawing process{} of {}, {} in all; this machine has {}\n",
                        needs.workers, needs.workers == 1 ? "" : "es", bytesText(needs.worker),
                        bytesText(needs.memory()), bytesText(machineMemory()));
    for (const Output& output : outputs)
        text += fmt::format(
            "output: {}{}\n", printable(targetText(plan, output)),
            output.kind == OutputKind::raw ? "" : ", about " + bytesText(diskBytes(plan, output)));
    std::error_code error;
    const auto space = std::filesystem::space(".", error);
    if (!error)
        text +=
            fmt::format("disk: {} free here\n", bytesText(static_cast<double>(space.available)));
    return text + "nothing was drawn (--dry-run)";
}

std::string needsJson(const FilmNeeds& needs, const FilmPlan& plan) {
    return fmt::format(R"({{"event":"plan","scene":{},"frames":{},"fps":{},"width":{},"height":{},)"
                       R"("samples":{},"workers":{},"memory":{:.0f},"disk":{:.0f}}})",
                       jsonString(plan.name), plan.frames, plan.fps, plan.layout.width,
                       plan.layout.height, plan.picture.samples, needs.workers, needs.memory(),
                       needs.disk);
}

}  // namespace demos
