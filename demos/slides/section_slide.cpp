#include "demos/slides/section_slide.h"

#include "demos/formulas/caption_text.h"
#include "demos/load/builtin.h"
#include "demos/scene/reader.h"
#include "demos/slides/check_words.h"
#include "demos/slides/markup.h"

namespace demos {
namespace {

std::string textOf(const std::string& file) {
    for (const BuiltinScene& scene : builtinScenes())
        if (std::string(scene.name) + ".toml" == file) return std::string(scene.text);
    try {
        return readSceneFile(file);
    } catch (const SceneError&) {
        return {};  // removed since the scene was read: places are then those of the quotes
    }
}

/// Words as they are, formulas as formulas.
std::string captionOf(const Section& section) {
    const FormulaCaption& formulas = section.formulaCaption;
    if (formulas.line.empty()) return commonMarkOf(section.caption);
    std::string commonMark = commonMarkOf(formulas.line);
    for (std::size_t k = 0; k < formulas.markup.size(); ++k) {
        const std::string mark = (formulas.markup[k].empty() ? " " : "") + formulaMark(k);
        commonMark.replace(commonMark.find(mark), mark.size(), formulas.markup[k]);
    }
    return commonMark;
}

}  // namespace

const SectionFiles::File& SectionFiles::of(const std::string& name) {
    const auto known = files_.find(name);
    if (known != files_.end()) return known->second;
    return files_.emplace(name, File{complaints_.addFile(name), textOf(name)}).first->second;
}

void copySection(const SceneDescription& scene, const Section& section, bool several,
                 Slide& slide) {
    slide.title = section.slide.title;
    slide.text = section.slide.text;
    slide.formulas = section.slide.formulas;
    slide.caption = captionOf(section);
    slide.notes = section.notes;
    slide.from = section.at;
    for (const Section& later : scene.sections)
        if (later.at > section.at && (!slide.until || later.at < *slide.until))
            slide.until = later.at;
    slide.slow = section.slow;
    slide.pause = section.pause;
    slide.loop = section.loop;
    if (!section.poster.empty()) slide.poster = section.poster;
    if (!several) slide.plots = section.slide.plots;
    if (scene.joints.empty()) std::erase(slide.plots, "separation");
    slide.measures = section.slide.measures;
    slide.expectations = section.slide.expectations && !scene.expectations.empty();
}

void checkSection(const Section& section, const std::vector<SceneDescription>& runs,
                  Place otherwise, SectionFiles& files, Complaints& complaints) {
    const auto position = [&](Place place) {
        if (section.file.empty() || place.line < 1) return TomlPosition{otherwise, {}};
        const SectionFiles::File& file = files.of(section.file);
        place.file = file.number;
        return TomlPosition{place, file.text};
    };
    const SectionSlide& slide = section.slide;
    if (!slide.title.empty()) checkWords(slide.title, position(slide.titlePlace), runs, complaints);
    if (!slide.text.empty()) checkWords(slide.text, position(slide.textPlace), runs, complaints);
    if (!section.notes.empty())
        checkWords(section.notes, position(slide.notesPlace), runs, complaints);
    for (std::size_t i = 0; i < slide.formulas.size(); ++i)
        checkFormula(slide.formulas[i], position(slide.formulaPlaces[i]), runs, complaints);
}

}  // namespace demos
