#include "demos/options_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "demos/figure/length.h"
#include "demos/figure/paper.h"
#include "demos/film/data_pass.h"
#include "demos/film/quality.h"
#include "demos/overlays.h"
#include "demos/report/measures.h"
#include "demos/report/summary.h"
#include "demos/scene/complaints.h"
#include "demos/scene/nearest.h"
#include "demos/stop.h"
#include "demos/theme.h"
#include "render/context.h"
#include "render/encode/png.h"

namespace demos {
namespace {

constexpr double kLongest = 1e5;  // s

std::optional<PictureSize> sizeFrom(const std::string& text) {
    PictureSize size;
    const char* end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.width);
    if (width.ec != std::errc{} || width.ptr == end || *width.ptr != 'x') return std::nullopt;
    const auto height = std::from_chars(width.ptr + 1, end, size.height);
    if (height.ec != std::errc{} || height.ptr != end) return std::nullopt;
    return size;
}

void checkRange(const char* name, int value, int low, int high) {
    if (value < low || value > high)
        refuse(fmt::format("{} {}: must be {} to {}", name, value, low, high));
}

void checkSamples(int samples) {
    for (const int good : {1, 2, 4, 8, 16})
        if (samples == good) return;
    refuse(fmt::format("--samples {}: must be 1, 2, 4, 8 or 16", samples));
}

void checkName(const char* option, const std::string& word, const std::vector<std::string>& names) {
    if (std::find(names.begin(), names.end(), word) == names.end())
        refuse(fmt::format("{} '{}' is not known{}", option, printable(word),
                           suggestion(word, names)));
}

/// "8M", "1.5G", "500k", "8MB" or a plain number of bytes; K, M, G count in thousands.
std::optional<std::uint64_t> bytesFrom(std::string text) {
    if (text.ends_with('B') || text.ends_with('b')) text.pop_back();
    double unit = 1.0;
    const std::string units = "kKmMgG";
    if (const std::size_t at = text.empty() ? units.npos : units.find(text.back());
        at != units.npos) {
        for (std::size_t i = 0; i <= at / 2; ++i) unit *= 1000.0;
        text.pop_back();
    }
    double number = 0.0;
    const char* end = text.data() + text.size();
    const auto got = std::from_chars(text.data(), end, number, std::chars_format::fixed);
    const bool whole = got.ec == std::errc{} && got.ptr == end;
    if (!whole || !(number * unit >= 1000.0 && number * unit <= 1e12)) return std::nullopt;
    return static_cast<std::uint64_t>(number * unit);
}

void checkTimes(Options& options, const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
        double time = -1.0;
        const char* end = text.data() + text.size();
        const auto got = std::from_chars(text.data(), end, time);
        if (got.ec != std::errc{} || got.ptr != end || !(time >= 0.0 && time <= kLongest))
            refuse(fmt::format("--times '{}': must be times of 0 to 100000 s, with commas",
                               printable(text)));
        if (!options.times.empty() && time <= options.times.back())
            refuse(fmt::format("--times: {} does not come after {}; the times must rise", time,
                               options.times.back()));
        options.times.push_back(time);
    }
    if (options.times.size() > 100)
        refuse(fmt::format("--times: {} of them; at most 100", options.times.size()));
}

/// What is written besides frames, and how large a film may be.
void checkDelivery(Options& options, const RawOptions& raw) {
    if (!raw.maxSize.empty()) {
        options.maxSize = bytesFrom(raw.maxSize);
        if (!options.maxSize)
            refuse(
                fmt::format("--max-size '{}': must be 1K to 1000G bytes, for example 8M "
                            "(8 000 000)",
                            printable(raw.maxSize)));
    }
    if (options.posterTime && options.poster.empty())
        refuse("--poster-time belongs to --poster; name a file for it");
    if (options.posterTime && !(*options.posterTime >= 0.0 && *options.posterTime <= kLongest))
        refuse(fmt::format("--poster-time {}: must be 0 to 100000 s", *options.posterTime));
    checkRange("--moments", options.moments, 1, 100);
    checkRange("--columns", options.columns, 0, 100);
    checkTimes(options, raw.times);
}

std::vector<std::string> contextNames() {
    std::vector<std::string> names{nameOf(render::ContextKind::automatic)};
    for (const render::ContextKind kind : render::contextKinds()) names.emplace_back(nameOf(kind));
    return names;
}

/// Slides have a ground, as their command says to who asks for none.
void checkTheme(const Options& options) {
    std::vector<std::string> names = themeNames();
    if (options.command == Command::slides && options.theme != "transparent")
        std::erase(names, "transparent");
    checkName("--theme", options.theme, names);
}

