#include "demos/snapshot/colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "demos/snapshot/history.h"
#include "demos/snapshot/scale.h"
#include "engine/base/disjoint_sets.h"
#include "render/material.h"
#include "render/palette.h"

namespace demos {
namespace {

constexpr std::array<unsigned, 9> kViridis = {0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c,
                                              0x28ae80, 0x5ec962, 0xaddc30, 0xfde725};

bool isFixed(const Stage& stage, int body) {
    return stage.scene.bodies[body].def.kind == engine::BodyKind::fixed;
}

/// "brick12", "brick-12-3" -> "brick"
std::string groupOf(const std::string& name) {
    const std::size_t end = name.find_last_not_of("0123456789-_.");
    return end == std::string::npos ? name : name.substr(0, end + 1);
}

std::string materialText(const engine::Material& m) {
    std::string text = fmt::format("friction {:g}, {:g} kg/m³", m.friction, m.density);
    if (m.restitution > 0.0) text += fmt::format(", restitution {:g}", m.restitution);
    return text;
}

/// The group or material of every body, for these colourings; else empty.
std::vector<std::string> namesOf(const Stage& stage, const std::string& colorBy) {
    std::vector<std::string> names;
    if (colorBy == "group" || colorBy == "material")
        for (const BodyDescription& body : stage.scene.bodies)
            names.push_back(colorBy == "group" ? groupOf(body.name)
                                               : materialText(body.def.material));
    return names;
}

/// Equal names get the same number, in the order of the bodies.
std::vector<int> numbered(const std::vector<std::string>& names) {
    std::map<std::string, int> numbers;
    std::vector<int> result;
    for (const std::string& name : names)
        result.push_back(numbers.emplace(name, static_cast<int>(numbers.size())).first->second);
    return result;
}

/// By body; empty if bodies keep their own colours.
std::vector<int> kindsOf(const Stage& stage, const std::string& colorBy) {
    if (colorBy == "island") return islandsOf(stage);
    if (colorBy != "id") return numbered(namesOf(stage, colorBy));
    std::vector<int> ids(stage.scene.bodies.size());
    std::iota(ids.begin(), ids.end(), 0);
    return ids;
}

}  // namespace

std::vector<double> colorValues(const Stage& stage, const std::string& colorBy) {
    if (colorBy != "speed" && colorBy != "impulse") return {};
    std::vector<double> values(stage.bodies.size(), 0.0);
    if (colorBy == "speed") {
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = stage.world.velocity(stage.bodies[i]).norm();
    } else {
        for (const engine::ContactState& contact : stage.world.contacts())
            for (const engine::BodyId id : {contact.a, contact.b})
                if (id.index < static_cast<int>(values.size())) values[id.index] += contact.impulse;
    }
    for (std::size_t i = 0; i < values.size(); ++i)
        if (isFixed(stage, static_cast<int>(i))) values[i] = -1.0;
    return values;
}

render::Color scaleColor(double share) {
    const double at = std::clamp(share, 0.0, 1.0) * (kViridis.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(at), kViridis.size() - 2);
    const render::Color a = render::fromHex(kViridis[i]), b = render::fromHex(kViridis[i + 1]);
    const float t = static_cast<float>(at - static_cast<double>(i));
    return {a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b), 1.0f};
}

render::Color axisColor(int axis) {
    constexpr unsigned kColors[] = {0xd62728, 0x2f9e73, 0x1f77d0};
    return render::fromHex(kColors[axis]);
}

std::vector<render::Color> scaleRamp() {
    std::vector<render::Color> ramp;
    for (const unsigned color : kViridis) ramp.push_back(render::fromHex(color));
    return ramp;
}

double scaleEnd(const Overlays& overlays, const History& history) {
    return overlays.colorMax > 0.0 ? overlays.colorMax : roundAbove(history.largestValue);
}

std::vector<int> islandsOf(const Stage& stage) {
    engine::DisjointSets sets;
    const int count = static_cast<int>(stage.bodies.size());
    sets.reset(count);
    const auto moves = [&](engine::BodyId id) {
        return id.index < count && !isFixed(stage, id.index);
    };
    const auto join = [&](engine::BodyId a, engine::BodyId b) {
        if (moves(a) && moves(b)) sets.join(a.index, b.index);
    };
    for (const engine::ContactState& contact : stage.world.contacts()) join(contact.a, contact.b);
    for (const engine::JointId id : stage.joints) {
        const engine::JointState joint = stage.world.joint(id);
        if (!joint.removed) join(joint.def.a, joint.def.b);
    }
    std::vector<int> islands;
    for (int i = 0; i < count; ++i) islands.push_back(isFixed(stage, i) ? -1 : sets.leaderOf(i));
    return islands;
}

render::Color ownColor(const Stage& stage, int body) {
    const BodyDescription& description = stage.scene.bodies[body];
    if (description.color) return render::fromHex(*description.color);
    if (description.look != render::Material::plastic)
        return render::fromHex(render::valuesOf(description.look).color);
    return isFixed(stage, body) ? render::fixedColor() : render::familyColor(body);
}

std::vector<ColorMeaning> colorMeanings(const Stage& stage, const std::string& colorBy) {
    const std::vector<std::string> names = namesOf(stage, colorBy);
    const std::vector<int> kinds = numbered(names);
    std::vector<ColorMeaning> meanings;
    std::set<int> told;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (!isFixed(stage, static_cast<int>(i)) && told.insert(kinds[i]).second)
            meanings.push_back({names[i], render::paletteColor(kinds[i])});
    return meanings;
}

std::vector<render::Color> bodyColors(const Stage& stage, const Overlays& overlays,
                                      const History& history) {
    const std::vector<double> values = colorValues(stage, overlays.colorBy);
    const std::vector<int> kinds = kindsOf(stage, overlays.colorBy);
    const double end = scaleEnd(overlays, history);
    std::vector<render::Color> colors;
    for (int i = 0; i < static_cast<int>(stage.bodies.size()); ++i) {
        if ((values.empty() && kinds.empty()))
            colors.push_back(ownColor(stage, i));
        else if (isFixed(stage, i))
            colors.push_back(render::fixedColor());
        else
            colors.push_back(values.empty() ? render::paletteColor(kinds[i])
                                            : scaleColor(values[i] / end));
    }
    return colors;
}

}  // namespace demos
