#include "demos/slides/toml_position.h"

#include <charconv>

namespace demos {
namespace {

/// Walks through a file's characters.
class Cursor {
public:
    Cursor(std::string_view source, Place from) : rest_(source), place_{1, 1, from.file} {
        while (!atEnd() && (place_.line < from.line || place_.column < from.column)) {
            if (place_.line == from.line && next('\n')) break;
            skip(1);
        }
    }

    bool atEnd() const { return rest_.empty(); }
    bool next(char c) const { return rest_.starts_with(c); }
    bool next(std::string_view text) const { return rest_.starts_with(text); }
    std::string_view rest() const { return rest_; }
    Place place() const { return place_; }

    /// Columns count characters, not bytes.
    void skip(std::size_t bytes) {
        for (; bytes > 0 && !atEnd(); --bytes) {
            const bool newline = next('\n');
            rest_.remove_prefix(1);
            const bool within =
                !atEnd() && (static_cast<unsigned char>(rest_.front()) & 0xc0u) == 0x80u;
            if (newline)
                ++place_.line, place_.column = 1;
            else if (!within)
                ++place_.column;
        }
    }

private:
    std::string_view rest_;
    Place place_;
};

/// Moves the cursor to the first byte of a string's text; returns the quote, or 0 if there is none.
char openQuotes(Cursor& cursor) {
    const char quote = cursor.next('"') ? '"' : cursor.next('\'') ? '\'' : '\0';
    if (!quote) return quote;
    if (!cursor.next(quote == '"' ? "\"\"\"" : "'''")) {
        cursor.skip(1);
        return quote;
    }
    cursor.skip(3);
    if (cursor.next("\r\n")) cursor.skip(1);
    if (cursor.next('\n')) cursor.skip(1);
    return quote;
}

/// Bytes of a code point in UTF-8.
std::size_t utf8Length(std::string_view hex) {
    unsigned code = 0;
    std::from_chars(hex.data(), hex.data() + hex.size(), code, 16);
    return code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
}

/// A backslash before a line end: skips the rest of the line and all space after it.
bool takeLeftOut(Cursor& cursor) {
    constexpr std::string_view kSpace = " \t\r\n";
    if (!cursor.next('\\') || cursor.rest().find_first_of(kSpace, 1) != 1) return false;
    const std::size_t text = cursor.rest().find_first_not_of(kSpace, 1);
    cursor.skip(text == std::string_view::npos ? cursor.rest().size() : text);
    return true;
}

/// Skips the source of the text's next bytes; returns the number of these bytes.
std::size_t take(Cursor& cursor, char quote) {
    if (quote == '"' && cursor.next('\\')) {
        cursor.skip(1);
        const std::size_t digits = cursor.next('u') ? 4 : cursor.next('U') ? 8 : 0;
        const std::size_t made = digits > 0 ? utf8Length(cursor.rest().substr(1, digits)) : 1;
        cursor.skip(1 + digits);
        return made;
    }
    const bool carriage = cursor.next("\r\n");  // TOML's newline is one byte
    cursor.skip(carriage ? 2 : 1);
    return 1;
}

/// Where a byte of a string is in the file; without a quote if it cannot be found.
struct Spot {
    Cursor cursor;
    char quote;
};

Spot spotOf(const TomlPosition& position, std::size_t byte) {
    Spot spot{Cursor(position.source, position.place), '\0'};
    spot.quote = openQuotes(spot.cursor);
    if (!spot.quote) return spot;
    const auto passLeftOut = [&] {
        while (spot.quote == '"' && takeLeftOut(spot.cursor)) continue;
    };
    passLeftOut();
    for (std::size_t done = 0; done < byte && !spot.cursor.atEnd(); passLeftOut())
        done += take(spot.cursor, spot.quote);
    return spot;
}

}  // namespace

Place placeIn(const TomlPosition& position, std::size_t byte) {
    if (position.place.line < 1) return position.place;
    const Spot spot = spotOf(position, byte);
    return spot.quote ? spot.cursor.place() : position.place;
}

bool isEscape(const TomlPosition& position, std::size_t byte) {
    if (position.place.line < 1) return false;
    const Spot spot = spotOf(position, byte);
    return spot.quote == '"' && spot.cursor.next('\\');
}

}  // namespace demos