void checkPicture(Options& options, const RawOptions& raw) {
    checkName("--quality", options.quality, qualityNames());
    checkName("--context", options.context, contextNames());
    if (!options.theme.empty()) checkTheme(options);
    if (!options.colorBy.empty()) checkName("--colour-by", options.colorBy, colorings());
    for (const std::string& name : raw.show) checkName("--show", name, overlayNames());
    options.show = raw.show;
    for (const std::string& name : raw.passes) checkName("--pass", name, passNames());
    options.passes = raw.passes;
    for (const std::string& name : raw.what) checkName("--what", name, measureNames());
    options.what = raw.what;
    if (!raw.size.empty()) {
        options.size = sizeFrom(raw.size);
        if (!options.size)
            refuse(fmt::format("--size '{}': must be WIDTHxHEIGHT, for example 1280x720",
                               printable(raw.size)));
        checkRange("--size: a width of", options.size->width, 1, 16384);
        checkRange("--size: a height of", options.size->height, 1, 16384);
    }
    if (options.fps) checkRange("--fps", *options.fps, 1, 1000);
    if (options.samples) checkSamples(*options.samples);
    if (options.blur) checkRange("--blur", *options.blur, 1, 256);
    if (options.shutter && !(*options.shutter >= 0.0 && *options.shutter <= 1.0))
        refuse(fmt::format("--shutter {}: must be 0 to 1", *options.shutter));
    checkRange("--jobs", options.jobs, 0, 256);
}

/// Widths that are no slip of the keys: a postage stamp to a poster.
void checkWidth(Options& options, const std::string& text) {
    constexpr double kLeast = 10.0, kMost = 2000.0;  // mm
    options.width = lengthFrom(text);
    if (!options.width)
        refuse(fmt::format("--width '{}': must be a length on paper, for example 85mm, 8.5cm, 3.35in "
                           "or 241pt",
                           printable(text)));
    if (!(*options.width >= kLeast && *options.width <= kMost))
        refuse(fmt::format("--width '{}': must be {:g}mm to {:g}mm", printable(text), kLeast, kMost));
    const int pixels = paperOf(options).pixels();
    if (pixels > render::kLargestSide)
        refuse(fmt::format("--width '{}' at {} dpi is {} pixels; at most {}: use --dpi {}",
                           printable(text), options.dpi, pixels, render::kLargestSide,
                           static_cast<int>(render::kLargestSide * 25.4 / *options.width)));
}

void checkFigure(Options& options, const RawOptions& raw) {
    if (raw.dpi) {
        if (raw.width.empty()) refuse("--dpi belongs to --width; give one, for example --width 85mm");
        checkRange("--dpi", *raw.dpi, 72, 2400);
        options.dpi = *raw.dpi;
    }
    if (!raw.width.empty()) checkWidth(options, raw.width);
}

}  // namespace

void refuse(const std::string& line) { throw Stop(Exit::usage, line); }

void checkOptions(Options& options, const RawOptions& raw) {
    checkPicture(options, raw);
    checkDelivery(options, raw);
    if (options.seconds && !(*options.seconds > 0.0 && *options.seconds <= kLongest))
        refuse(fmt::format("--seconds {}: must be above 0 and at most 100000", *options.seconds));
    if (options.time && !(*options.time >= 0.0 && *options.time <= kLongest))
        refuse(fmt::format("--time {}: must be 0 to 100000 s", *options.time));
    checkFigure(options, raw);
    checkRange("--every", options.every, 1, 1'000'000'000);
    checkRange("--hash-every", options.hashEvery, 0, 1'000'000'000);
    if (options.command == Command::completion) checkName("shell", options.shell, {"bash"});
    if (!options.measure.empty() && measureCalled(options.measure) < 0) {
        std::vector<std::string> names;
        for (const Measure& measure : measures()) names.emplace_back(measure.name);
        checkName("--measure", options.measure, names);
    }
    if (!options.update.empty())
        checkName("--update", options.update, {"missing", "changed", "all", "none"});
    if (options.exact && options.sweeps.empty())
        refuse("--exact belongs to --sweeps; name a file for them");
    for (const std::string& text : options.overrides)
        if (const std::size_t equals = text.find('=');
            equals == std::string::npos || text.find_first_not_of(' ') == equals)
            refuse(fmt::format("--set '{}': must be KEY=VALUE, for example world.hz=240",
                               printable(text)));
    if (!raw.solver.empty()) options.overrides.push_back("solver.type=" + raw.solver);
}

}  // namespace demos
