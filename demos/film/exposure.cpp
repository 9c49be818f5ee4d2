#include "demos/film/exposure.h"

#include "demos/film/framing.h"

namespace demos {

std::vector<render::Frame> playTo(double time, int steps, const FilmPlan& plan, Player& player) {
    const Shutter shutter(plan.shutter, plan.stepsPerFrame);
    std::vector<render::Frame> seen;
    for (int left = steps; left >= 0; --left) {
        if (shutter.sees(left)) {
            seen.push_back(player.frame(time - static_cast<double>(left) / plan.scene().hz));
            fitCamera(plan.picture.width, plan.picture.height, seen.back());
        }
        if (left > 0) player.step();
    }
    return seen;
}

render::Image exposed(const std::vector<render::Frame>& seen, const FilmPlan& plan,
                      render::Renderer& renderer) {
    if (plan.shutter.moments <= 1) return renderer.draw(seen.back());
    return renderer.draw(Shutter(plan.shutter, plan.stepsPerFrame).moments(seen));
}

}  // namespace demos
