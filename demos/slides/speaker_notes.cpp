#include <fmt/format.h>

#include "demos/slides/deck_files.h"
#include "demos/slides/markup.h"

namespace demos {

std::string speakerNotesOf(const MadeDeck& made) {
    std::string text = "# " + made.deck.title + "\n";
    for (std::size_t i = 0; i < made.slides.size(); ++i) {
        const MadeSlide& slide = made.slides[i];
        const std::string& title =
            slide.slide.opening && slide.slide.title.empty() ? made.deck.title : slide.slide.title;
        text += fmt::format("\n## {}. {}\n", i + 1, title.empty() ? slide.slide.id : title);
        if (!slide.slide.notes.empty())
            text += "\n" + slide.slide.notes + (slide.slide.notes.ends_with('\n') ? "" : "\n");
        if (!slide.command.empty()) text += "\n    " + slide.command + "\n";
    }
    return text;
}

}  // namespace demos
