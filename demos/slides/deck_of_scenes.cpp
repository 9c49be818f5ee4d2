#include "demos/slides/deck_of_scenes.h"

#include <algorithm>

#include "demos/film/film_plan.h"
#include "demos/scene/reader.h"
#include "demos/slides/markup.h"
#include "demos/slides/read_slide.h"
#include "demos/slides/section_slide.h"
#include "demos/text/complaints.h"

namespace demos {
namespace {

/// "Stack" for "stack: ten boxes"; without a colon, the whole title.
std::string shortTitle(const SceneDescription& scene) {
    std::string title = scene.title.substr(0, scene.title.find(": "));
    if (!title.empty() && title[0] >= 'a' && title[0] <= 'z')
        title[0] = static_cast<char>(title[0] - 'a' + 'A');
    return title;
}

/// "Stack, Chain and Wall"
std::string listOf(const std::vector<std::string>& names) {
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i)
        list += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    return list;
}

/// The charts that are most likely to show something.
std::vector<std::string> tellingCharts(const SceneDescription& scene) {
    if (scene.joints.empty()) return {"energy", "penetration"};
    return {"energy", "separation"};
}

class SceneSlides {
public:
    SceneSlides(const Options& options, Complaints& complaints)
        : options_(options), complaints_(complaints), files_(complaints) {}

    void add(const std::string& name) {
        Options own = options_;
        own.scenes = {name};
        const SceneDescription scene = sceneOf(own);
        runs_ = SlideRuns{};
        runs_.scene = name;
        runs_.settings = options_.overrides;
        addSections(scene);
        addNumbers(scene);
        titles_.push_back(shortTitle(scene));
        if (!scene.purpose.empty())
            purposes_ +=
                "- **" + commonMarkOf(titles_.back()) + "**: " + commonMarkOf(scene.purpose) + "\n";
        note(name);
        for (const std::string& file : scene.files) note(file);
        if (deck_.name.empty()) deck_.name = scene.name;
        if (titles_.size() == 1) first_ = scene.title;
        if (themes_.empty()) themes_ = scene.look.theme;
    }

    Deck finish() {
        const bool several = titles_.size() > 1;
        deck_.title = commonMarkOf(several ? listOf(titles_) : first_);
        if (several) {
            Slide opening;
            opening.opening = true;
            opening.title = deck_.title;
            opening.text = purposes_;
            deck_.slides.insert(deck_.slides.begin(), std::move(opening));
        }
        const std::string theme = options_.theme.empty() ? themes_ : options_.theme;
        if (theme == "dark" || theme == "print") deck_.theme = theme;
        if (options_.size) deck_.size = *options_.size;
        if (options_.fps) deck_.fps = *options_.fps;
        for (std::size_t i = 0; i < deck_.slides.size(); ++i)
            deck_.slides[i].id =
                slideId(static_cast<int>(i) + 1, deck_.slides.size(), deck_.slides[i].title);
        return std::move(deck_);
    }

private:
    Slide film() const {
        Slide slide;
        slide.runs = runs_;
        slide.exhibit = Exhibit::film;
        slide.until = options_.seconds;
        return slide;
    }

    void addSections(const SceneDescription& scene) {
        bool any = false;
        for (const Section& section : scene.sections) {
            if (section.at >= scene.seconds) continue;  // --seconds ends the run before it
            Slide slide = film();
            copySection(scene, section, false, slide);
            checkSection(section, {scene}, section.place, files_, complaints_);
            if (slide.title.empty()) slide.title = titleOf(scene, section);
            deck_.slides.push_back(std::move(slide));
            any = true;
        }
        if (any) return;
        Slide slide = film();
        slide.title = commonMarkOf(scene.title);
        slide.caption = commonMarkOf(scene.purpose);
        deck_.slides.push_back(std::move(slide));
    }

    /// The only section of a scene has the scene's title.
    static std::string titleOf(const SceneDescription& scene, const Section& section) {
        if (scene.sections.size() == 1 || section.name.empty()) return commonMarkOf(scene.title);
        return commonMarkOf(shortTitle(scene) + ": " + section.name);
    }

    void addNumbers(const SceneDescription& scene) {
        Slide slide;
        slide.runs = runs_;
        slide.until = options_.seconds;
        slide.title = commonMarkOf(shortTitle(scene) + " in numbers");
        slide.plots = tellingCharts(scene);
        slide.expectations = !scene.expectations.empty();
        deck_.slides.push_back(std::move(slide));
    }

    void note(const std::filesystem::path& path) {
        std::error_code error;
        const bool known =
            std::find(deck_.files.begin(), deck_.files.end(), path) != deck_.files.end();
        if (!known && std::filesystem::exists(path, error)) deck_.files.push_back(path);
    }

    const Options& options_;
    Complaints& complaints_;
    SectionFiles files_;
    SlideRuns runs_;
    Deck deck_;
    std::vector<std::string> titles_;
    std::string purposes_, first_, themes_;
};

}  // namespace

Deck deckOfScenes(const Options& options) {
    Complaints complaints(options.overrides);
    SceneSlides slides(options, complaints);
    for (const std::string& scene : options.scenes) slides.add(scene);
    if (complaints.count() > 0) throw SceneError(complaints.lines());
    return slides.finish();
}

}  // namespace demos
