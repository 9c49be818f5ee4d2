#include <fmt/format.h>

#include "demos/look/inks.h"
#include "demos/slides/deck_files.h"
#include "demos/slides/linked_page.h"
#include "demos/slides/markup.h"
#include "demos/slides/math_font.h"
#include "demos/slides/slide_html.h"
#include "demos/text/page_text.h"

namespace demos {
namespace {

/// The page has the same background as charts, so that these have no visible edge.
std::string inksStyle(const std::string& theme) {
    const Inks inks = inksOf(theme);
    return fmt::format(":root {{ --ground: {}; --ink: {}; --muted: {}; --grid: {}; --axis: {}; }}",
                       hexOf(inks.ground), hexOf(inks.ink), hexOf(inks.muted), hexOf(inks.grid),
                       hexOf(inks.axis));
}

void replaceAll(std::string& text, const std::string& mark, const std::string& by) {
    for (std::size_t at = text.find(mark); at != text.npos; at = text.find(mark, at + by.size()))
        text.replace(at, mark.size(), by);
}

std::string authorTag(const std::string& author) {
    if (author.empty()) return {};
    return "\n<meta name=\"author\" content=\"" + htmlEscaped(author) + "\">";
}

/// Pictures without content keep their places.
SlideMedia blankMedia(const MadeSlide& slide) {
    return {"", std::vector<std::string>(picturesOf(slide).size(), "data:,")};
}

using MediaOf = SlideMedia (*)(const MadeSlide&);

std::string pageOf(const MadeDeck& made, MediaOf mediaOf, const char* sources) {
    std::string slides;
    for (std::size_t i = 0; i < made.slides.size(); ++i)
        slides += slideHtml(made.deck, made.slides[i], i + 1, mediaOf(made.slides[i]));
    const bool formulas = slides.find("<math") != slides.npos;
    PageText text = slidesPageText();
    replaceAll(text.before, "@sources@", sources);
    replaceAll(text.before, "@font@", formulas ? mathFontStyle() : "");
    replaceAll(text.before, "@inks@", inksStyle(made.deck.theme));
    replaceAll(text.before, "@theme@", made.deck.theme);
    replaceAll(text.before, "</title>", "</title>" + authorTag(made.deck.author));
    // Last, since a title may contain one of the other marks.
    replaceAll(text.before, "@title@", htmlEscaped(titleTextOf(made.deck.title)));
    return text.before + slides + text.after;
}

}  // namespace

std::string hexOf(const render::Color& color) {
    const auto level = [](float channel) { return static_cast<int>(255.0f * channel + 0.5f); };
    return fmt::format("#{:02x}{:02x}{:02x}", level(color.r), level(color.g), level(color.b));
}

std::string mathFontStyle() {
    if (mathFont().empty()) return {};
    return "@font-face { font-family: \"impulse math\"; src: url(data:font/woff2;base64," +
           mathFont() + ") format(\"woff2\"); }";
}

std::string slidesPage(const MadeDeck& deck) { return pageOf(deck, embeddedMedia, "data:"); }

std::string blankSlidesPage(const MadeDeck& deck) { return pageOf(deck, blankMedia, "data:"); }

std::string linkedSlidesPage(const MadeDeck& deck) {
    return pageOf(deck, linkedMedia, "'self' file:");
}

}  // namespace demos
