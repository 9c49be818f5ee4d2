// The data images of small frames, all drawn by one renderer.
#pragma once
#include "render/data_images.h"
#include "render/renderer.h"

namespace render {

constexpr int kDataWidth = 160, kDataHeight = 90;

inline Renderer& dataRenderer() {
    static Renderer one([] {
        RendererSettings s;
        s.width = kDataWidth, s.height = kDataHeight, s.samples = 1;
        s.reproducible = true;
        return s;
    }());
    return one;
}

inline DataImages dataOf(const Frame& now, const Frame* next = nullptr) {
    return dataImages(now, next, dataRenderer().surfaces(now), {true, true, true, true});
}

}  // namespace render
