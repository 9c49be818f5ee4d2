// [look] and [[section]]

#include <fmt/format.h>

#include <algorithm>

#ifdef IMPULSE_HAVE_SLIDES
#include "demos/formulas/caption_text.h"
#include "demos/formulas/formula.h"
#include "demos/formulas/text_formulas.h"
#endif
#include "demos/look/measure_names.h"
#include "demos/look/overlays.h"
#include "demos/look/theme.h"
#include "demos/scene/pattern.h"
#include "demos/scene/table_readers.h"
#include "demos/text/nearest.h"

namespace demos {
namespace {

/// `what`: "overlay", "chart", ...
void checkWord(Keys& keys, std::string_view key, const std::string& what, const std::string& name,
               const std::vector<std::string>& names) {
    if (std::find(names.begin(), names.end(), name) == names.end())
        keys.complain(key, "no " + what + " is called '" + shown(name) + "'" +
                               suggestion(name, names));
}

/// "first", "last" or a time.
std::optional<std::string> readPoster(Keys& keys, double seconds) {
    const Value* value = keys.any("poster");
    if (!value || !value->isNumber()) return keys.word("poster", {"first", "last"});
    const std::optional<double> time = keys.number("poster", {0.0, seconds, "s"});
    return time ? std::optional(numberText(*time)) : std::nullopt;
}

Place placeOf(Keys& keys, std::string_view key) {
    const Value* value = keys.any(key);
    return value ? value->place : Place{};
}

/// What the section's slide shows besides the film.
void readSlide(Keys& keys, SectionSlide& slide) {
    slide.titlePlace = placeOf(keys, "title");
    slide.textPlace = placeOf(keys, "text");
    slide.notesPlace = placeOf(keys, "notes");
    set(slide.title, keys.text("title"));
    set(slide.text, keys.text("text"));
    set(slide.formulas, keys.texts("formula"));
    if (const Value* formula = keys.any("formula"); formula && !slide.formulas.empty()) {
        if (formula->kind == Value::Kind::text) slide.formulaPlaces = {formula->place};
        for (const Value& item : formula->items) slide.formulaPlaces.push_back(item.place);
    }
    for (const std::string& name : keys.texts("plot").value_or(std::vector<std::string>{})) {
        slide.plots.push_back(name);
        checkWord(keys, "plot", "chart", name, measureNames());
    }
    for (const std::string& name : keys.texts("table").value_or(std::vector<std::string>{})) {
        slide.measures = slide.measures || name == "measures";
        slide.expectations = slide.expectations || name == "expectations";
        checkWord(keys, "table", "table", name, tableNames());
    }
}

/// A light near the horizon would draw shadows without an end.
void readLight(Keys& keys, LookDescription& look) {
    constexpr double kLowest = 0.1736;  // sin 10 deg
    look.light = keys.vector("light", {-1e6, 1e6});
    const bool good = !look.light || look.light->y() > kLowest * look.light->norm();
    if (good) return;
    keys.complain("light", fmt::format("light is [{:.4g}, {:.4g}, {:.4g}]; it should point from the ground to the "
                                       "light, at least 10 degrees upwards, like [-1, 1, 2]",
                                       look.light->x(), look.light->y(), look.light->z()));
}

/// A build without slides shows formulas as they are written. `formulas`: of all captions so far.
void readCaption(Keys& keys, Section& section, [[maybe_unused]] std::size_t& formulas) {
    set(section.caption, keys.text("caption"));
#ifdef IMPULSE_HAVE_SLIDES
    const std::size_t before = formulas;
    formulas += formulasIn(section.caption).size();
    if (formulas > kMostCaptionFormulas) {
        if (before <= kMostCaptionFormulas)
            keys.complain("caption", fmt::format("more than {} formulas in all captions; write fewer",
                                                 kMostCaptionFormulas));
        return;
    }
    try {
        CaptionText text = captionText(section.caption);
        if (!text.formulas.empty())
            section.formulaCaption = {std::move(text.line), std::move(text.formulas), std::move(text.markup)};
        section.caption = std::move(text.letters);
    } catch (const FormulaError& error) {
        keys.complain("caption", fmt::format("formula, byte {} of the caption: {}", error.at() + 1, error.what()));
    }
#endif
}

Section readSection(Keys keys, const SceneDescription& scene, std::size_t& formulas) {
    Section section;
    set(section.at, keys.number("at", {0.0, scene.seconds, "s"}));
    set(section.name, keys.text("name"));
    readCaption(keys, section, formulas);
    set(section.notes, keys.text("notes"));
    set(section.poster, readPoster(keys, scene.seconds));
    set(section.slow, keys.number("slow", {0.001, 1000.0}));
    set(section.pause, keys.truth("pause"));
    set(section.loop, keys.truth("loop"));
    section.place = keys.place();
    readSlide(keys, section.slide);
    keys.done();
    return section;
}

}  // namespace

const std::vector<std::string>& tableNames() {
    static const std::vector<std::string> names = {"measures", "expectations"};
    return names;
}

void readLook(Keys& top, SceneDescription& scene) {
    const Value* table = top.any("look");
    if (!table) return;
    Keys keys = top.inner(*table, "[look]");
    set(scene.look.theme, keys.word("theme", themeNames()));
    for (const std::string& name : keys.texts("show").value_or(std::vector<std::string>{})) {
        scene.look.show.push_back(name);
        checkWord(keys, "show", "overlay", name, overlayNames());
    }
    set(scene.look.colorBy, keys.word("colour_by", colorings()));
    constexpr Range kScale{1e-9, 1e9, "m/s or N s"};
    set(scene.look.colorMax, keys.number("colour_max", kScale));
    set(scene.look.ghostEvery, keys.number("ghost_every", {1e-3, 1e5, "s"}));
    set(scene.look.reflection, keys.number("reflection", {0.0, 1.0, ""}));
    set(scene.look.dither, keys.truth("dither"));
    readLight(keys, scene.look);
    set(scene.look.plot, keys.word("plot", measureNames()));
    const auto trails = keys.texts("trails").value_or(std::vector<std::string>{});
    if (trails.size() > kMostPatterns)
        return keys.complain("trails", std::to_string(trails.size()) +
                                           " names; they should be at most " +
                                           std::to_string(kMostPatterns));
    for (const std::string& pattern : trails) {
        const std::size_t before = scene.look.trails.size();
        for (const BodyDescription& body : scene.bodies)
            if (matches(pattern, body.name)) scene.look.trails.push_back(body.name);
        if (scene.look.trails.size() == before)
            keys.complain("trails", "no body is called '" + shown(pattern) + "'" +
                                        suggestion(pattern, bodyNames(scene)));
    }
    keys.done();
}

void readSections(Keys& top, SceneDescription& scene) {
    std::size_t formulas = 0;  // in captions
    for (const Value* table : top.tables("section"))
        scene.sections.push_back(readSection(top.inner(*table, "a [[section]]"), scene, formulas));
    std::stable_sort(scene.sections.begin(), scene.sections.end(),
                     [](const Section& a, const Section& b) { return a.at < b.at; });
}

}  // namespace demos
