#include "demos/site/site_pages.h"

namespace demos {

std::span<const SitePage> sitePages() {
    static constexpr SitePage kPages[] = {
        {kGalleryPage, "", "Start", "Gallery", "every scene as a film, and to step through"},
        {"first-scene.html", "demos/scenes/first-scene.md", "Start", "Your first scene",
         "from nothing to a film of a hammer and a tower, in ten steps"},
        {"recipes.html", "demos/scenes/recipes.md", "Start", "Recipes",
         "twelve small scenes and commands to copy"},
        {"what-went-wrong.html", "demos/scenes/what-went-wrong.md", "Start", "What went wrong?",
         "it explodes, trembles, sinks, is blank: by what you see"},
        {"scene-format.html", "demos/scene/README.md", "Scenes", "The format",
         "what a scene file holds, expressions, repeats, includes"},
        {"bodies-and-joints.html", "demos/scene/bodies-and-joints.md", "Scenes",
         "Bodies and joints", "every shape and every joint"},
        {kKeysPage, "", "Scenes", "Every key", "each with its unit, default and range"},
        {"scenes.html", "demos/scenes/README.md", "Scenes", "Built-in scenes",
         "what each shows and costs"},
        {"mjcf.html", "demos/mjcf/README.md", "Scenes", "MuJoCo\u2019s models",
         "what is read of them"},
        {"films.html", "demos/film/README.md", "Results", "Films", "what a frame costs"},
        {"figures.html", "demos/figure/README.md", "Results", "Figures",
         "pictures for papers, with captions"},
        {"slides.html", "demos/slides/README.md", "Results", "Slides",
         "a talk from scenes or a deck file"},
        {"formulas.html", "demos/formulas/README.md", "Results", "Formulas",
         "LaTeX in slides and captions"},
        {"exports.html", "demos/export/README.md", "Results", "Exports",
         "for Blender, numpy and browsers"},
        {"snapshot-tests.html", "demos/regression/README.md", "Tests", "Snapshot tests",
         "pictures, states and expectations against their baselines"},
        {"in-ci.html", "demos/regression/in-ci.md", "Tests", "In CI", "jobs for GitHub and GitLab"},
        {"about.html", "README.md", "Program", "About impulse",
         "what it is for, how it is built, every command"},
        {"program.html", "demos/README.md", "Program", "The program",
         "overlays, camera, forces, data passes, exit codes"},
        {"engine.html", "engine/README.md", "Program", "The engine",
         "how it works, equation by equation"},
        {"renderer.html", "render/README.md", "Program", "The renderer",
         "pictures without a display"},
    };
    return kPages;
}

const SitePage* pageShowing(std::string_view source) {
    for (const SitePage& page : sitePages())
        if (*page.source && page.source == source) return &page;
    return nullptr;
}

}  // namespace demos
