#include "demos/slides/slide_html.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/formulas/formula.h"
#include "demos/slides/markup.h"
#include "demos/slides/slide_layout.h"
#include "demos/slides/table_columns.h"

namespace demos {
namespace {

constexpr double kWidest = 100.0;
constexpr std::size_t kLongCell = 30;  // bytes: longer words may be broken into lines

const char* classOf(SlideLayout layout) {
    switch (layout) {
        case SlideLayout::opening:
            return "opening";
        case SlideLayout::openingPictured:
            return "opening pictured";
        case SlideLayout::plain:
            return "plain";
        case SlideLayout::full:
            return "full";
        case SlideLayout::beside:
            return "beside";
        case SlideLayout::even:
            return "beside even";
        case SlideLayout::below:
            break;
    }
    return "below";
}

std::string tableHtml(const MadeTable& table) {
    const std::vector<bool> numbers = numberColumns(table);
    const auto cell = [&](const char* tag, const std::string& text, std::size_t column) {
        const bool number = column < numbers.size() && numbers[column];
        const char* kind = number                    ? " class=\"n\""
                           : text.size() > kLongCell ? " class=\"long\""
                                                     : "";
        return fmt::format("<{0}{1}>{2}</{0}>", tag, kind, htmlEscaped(text));
    };
    std::string html = "<table><thead><tr>";
    for (std::size_t i = 0; i < table.head.size(); ++i) html += cell("th", table.head[i], i);
    html += "</tr></thead><tbody>";
    for (const std::vector<std::string>& row : table.rows) {
        html += "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i) html += cell("td", row[i], i);
        html += "</tr>";
    }
    return html + "</tbody></table>";
}

std::string wordsHtml(const MadeSlide& made) {
    const Slide& slide = made.slide;
    std::string html;
    if (!slide.text.empty()) html += "<div class=\"text\">" + htmlOf(slide.text) + "</div>";
    if (!slide.formulas.empty()) {
        html += "<div class=\"formulas\">";
        for (const std::string& formula : slide.formulas)
            html += "<div class=\"formula\">" + mathMlOf(formula, true) + "</div>";
        html += "</div>";
    }
    if (!slide.code.empty())
        html += "<pre tabindex=\"0\"><code>" + htmlEscaped(slide.code) + "</code></pre>";
    if (!made.tables.empty()) {
        html += "<div class=\"tables\">";
        for (const MadeTable& table : made.tables) html += tableHtml(table);
        html += "</div>";
    }
    return html;
}

std::string filmHtml(const MadeSlide& made, const std::string& address) {
    const MadeFilm& film = *made.film;
    return fmt::format(
        "<video data-film=\"{}\" data-fps=\"{}\" data-frames=\"{}\" data-first=\"{:.9g}\" "
        "data-step=\"{:.9g}\" data-pause=\"{}\" muted playsinline preload=\"auto\"{} "
        "aria-label=\"{}\"></video>",
        htmlEscaped(address), film.fps, film.frames, film.first, film.secondsAFrame,
        made.slide.pause ? 1 : 0, made.slide.loop ? " loop" : "", htmlEscaped(film.poster.says));
}

constexpr const char* kFilmMarks =
    "<button class=\"wait\" tabindex=\"-1\" aria-label=\"play\"><svg viewBox=\"0 0 16 16\">"
    "<path d=\"M4 2.5v11l9-5.5z\"/></svg></button><div class=\"run\"><i></i></div>";

/// Centres the last row if it is not full; cells are two columns wide.
std::string placeOf(std::size_t i, std::size_t count, const PictureGrid& grid) {
    const int empty = emptyCells(count, grid);
    const bool first = static_cast<int>(i) == (grid.rows - 1) * grid.columns;
    return first && empty > 0 ? fmt::format(" style=\"--from:{}\"", empty + 1) : "";
}

std::string exhibitHtml(const MadeSlide& made, const SlideMedia& media, std::size_t i,
                        const std::string& place) {
    const MadePicture& picture = *picturesOf(made)[i];
    const bool film = i == 0 && !media.film.empty();
    return fmt::format(
        "<div class=\"exhibit\"{}><div class=\"frame\" style=\"--aspect:{:.5f}\">{}"
        "<img{} src=\"{}\" alt=\"{}\">{}</div></div>",
        place, aspectOf(picture), film ? filmHtml(made, media.film) : "",
        film ? " class=\"poster\"" : "", htmlEscaped(media.pictures[i]), htmlEscaped(picture.says),
        film ? kFilmMarks : "");
}

std::string showHtml(const MadeSlide& made, const SlideMedia& media) {
    const std::size_t count = media.pictures.size();
    if (count == 0) return {};
    double aspect = kWidest;  // of the tallest
    for (const MadePicture* picture : picturesOf(made))
        aspect = std::min(aspect, aspectOf(*picture));
    const PictureGrid grid = gridOf(count, aspect, pictureRoom(layoutOf(made), widthOf(made.tables)));
    std::string html = fmt::format(
        "<figure class=\"show\"><div class=\"pictures\" "
        "style=\"--aspect:{:.5f};--rows:{};--columns:{}\">",
        aspect, grid.rows, grid.columns);
    for (std::size_t i = 0; i < count; ++i)
        html += exhibitHtml(made, media, i, placeOf(i, count, grid));
    html += "</div>";
    if (!made.slide.caption.empty())
        html +=
            "<figcaption class=\"caption\">" + htmlInlineOf(made.slide.caption) + "</figcaption>";
    return html + "</figure>";
}

/// The caption of a slide without pictures.
std::string lonelyCaption(const MadeSlide& made) {
    if (made.slide.caption.empty() || !picturesOf(made).empty()) return {};
    return "<p class=\"caption\">" + htmlInlineOf(made.slide.caption) + "</p>";
}

std::string bodyHtml(const MadeSlide& made, const SlideMedia& media) {
    const std::string words = wordsHtml(made) + lonelyCaption(made), show = showHtml(made, media);
    if (words.empty() && show.empty()) return {};
    return fmt::format("<div class=\"body\">{}{}</div>",
                       words.empty() ? "" : "<div class=\"words\">" + words + "</div>", show);
}

std::string openingHtml(const Deck& deck, const MadeSlide& made, const SlideMedia& media) {
    const std::string& title = made.slide.title.empty() ? deck.title : made.slide.title;
    std::string html = "<h1 tabindex=\"-1\">" + htmlInlineOf(title) + "</h1>";
    if (!deck.subtitle.empty())
        html += "<p class=\"under\">" + htmlInlineOf(deck.subtitle) + "</p>";
    std::string by;
    for (const std::string* part : {&deck.author, &deck.date})
        if (!part->empty()) by += "<span>" + htmlEscaped(*part) + "</span>";
    if (!by.empty()) html += "<p class=\"by\">" + by + "</p>";
    return html + bodyHtml(made, media);
}

std::string titleHtml(const MadeSlide& made) {
    if (made.slide.title.empty()) return {};
    return "<h2 tabindex=\"-1\">" + htmlInlineOf(made.slide.title) + "</h2>";
}

std::string notesHtml(const MadeSlide& made) {
    std::string html = htmlOf(made.slide.notes);
    if (!made.command.empty())
        html +=
            "<p class=\"command\">The picture: <code>" + htmlEscaped(made.command) + "</code></p>";
    return html.empty() ? "" : "<aside class=\"notes\">" + html + "</aside>";
}

}  // namespace

std::string slideHtml(const Deck& deck, const MadeSlide& made, std::size_t number,
                      const SlideMedia& media) {
    const std::string title = plainOf(made.slide.title.empty() ? deck.title : made.slide.title);
    const std::string inside = made.slide.opening ? openingHtml(deck, made, media)
                                                  : titleHtml(made) + bodyHtml(made, media);
    return fmt::format(
        "<article class=\"leaf\"><section class=\"slide {}{}\" data-id=\"{}\" role=\"group\" "
        "aria-roledescription=\"slide\" aria-label=\"{}: {}\">{}"
        "<span class=\"number\" aria-hidden=\"true\">{} / {}</span></section>{}</article>\n",
        classOf(layoutOf(made)), made.slide.reveal ? " steps" : "", htmlEscaped(made.slide.id), number, htmlEscaped(title), inside,
        number, deck.slides.size(), notesHtml(made));
}

}  // namespace demos
