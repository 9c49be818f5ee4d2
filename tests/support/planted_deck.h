/// Decks with pictures and films of known contents, for tests of the writers of decks.
#pragma once
#include <cstdlib>
#include <string>

#include "demos/slides/made_deck.h"
#include "tests/support/planted_report.h"

namespace support {

inline constexpr int kFilmFrames = 24;
inline constexpr int kFilmFps = 30;

inline demos::MadePicture plantedDeckPicture(int width, int height, std::uint8_t level) {
    demos::MadePicture picture;
    picture.png = render::encodePng(flatImage(width, height, level));
    picture.size = {width, height};
    picture.says = "a grey field";
    return picture;
}

/// The grey level of frame n.
inline std::uint8_t plantedLevel(int frame) { return static_cast<std::uint8_t>(30 + 8 * frame); }

/// `file` need not exist for tests that only pass it on.
inline demos::MadeFilm plantedFilm(const std::filesystem::path& file) {
    demos::MadeFilm film;
    film.file = file;
    film.frames = kFilmFrames;
    film.fps = kFilmFps;
    film.first = 2.0;
    film.secondsAFrame = 0.01;
    film.poster = plantedDeckPicture(64, 36, plantedLevel(kFilmFrames - 1));
    return film;
}

/// Writes a real film with ffmpeg: video levels 16..235 are 0..255 on the screen.
inline bool writePlantedFilm(const std::filesystem::path& file) {
    const std::string command =
        "ffmpeg -v error -y -f lavfi -i \"color=black:s=64x36:r=30:d=0.8,format=yuv420p,"
        "geq=lum='16+(30+8*N)*219/255':cb=128:cr=128\" -c:v libx264 -crf 8 -pix_fmt yuv420p '" +
        file.string() + "' 2>/dev/null";
    return std::system(command.c_str()) == 0;
}

inline demos::MadeSlide plantedSlide(const std::string& id, const std::string& title) {
    demos::MadeSlide made;
    made.slide.id = id;
    made.slide.title = title;
    return made;
}

/// Opening; a film that waits; one that loops, next to a chart; words, formulas, code and a table.
inline demos::MadeDeck plantedDeck(const std::filesystem::path& film) {
    demos::MadeDeck deck;
    deck.deck.name = "talk";
    deck.deck.title = "A talk";
    deck.deck.subtitle = "of *four* slides";
    deck.deck.author = "N. N.";
    deck.slides.push_back(plantedSlide("01-opening", ""));
    deck.slides.back().slide.opening = true;
    deck.slides.back().slide.notes = "Be **calm**.";
    deck.slides.push_back(plantedSlide("02-waits", "It waits"));
    deck.slides.back().film = plantedFilm(film);
    deck.slides.back().slide.pause = true;
    deck.slides.back().slide.caption = "with $\\lambda$";
    deck.slides.back().command = "impulse render stack";
    deck.slides.push_back(plantedSlide("03-loops", "It loops"));
    deck.slides.back().film = plantedFilm(film);
    deck.slides.back().slide.loop = true;
    deck.slides.back().slide.text = "- words\n- beside";
    deck.slides.back().pictures.push_back(plantedDeckPicture(90, 50, 200));
    deck.slides.back().pictures.back().svg =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"90\" height=\"50\"/>";
    deck.slides.push_back(plantedSlide("04-words", "Words"));
    deck.slides.back().slide.text = "One row $J\\mathbf{v} + b = 0$ at 5 % & more_.";
    deck.slides.back().slide.formulas = {"\\lambda = -\\frac{J v + b}{J M^{-1} J^T}"};
    deck.slides.back().slide.code = "for row in rows:\n    solve(row)  # {50%}";
    deck.slides.back().tables = {
        {{"case", "drift"}, {{"20 sweeps", "12.3 mm"}, {"a_b & c", "-0.4 mm"}}}};
    deck.slides.back().slide.notes = "The last.";
    for (const demos::MadeSlide& made : deck.slides) deck.deck.slides.push_back(made.slide);
    return deck;
}

}  // namespace support
