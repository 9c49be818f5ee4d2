#include "demos/export/glb_motion.h"

#include <algorithm>

namespace demos {
namespace {

/// q and -q are the same rotation, but interpolating between them would turn the body.
void makeContinuous(std::vector<GlbPose>& poses) {
    for (std::size_t i = 1; i < poses.size(); ++i)
        if (poses[i].rotation.dot(poses[i - 1].rotation) < 0.0f) poses[i].rotation *= -1.0f;
}

/// The values of `of` for all items; empty if all are the same.
template <class Item, class Of>
std::vector<float> changing(const std::vector<Item>& items, Of of) {
    std::vector<float> values;
    const auto same = [&](const Item& item) { return of(item) == of(items.front()); };
    if (std::all_of(items.begin(), items.end(), same)) return values;
    for (const Item& item : items)
        values.insert(values.end(), of(item).data(), of(item).data() + of(item).size());
    return values;
}

}  // namespace

GlbPose glbPoseOf(const engine::Pose& pose) {
    return {pose.position.cast<float>(), pose.rotation.normalized().coeffs().cast<float>()};
}

void GlbMotion::add(int node, std::vector<GlbPose> poses) {
    makeContinuous(poses);
    const auto translation = [](const GlbPose& p) -> const auto& { return p.translation; };
    const auto rotation = [](const GlbPose& p) -> const auto& { return p.rotation; };
    addChannel(node, "translation", changing(poses, translation), GlbType::vec3);
    addChannel(node, "rotation", changing(poses, rotation), GlbType::vec4);
}

void GlbMotion::addScales(int node, const std::vector<Eigen::Vector3f>& scales) {
    const auto whole = [](const Eigen::Vector3f& scale) -> const auto& { return scale; };
    addChannel(node, "scale", changing(scales, whole), GlbType::vec3);
}

void GlbMotion::addChannel(int node, const char* path, const std::vector<float>& values,
                           GlbType type) {
    if (values.empty()) return;
    if (timesAccessor_ < 0) timesAccessor_ = buffer_.addKeys(times_, GlbType::scalar);
    channels_.push_back(
        {{"sampler", samplers_.size()}, {"target", {{"node", node}, {"path", path}}}});
    samplers_.push_back({{"input", timesAccessor_},
                         {"interpolation", "LINEAR"},
                         {"output", buffer_.addKeys(values, type)}});
}

GlbJson GlbMotion::animations() const {
    GlbJson list = GlbJson::array();
    if (!channels_.empty())
        list.push_back({{"name", "run"}, {"channels", channels_}, {"samplers", samplers_}});
    return list;
}

}  // namespace demos
