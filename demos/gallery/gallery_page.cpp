#include "demos/gallery/gallery_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "demos/text/page_text.h"
#include "demos/text/rounded.h"
#include "demos/text/script_safe.h"
#include "demos/text/version.h"

namespace demos {
namespace {

using Json = nlohmann::ordered_json;

Json shownOf(const GalleryCard& card) {
    return {{"name", card.name},       {"file", card.file},
            {"group", card.group},     {"title", card.title},
            {"purpose", card.purpose}, {"seconds", rounded(card.seconds, 6)},
            {"bodies", card.bodies},   {"joints", card.joints},
            {"hz", card.hz},           {"width", card.width},
            {"height", card.height},   {"posterTime", rounded(card.posterTime, 6)},
            {"film", card.film},       {"replay", card.replay}};
}

void add(const char* name, const auto& value, std::vector<std::string>& words) {
    if (value) words.insert(words.end(), {name, fmt::format("{}", *value)});
}

std::optional<std::string> asked(const std::string& text) {
    return text.empty() ? std::nullopt : std::optional(text);
}

}  // namespace

GalleryWords wordsOf(const GalleryOptions& options) {
    GalleryWords words;
    for (const std::string& one : options.overrides)
        words.run.insert(words.run.end(), {"--set", one});
    add("--seconds", options.seconds, words.run);
    if (options.qualityAsked) add("--quality", std::optional(options.quality), words.picture);
    if (options.size)
        add("--size",
            std::optional(fmt::format("{}x{}", options.size->width, options.size->height)),
            words.picture);
    add("--fps", options.fps, words.picture);
    add("--samples", options.samples, words.picture);
    add("--blur", options.blur, words.picture);
    add("--shutter", options.shutter, words.picture);
    add("--show", asked(fmt::format("{}", fmt::join(options.show, ","))), words.picture);
    add("--theme", asked(options.theme), words.picture);
    add("--color-by", asked(options.colorBy), words.picture);
    if (options.clean) words.picture.push_back("--clean");
    if (options.reproducible) words.picture.push_back("--reproducible");
    return words;
}

std::string galleryPage(const std::vector<GalleryCard>& cards, const std::string& renderer,
                        const GalleryWords& words, const std::vector<GalleryLink>& links) {
    Json page{{"version", kVersion}, {"renderer", renderer}, {"scenes", Json::array()}};
    page["options"] = {{"run", words.run}, {"picture", words.picture}};
    page["links"] = Json::array();
    for (const GalleryLink& link : links) page["links"].push_back({link.text, link.address});
    for (const GalleryCard& card : cards) page["scenes"].push_back(shownOf(card));
    const PageText text = galleryPageText();
    return text.before + scriptSafe(page) + text.after;
}

}  // namespace demos
