#include "render/sight.h"

namespace render {

Sight sightOf(const View& view, int width, int height) {
    const auto& p = view.projection;
    const Vec3 right = view.view.block<1, 3>(0, 0), up = view.view.block<1, 3>(1, 0);
    const Vec3 back = view.view.block<1, 3>(2, 0);
    Sight sight;
    sight.eye = view.eye;
    sight.right = right * (2.0f / (static_cast<float>(width) * p(0, 0)));
    sight.down = up * (-2.0f / (static_cast<float>(height) * p(1, 1)));
    sight.ahead =
        right * ((p(0, 2) - 1.0f) / p(0, 0)) + up * ((p(1, 2) + 1.0f) / p(1, 1)) - back;
    return sight;
}

}  // namespace render
