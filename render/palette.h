/// Colours that colour-blind viewers can distinguish (Okabe and Ito 2008), and those of overlays.
#pragma once
#include "render/frame.h"

namespace render {

/// 0xRRGGBB, sRGB.
inline Color fromHex(unsigned rgb) {
    return {static_cast<float>(rgb >> 16 & 0xffu) / 255.0f,
            static_cast<float>(rgb >> 8 & 0xffu) / 255.0f,
            static_cast<float>(rgb & 0xffu) / 255.0f, 1.0f};
}

/// Hues with a meaning (--colour-by), in an order in which neighbours differ clearly.
inline Color paletteColor(int i) {
    constexpr unsigned kColors[] = {0x3579b1, 0xe69f2e, 0x2f9e73, 0xcc79a7,
                                    0x5fb4e0, 0xd9622b, 0xe3d24d};
    return fromHex(kColors[static_cast<unsigned>(i) % 7u]);
}

/// Colours of bodies that define none: one family, from deep blue to sand, and one accent for every
/// seventh body.
inline Color familyColor(int i) {
    constexpr unsigned kColors[] = {0x2f6690, 0xd8cfbd, 0x5b92b8, 0x1f4a6b,
                                    0xa9c4d6, 0xe2793a, 0x7d98a8};
    return fromHex(kColors[static_cast<unsigned>(i) % 7u]);
}

inline Color fixedColor() { return fromHex(0x55585c); }    // bodies that cannot move
inline Color heavyColor() { return fromHex(0x3a3c40); }    // bodies much heavier than the rest
inline Color contactColor() { return fromHex(0xe0218a); }  // dots
inline Color normalColor() { return fromHex(0x1f77d0); }   // arrows
inline Color impulseColor() { return fromHex(0xd62728); }  // arrows along the contact normal
inline Color frictionColor() { return fromHex(0xf0a202); } // arrows across it
inline Color boundsColor() { return fromHex(0x008f8f); }   // boxes along the axes
inline Color jointColor() { return fromHex(0x4a4d52); }    // rods

}  // namespace render
