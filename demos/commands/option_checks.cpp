#include "demos/commands/option_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "demos/film/data_pass.h"
#include "demos/film/quality.h"
#include "demos/look/length.h"
#include "demos/look/overlays.h"
#include "demos/look/theme.h"
#include "demos/measures/measures.h"
#include "demos/measures/summary.h"
#include "demos/options/picture_options.h"
#include "demos/text/complaints.h"
#include "demos/text/nearest.h"
#include "demos/text/stop.h"
#include "render/context.h"
#include "render/encode/png.h"

namespace demos {

void checkRange(const char* name, int value, int low, int high) {
    if (value < low || value > high)
        refuse(fmt::format("{} {}: must be {} to {}", name, value, low, high));
}

void checkName(const char* option, const std::string& word, const std::vector<std::string>& names) {
    if (std::find(names.begin(), names.end(), word) == names.end())
        refuse(fmt::format("{} '{}' is not known{}", option, printable(word),
                           suggestion(word, names)));
}

void checkTime(const char* name, const std::optional<double>& time) {
    if (time && !(*time >= 0.0 && *time <= kLongest))
        refuse(fmt::format("{} {}: must be 0 to 100000 s", name, *time));
}

namespace {

std::optional<PictureSize> sizeFrom(const std::string& text) {
    PictureSize size;
    const char* end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.width);
    if (width.ec != std::errc{} || width.ptr == end || *width.ptr != 'x') return std::nullopt;
    const auto height = std::from_chars(width.ptr + 1, end, size.height);
    if (height.ec != std::errc{} || height.ptr != end) return std::nullopt;
    return size;
}

void checkSamples(int samples) {
    for (const int good : {1, 2, 4, 8, 16})
        if (samples == good) return;
    refuse(fmt::format("--samples {}: must be 1, 2, 4, 8 or 16", samples));
}

std::vector<std::string> contextNames() {
    std::vector<std::string> names{nameOf(render::ContextKind::automatic)};
    for (const render::ContextKind kind : render::contextKinds()) names.emplace_back(nameOf(kind));
    return names;
}

/// Slides lack two themes; "transparent" passes here: they refuse it themselves, with the reason.
void checkTheme(const Options& options, bool ofSlides) {
    std::vector<std::string> names = themeNames();
    if (ofSlides) std::erase(names, "lab");
    if (ofSlides && options.theme != "transparent") std::erase(names, "transparent");
    checkName("--theme", options.theme, names);
}

void checkPicture(Options& options, const OptionTexts& texts) {
    checkName("--quality", options.quality, qualityNames());
    checkName("--context", options.context, contextNames());
    if (!options.theme.empty()) checkTheme(options, texts.ofSlides);
    if (!options.colorBy.empty()) checkName("--colour-by", options.colorBy, colorings());
    for (const std::string& name : texts.show) checkName("--show", name, overlayNames());
    options.show = texts.show;
    if (!texts.size.empty()) {
        options.size = sizeFrom(texts.size);
        if (!options.size)
            refuse(fmt::format("--size '{}': must be WIDTHxHEIGHT, for example 1280x720",
                               printable(texts.size)));
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

/// Accepts widths from a postage stamp to a poster; others are most likely typing errors.
void checkWidth(Options& options, const std::string& text) {
    constexpr double kLeast = 10.0, kMost = 2000.0;  // mm
    options.width = lengthFrom(text);
    if (!options.width)
        refuse(
            fmt::format("--width '{}': must be a length on paper, for example 85mm, 8.5cm, 3.35in "
                        "or 241pt",
                        printable(text)));
    if (!(*options.width >= kLeast && *options.width <= kMost))
        refuse(
            fmt::format("--width '{}': must be {:g}mm to {:g}mm", printable(text), kLeast, kMost));
    const int pixels = paperOf(options).pixels();
    if (pixels > render::kLargestSide)
        refuse(fmt::format("--width '{}' at {} dpi is {} pixels; at most {}: use --dpi {}",
                           printable(text), options.dpi, pixels, render::kLargestSide,
                           static_cast<int>(render::kLargestSide * 25.4 / *options.width)));
}

void checkFigure(Options& options, const OptionTexts& texts) {
    if (texts.dpi) {
        if (texts.width.empty())
            refuse("--dpi needs --width, for example --width 85mm");
        checkRange("--dpi", *texts.dpi, 72, 2400);
        options.dpi = *texts.dpi;
    }
    if (!texts.width.empty()) checkWidth(options, texts.width);
}

}  // namespace

std::uint64_t maxSizeFrom(const std::string& given) {
    std::string text = given;
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
    if (!whole || !(number * unit >= 1000.0 && number * unit <= 1e12))
        refuse(fmt::format("--max-size '{}': must be 1K to 1000G bytes, for example 8M (8 000 000)",
                           printable(given)));
    return static_cast<std::uint64_t>(number * unit);
}

void checkOptions(Options& options, const OptionTexts& texts) {
    checkPicture(options, texts);
    if (options.seconds && !(*options.seconds > 0.0 && *options.seconds <= kLongest))
        refuse(fmt::format("--seconds {}: must be above 0 and at most 100000", *options.seconds));
    checkFigure(options, texts);
    for (const std::string& text : options.overrides)
        if (const std::size_t equals = text.find('=');
            equals == std::string::npos || text.find_first_not_of(' ') == equals)
            refuse(fmt::format("--set '{}': must be KEY=VALUE, for example world.hz=240",
                               printable(text)));
    if (!texts.solver.empty()) options.overrides.push_back("solver.type=" + texts.solver);
}

}  // namespace demos
