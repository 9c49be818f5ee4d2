// The gallery's page as text: nothing breaks out of its data, no web address; shrunk pictures.
#include "demos/gallery/gallery_page.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "demos/gallery/gallery_sheet.h"
#include "tests/demos/page_data.h"
#include "tests/support/text.h"

namespace {

using namespace demos;
using support::count;
using test::dataOf;

TEST(GalleryPage, NothingBreaksOutOfItsData) {
    const std::string hostile =
        "</script><script>alert(1)</script><!-- \xe2\x80\xa8 ]]> \" \\ \x01";
    GalleryCard card;
    card.name = card.group = card.title = card.purpose = card.file = hostile;
    const std::string page = galleryPage({card}, hostile, {{hostile}, {hostile}});
    const std::string harmless = galleryPage({}, "", {});
    for (const char* word : {"<script", "</script", "<!--", "\xe2\x80\xa8"})
        EXPECT_EQ(count(page, word), count(harmless, word)) << word;
    EXPECT_EQ(dataOf(page)["scenes"][0]["title"], hostile);
}

TEST(GalleryPage, HasNoAddressAndForbidsAllButItsOwn) {
    const std::string page = galleryPage({}, "", {});
    EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
    const std::string drawing = "http://www.w3.org/2000/svg";  // a name, not a place
    EXPECT_EQ(count(page, "://"), count(page, drawing));
    EXPECT_FALSE(std::regex_search(page, std::regex("@(style|script|data)@")));
}

/// Only the options that were given, so that a card's command makes what the card shows.
TEST(GalleryPage, KnowsTheOptionsOfItsCommand) {
    GalleryOptions options;
    EXPECT_TRUE(wordsOf(options).run.empty());
    EXPECT_TRUE(wordsOf(options).picture.empty());
    options.overrides = {"world.gravity=[0, -5, 0]", "world.hz=240"};
    options.seconds = 1.5;
    options.size = PictureSize{96, 54};
    options.quality = "draft";
    options.qualityAsked = true;
    options.show = {"contacts", "ids"};
    options.theme = "dark";
    options.clean = true;
    const GalleryWords words = wordsOf(options);
    EXPECT_EQ(words.run, (std::vector<std::string>{"--set", "world.gravity=[0, -5, 0]", "--set",
                                                   "world.hz=240", "--seconds", "1.5"}));
    EXPECT_EQ(words.picture,
              (std::vector<std::string>{"--quality", "draft", "--size", "96x54", "--show",
                                        "contacts,ids", "--theme", "dark", "--clean"}));
}

TEST(GalleryCard, ComesThroughJson) {
    GalleryCard card;
    card.name = "a";
    card.group = "b";
    card.title = "c";
    card.purpose = "d";
    card.file = "e.toml";
    card.seconds = 1.5;
    card.posterTime = 0.1;
    card.bodies = 1;
    card.joints = 2;
    card.hz = 3;
    card.frames = 4;
    card.fps = 5;
    card.width = 6;
    card.height = 7;
    card.fingerprint = 0xfedcba9876543210u;
    card.film = card.replay = true;
    const GalleryCard back = cardFrom(jsonOf(card));
    EXPECT_EQ(jsonOf(back), jsonOf(card));
    EXPECT_EQ(back.fingerprint, card.fingerprint);
    EXPECT_EQ(back.posterTime, 0.1);
    EXPECT_EQ(back.file, "e.toml");
    EXPECT_EQ(back.height, 7);
}

/// Columns of 0, 30, 60, ...
render::Image ramp(int width, int height) {
    render::Image image{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int value : {30 * x, 30 * x, 30 * x, 255})
                image.pixels.push_back(static_cast<std::uint8_t>(value));
    return image;
}

TEST(Shrunk, APixelIsTheMeanOfThoseThatItCovers) {
    const render::Image half = shrunk(ramp(4, 2), {2, 1});
    EXPECT_EQ(half.at(0, 0)[0], 15);  // (0 + 30) / 2
    EXPECT_EQ(half.at(1, 0)[0], 75);  // (60 + 90) / 2
    EXPECT_EQ(half.at(1, 0)[3], 255);
    const render::Image parts = shrunk(ramp(3, 1), {2, 1});  // 1.5 columns each
    EXPECT_EQ(parts.at(0, 0)[0], 10);                        // (0 + 30 / 2) / 1.5
    EXPECT_EQ(parts.at(1, 0)[0], 50);                        // (30 / 2 + 60) / 1.5
}

TEST(Shrunk, ToItsOwnSizeItIsTheSame) {
    EXPECT_EQ(shrunk(ramp(5, 3), {5, 3}).pixels, ramp(5, 3).pixels);
}

}  // namespace
