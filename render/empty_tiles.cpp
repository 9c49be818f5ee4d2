#include "render/empty_tiles.h"

namespace render {

void EmptyTiles::draw(const std::vector<PixelRect>& rects, int width, int height,
                      float depth) const {
    std::vector<Vec3> corners;
    const auto corner = [&](int x, int y) {
        return Vec3(2.0f * static_cast<float>(x) / static_cast<float>(width) - 1.0f,
                    2.0f * static_cast<float>(y) / static_cast<float>(height) - 1.0f,
                    2.0f * depth - 1.0f);
    };
    for (const PixelRect& r : rects) {
        const Vec3 a = corner(r.x0, r.y0), b = corner(r.x1, r.y0), c = corner(r.x1, r.y1),
                   d = corner(r.x0, r.y1);
        corners.insert(corners.end(), {a, b, c, a, c, d});
    }
    glDepthFunc(GL_ALWAYS);
    glUseProgram(program_);
    mesh_.draw(corners);
    glDepthFunc(GL_LESS);
}

void readPart(const PixelRect& part, int width, GLenum format, GLenum type, void* pixels) {
    glPixelStorei(GL_PACK_ROW_LENGTH, width);
    glPixelStorei(GL_PACK_SKIP_PIXELS, part.x0);
    glPixelStorei(GL_PACK_SKIP_ROWS, part.y0);
    glReadPixels(part.x0, part.y0, part.x1 - part.x0, part.y1 - part.y0, format, type, pixels);
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    glPixelStorei(GL_PACK_SKIP_PIXELS, 0);
    glPixelStorei(GL_PACK_SKIP_ROWS, 0);
}

}  // namespace render
