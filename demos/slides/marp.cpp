// The talk as Markdown for Marp, which writes formulas in the same way: $x$ and $$x$$.
#include <fmt/format.h>

#include <string_view>

#include "demos/film/progress.h"
#include "demos/slides/deck_files.h"
#include "demos/slides/markup.h"
#include "demos/slides/slide_media.h"
#include "demos/slides/table_columns.h"

namespace demos {
namespace {

/// Uses JSON strings, which are YAML strings too.
std::string frontMatter(const Deck& deck) {
    return fmt::format(
        "---\nmarp: true\ntitle: {}\nauthor: {}\nmath: katex\npaginate: true\nsize: 16:9\n{}---\n",
        jsonString(plainOf(deck.title)), jsonString(deck.author),
        deck.theme == "dark" ? "class: invert\n" : "");
}

std::string escapedCell(const std::string& text) {
    constexpr std::string_view kMarks = "|\\`*_<>[]$#~";
    std::string cell;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool entity = text[i] == '&' && i + 1 < text.size() && text[i + 1] != ' ';
        if (entity || kMarks.find(text[i]) != std::string_view::npos) cell += '\\';
        cell += text[i];
    }
    return cell;
}

std::string tableMarkdown(const MadeTable& table) {
    const auto row = [](const std::vector<std::string>& cells) {
        std::string line = "|";
        for (const std::string& cell : cells) line += " " + escapedCell(cell) + " |";
        return line + "\n";
    };
    std::string text = row(table.head) + "|";
    for (const bool number : numberColumns(table)) text += number ? "---:|" : "---|";
    text += "\n";
    for (const std::vector<std::string>& cells : table.rows) text += row(cells);
    return text;
}

/// A fence longer than any run of backticks in the code.
std::string fenceFor(const std::string& code) {
    std::string fence = "```";
    while (code.find(fence) != std::string::npos) fence += '`';
    return fence;
}

std::string wordsOf(const MadeSlide& made) {
    const Slide& slide = made.slide;
    std::string text;
    if (!slide.text.empty())
        text += (slide.reveal ? markdownStepsOf : markdownOf)(slide.text) + "\n\n";
    for (const std::string& formula : slide.formulas) text += "$$\n" + formula + "\n$$\n\n";
    if (!slide.code.empty()) {
        const std::string fence = fenceFor(slide.code);
        text +=
            fence + "\n" + slide.code + (slide.code.ends_with('\n') ? "" : "\n") + fence + "\n\n";
    }
    for (const MadeTable& table : made.tables) text += tableMarkdown(table) + "\n";
    return text;
}

/// Removes brackets, at which a description ends, and what begins code, HTML or a formula.
std::string alt(const MadePicture& picture) {
    std::string text;
    for (const char c : picture.says)
        if (std::string_view("[]\\\n`<$").find(c) == std::string_view::npos) text += c;
    return text;
}

std::string picturesMarkdown(const MadeSlide& made, bool words) {
    const std::vector<const MadePicture*> pictures = picturesOf(made);
    std::string text;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const std::string name = pictureName(made, i, pictures[i]->svg.empty() ? "png" : "svg");
        if (i == 0 && hasFilm(made))
            text += fmt::format("<video src=\"{}\" poster=\"{}\" controls muted{}></video>\n\n",
                                filmName(made), name, made.slide.loop ? " loop" : "");
        else if (words)
            text += fmt::format("![bg right:55% contain {}]({})\n\n", alt(*pictures[i]), name);
        else
            text += fmt::format("![h:{} {}]({})\n\n", pictures.size() > 1 ? 260 : 500,
                                alt(*pictures[i]), name);
    }
    return text;
}

/// Breaks up each "-->", which would end the comment.
std::string commentOf(const std::string& notes) {
    std::string text;
    for (const char c : notes) {
        if (c == '>' && text.ends_with("--")) text += ' ';
        text += c;
    }
    return "<!--\n" + text + (text.ends_with('\n') ? "" : "\n") + "-->\n";
}

std::string openingOf(const Deck& deck, const MadeSlide& made) {
    const std::string& title = made.slide.title.empty() ? deck.title : made.slide.title;
    std::string text = "# " + markdownInlineOf(title) + "\n\n";
    if (!deck.subtitle.empty()) text += markdownInlineOf(deck.subtitle) + "\n\n";
    for (const std::string* part : {&deck.author, &deck.date})
        if (!part->empty()) text += markdownEscaped(*part) + "\n\n";
    return text;
}

std::string slideOf(const Deck& deck, const MadeSlide& made) {
    const std::string words = wordsOf(made);
    std::string text;
    if (made.slide.opening)
        text += openingOf(deck, made);
    else if (!made.slide.title.empty())
        text += "## " + markdownInlineOf(made.slide.title) + "\n\n";
    text += words + picturesMarkdown(made, !words.empty());
    if (!made.slide.caption.empty()) text += markdownInlineOf(made.slide.caption) + "\n\n";
    if (!made.slide.notes.empty()) text += commentOf(made.slide.notes);
    return text;
}

}  // namespace

std::string marpOf(const MadeDeck& made) {
    std::string text = frontMatter(made.deck);
    for (std::size_t i = 0; i < made.slides.size(); ++i)
        text += (i == 0 ? "\n" : "\n---\n\n") + slideOf(made.deck, made.slides[i]);
    return text;
}

}  // namespace demos
