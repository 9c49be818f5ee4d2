#include "demos/formulas/math_letters.h"

#include <algorithm>
#include <iterator>

namespace demos {
namespace {

/// The code points of a variant's A, a, 0, capital and small alpha; 0: none.
struct LetterVariant {
    std::string_view name;
    char32_t capitals, smalls, digits, capitalGreek, smallGreek;
};
constexpr LetterVariant kLetterVariants[] = {
    {"bold", 0x1d400, 0x1d41a, 0x1d7ce, 0x1d6a8, 0x1d6c2},
    {"italic", 0x1d434, 0x1d44e, 0, 0x1d6e2, 0x1d6fc},
    {"bold-italic", 0x1d468, 0x1d482, 0, 0x1d71c, 0x1d736},
    {"script", 0x1d49c, 0x1d4b6, 0, 0, 0},
    {"fraktur", 0x1d504, 0x1d51e, 0, 0, 0},
    {"double-struck", 0x1d538, 0x1d552, 0x1d7d8, 0, 0},
    {"sans-serif", 0x1d5a0, 0x1d5ba, 0x1d7e2, 0, 0},
    {"bold-sans-serif", 0x1d5d4, 0x1d5ee, 0x1d7ec, 0x1d756, 0x1d770},
    {"sans-serif-italic", 0x1d608, 0x1d622, 0, 0, 0},
    {"sans-serif-bold-italic", 0x1d63c, 0x1d656, 0, 0x1d790, 0x1d7aa},
    {"monospace", 0x1d670, 0x1d68a, 0x1d7f6, 0, 0},
};

/// Letters that Unicode already had elsewhere: their place in a variant's range is a hole.
struct Older {
    char32_t hole, letter;
};
constexpr Older kOlder[] = {
    {0x1d455, 0x210e}, {0x1d49d, 0x212c}, {0x1d4a0, 0x2130}, {0x1d4a1, 0x2131}, {0x1d4a3, 0x210b},
    {0x1d4a4, 0x2110}, {0x1d4a7, 0x2112}, {0x1d4a8, 0x2133}, {0x1d4ad, 0x211b}, {0x1d4ba, 0x212f},
    {0x1d4bc, 0x210a}, {0x1d4c4, 0x2134}, {0x1d506, 0x212d}, {0x1d50b, 0x210c}, {0x1d50c, 0x2111},
    {0x1d515, 0x211c}, {0x1d51d, 0x2128}, {0x1d53a, 0x2102}, {0x1d53f, 0x210d}, {0x1d545, 0x2115},
    {0x1d547, 0x2119}, {0x1d548, 0x211a}, {0x1d549, 0x211d}, {0x1d551, 0x2124}};

/// `first` + the letter's offset in the range `from`..`to`; 0 if the variant has no such letter.
char32_t placed(char32_t letter, char32_t from, char32_t to, char32_t first) {
    return first != 0 && letter >= from && letter <= to ? first + (letter - from) : 0;
}

char32_t letterIn(const LetterVariant& v, char32_t letter) {
    for (const char32_t found :
         {placed(letter, U'A', U'Z', v.capitals), placed(letter, U'a', U'z', v.smalls),
          placed(letter, U'0', U'9', v.digits), placed(letter, 0x391, 0x3a9, v.capitalGreek),
          placed(letter, 0x3b1, 0x3c9, v.smallGreek)}) {
        if (found == 0) continue;
        for (const Older& older : kOlder)
            if (older.hole == found) return older.letter;
        return found;
    }
    return letter;
}

/// The letter of `from`.. at the same place as `letter` has after `first`; 0: it is not among them.
char32_t replaced(char32_t letter, char32_t first, char32_t from, char32_t to) {
    return first != 0 && letter >= first && letter - first <= to - from ? from + (letter - first)
                                                                        : 0;
}

}  // namespace

void putCharacter(std::string& text, char32_t letter) {
    const int more = letter < 0x80 ? 0 : letter < 0x800 ? 1 : letter < 0x10000 ? 2 : 3;
    constexpr unsigned kFirst[] = {0, 0xc0, 0xe0, 0xf0};
    text += static_cast<char>(kFirst[more] | letter >> (6 * more));
    for (int i = more - 1; i >= 0; --i)
        text += static_cast<char>(0x80u | (letter >> (6 * i) & 0x3fu));
}

PlainLetter plainLetterOf(char32_t letter) {
    for (const Older& older : kOlder)
        if (older.letter == letter && older.hole < kLetterVariants[3].capitals) letter = older.hole;
    for (std::size_t i = 0; i < 3; ++i) {  // bold, italic, both
        const LetterVariant& v = kLetterVariants[i];
        for (const char32_t found :
             {replaced(letter, v.capitals, U'A', U'Z'), replaced(letter, v.smalls, U'a', U'z'),
              replaced(letter, v.digits, U'0', U'9'),
              replaced(letter, v.capitalGreek, 0x391, 0x3a9),
              replaced(letter, v.smallGreek, 0x3b1, 0x3c9)})
            if (found != 0) return {found, i != 1, i != 0};
    }
    return {letter, false, false};
}

char32_t popCharacter(std::string_view& text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(0);
    const std::size_t wanted = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : first >= 0xc0 ? 2 : 1;
    const std::size_t length = std::min(wanted, text.size());
    char32_t letter = length == 1 ? first : first & (0xffu >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) letter = letter << 6 | (byte(i) & 0x3fu);
    text.remove_prefix(length);
    return letter;
}

std::string inVariant(std::string_view text, std::string_view variant) {
    const LetterVariant* found =
        std::find_if(std::begin(kLetterVariants), std::end(kLetterVariants),
                     [&](const LetterVariant& v) { return v.name == variant; });
    if (found == std::end(kLetterVariants)) return std::string(text);
    std::string result;
    while (!text.empty()) putCharacter(result, letterIn(*found, popCharacter(text)));
    return result;
}

}  // namespace demos
