#include "demos/look/theme.h"

namespace demos {
namespace {

bool isPlainInk(const render::Color& color) {
    const render::Color plain = render::Text{}.color;
    return color.r == plain.r && color.g == plain.g && color.b == plain.b;
}

void dark(render::Look& look) {
    look.skyTop = render::fromHex(0x14171c);
    look.skyHorizon = render::fromHex(0x22272f);
    look.fog = render::fromHex(0x1c2027);
    look.ground = render::fromHex(0x30343b);
}

/// White paper: only bodies should use ink, and edges should survive a copier.
void print(render::Look& look) {
    look.skyTop = look.skyHorizon = look.fog = render::fromHex(0xffffff);
    look.ground = render::fromHex(0xffffff);
    look.lineStrength = 2.2f;
}

}  // namespace

const std::vector<std::string>& themeNames() {
    static const std::vector<std::string> names = {"studio", "dark", "print", "transparent"};
    return names;
}

void applyTheme(const std::string& theme, render::Frame& frame) {
    render::Color ink = render::Text{}.color;
    if (theme == "dark") {
        dark(frame.look);
        ink = render::fromHex(0xe8eaed);
    } else if (theme == "print") {
        print(frame.look);
        ink = render::fromHex(0x000000);
    } else if (theme == "transparent") {
        frame.look.transparent = true;
    }
    if (theme == "dark") frame.look.plate = render::fromHex(0x343a43);
    frame.look.plate.a = render::Look{}.plate.a;
    frame.look.ink = ink;
    for (render::Text& text : frame.texts)
        if (isPlainInk(text.color)) text.color = ink;
}

}  // namespace demos
