// [look] and [[section]]

#include <algorithm>

#include "demos/overlays.h"
#include "demos/report/measures.h"
#include "demos/scene/nearest.h"
#include "demos/scene/pattern.h"
#include "demos/scene/read_parts.h"
#include "demos/theme.h"

namespace demos {
namespace {

template <class To, class From>
void set(To& to, const std::optional<From>& from) {
    if (from) to = *from;
}

void checkOverlay(Keys& keys, const std::string& name) {
    const std::vector<std::string>& names = overlayNames();
    if (std::find(names.begin(), names.end(), name) == names.end())
        keys.complain("show", "no overlay is called '" + name + "'" + suggestion(name, names));
}

/// "first", "last", or a time.
std::optional<std::string> readPoster(Keys& keys, double seconds) {
    const Value* value = keys.any("poster");
    if (!value || !value->isNumber()) return keys.word("poster", {"first", "last"});
    const std::optional<double> time = keys.number("poster", {0.0, seconds, "s"});
    return time ? std::optional(numberText(*time)) : std::nullopt;
}

Section readSection(Keys keys, const SceneDescription& scene) {
    Section section;
    set(section.at, keys.number("at", {0.0, scene.seconds, "s"}));
    set(section.name, keys.text("name"));
    set(section.caption, keys.text("caption"));
    set(section.notes, keys.text("notes"));
    set(section.poster, readPoster(keys, scene.seconds));
    set(section.slow, keys.number("slow", {0.001, 1000.0}));
    set(section.pause, keys.truth("pause"));
    set(section.loop, keys.truth("loop"));
    keys.done();
    return section;
}

}  // namespace

void readLook(Keys& top, SceneDescription& scene) {
    const Value* table = top.any("look");
    if (!table) return;
    Keys keys = top.inner(*table, "[look]");
    set(scene.look.theme, keys.word("theme", themeNames()));
    for (const std::string& name : keys.texts("show").value_or(std::vector<std::string>{})) {
        scene.look.show.push_back(name);
        checkOverlay(keys, name);
    }
    set(scene.look.colorBy, keys.word("colour_by", colorings()));
    constexpr Range kScale{1e-9, 1e9, "m/s or N s"};
    set(scene.look.colorMax, keys.number("colour_max", kScale));
    set(scene.look.ghostEvery, keys.number("ghost_every", {1e-3, 1e5, "s"}));
    set(scene.look.plot, keys.word("plot", measureNames()));
    for (const std::string& pattern : keys.texts("trails").value_or(std::vector<std::string>{})) {
        const std::size_t before = scene.look.trails.size();
        for (const BodyDescription& body : scene.bodies)
            if (matches(pattern, body.name)) scene.look.trails.push_back(body.name);
        if (scene.look.trails.size() == before)
            keys.complain("trails", "no body is called '" + pattern + "'" +
                                        suggestion(pattern, bodyNames(scene)));
    }
    keys.done();
}

void readSections(Keys& top, SceneDescription& scene) {
    for (const Value* table : top.tables("section"))
        scene.sections.push_back(readSection(top.inner(*table, "a [[section]]"), scene));
    std::stable_sort(scene.sections.begin(), scene.sections.end(),
                     [](const Section& a, const Section& b) { return a.at < b.at; });
}

}  // namespace demos
