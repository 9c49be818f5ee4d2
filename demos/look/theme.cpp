#include "demos/look/theme.h"

#include "render/material.h"

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

/// A bright room whose floor is ruled, to measure by.
void lab(render::Look& look) {
    look.skyTop = render::fromHex(0xdfe6ec);
    look.skyHorizon = render::fromHex(0xf0f3f6);
    look.fog = render::fromHex(0xeef1f4);
    look.ground = render::fromHex(0xd9dde1);
}

}  // namespace

const std::vector<std::string>& themeNames() {
    static const std::vector<std::string> names = {"studio", "dark", "print", "transparent",
                                                   "lab"};
    return names;
}

const std::vector<std::string>& materialNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const render::MaterialValues& values : render::kMaterialTable)
            all.emplace_back(values.name);
        return all;
    }();
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
    } else if (theme == "lab") {
        lab(frame.look);
    }
    if (theme == "dark") frame.look.plate = render::fromHex(0x343a43);
    frame.look.plate.a = render::Look{}.plate.a;
    frame.look.ink = ink;
    for (render::Text& text : frame.texts)
        if (isPlainInk(text.color)) text.color = ink;
}

}  // namespace demos
