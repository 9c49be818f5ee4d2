#include "demos/film/chapters.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace demos {
namespace {

/// The section's first frame in the film: the number of chosen frames before it.
int firstFrameOf(double time, const FilmPlan& plan, const std::vector<bool>& chosen) {
    const auto end = std::min<std::ptrdiff_t>(plan.firstFrameAt(time), std::ssize(chosen));
    return static_cast<int>(std::count(chosen.begin(), chosen.begin() + end, true));
}

std::string chapterName(const Section& section, std::size_t number) {
    if (!section.name.empty()) return section.name;
    return section.caption.empty() ? std::to_string(number) : section.caption;
}

}  // namespace

std::vector<render::Chapter> chaptersOf(const FilmPlan& plan, const std::vector<bool>& chosen) {
    const SceneDescription& scene = plan.scene();
    if (scene.sections.empty()) return {};
    std::vector<render::Chapter> all = {{0, 0, scene.title.empty() ? "0" : scene.title}};
    for (const Section& section : scene.sections) {
        all.push_back({firstFrameOf(section.at, plan, chosen), 0,
                       chapterName(section, all.size())});
        all[all.size() - 2].end = all.back().first;
    }
    all.back().end = static_cast<int>(std::count(chosen.begin(), chosen.end(), true));
    std::erase_if(all, [](const render::Chapter& one) { return one.end <= one.first; });
    return all;
}

}  // namespace demos
