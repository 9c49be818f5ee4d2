#include "demos/gallery/gallery_page.h"

#include <nlohmann/json.hpp>

#include "demos/page/page_text.h"
#include "demos/page/rounded.h"
#include "demos/page/script_safe.h"
#include "demos/version.h"

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
            {"film", card.film}};
}

}  // namespace

std::string galleryPage(const std::vector<GalleryCard>& cards, const std::string& renderer) {
    Json page{{"version", kVersion}, {"renderer", renderer}, {"scenes", Json::array()}};
    for (const GalleryCard& card : cards) page["scenes"].push_back(shownOf(card));
    const PageText text = galleryPageText();
    return text.before + scriptSafe(page) + text.after;
}

}  // namespace demos
