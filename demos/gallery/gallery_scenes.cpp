#include "demos/gallery/gallery_scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "demos/load/builtin.h"
#include "demos/load/load_scene.h"
#include "demos/scene/description.h"
#include "demos/scene/reader.h"
#include "demos/text/complaints.h"
#include "demos/text/stop.h"

namespace demos {
namespace {

class GalleryChooser {
public:
    void add(const std::string& word) {
        if (word == "all") return addAll();
        const bool builtin = isBuiltin(word);
        const std::string name = builtin ? word : sceneNameOf(word);
        const auto same = [&name](const GalleryChoice& choice) { return choice.name == name; };
        const auto known = std::find_if(choices_.begin(), choices_.end(), same);
        if (known != choices_.end() && known->scene == word) return;
        if (known != choices_.end())
            throw Stop(Exit::usage,
                       fmt::format("'{}' and '{}' would both be called '{}'; rename "
                                   "one of the files",
                                   printable(known->scene), printable(word), printable(name)));
        if (name == "sheet" || name == "index")
            throw Stop(Exit::usage,
                       fmt::format("'{}': {}; rename the file", printable(word),
                                   name == "sheet" ? "sheet.png is the picture of all scenes"
                                                   : "index.html is the page of all scenes"));
        choices_.push_back({word, name, builtin});
    }

    /// All built-in scenes by group, as `impulse list` orders them.
    void addAll() {
        std::multimap<std::string, std::string> byGroup;
        for (const BuiltinScene& scene : builtinScenes()) {
            const std::string name(scene.name);
            byGroup.emplace(loadScene(name).group, name);
        }
        for (const auto& [group, name] : byGroup) add(name);
    }

    std::vector<GalleryChoice> take() { return std::move(choices_); }

private:
    std::vector<GalleryChoice> choices_;
};

}  // namespace

std::vector<GalleryChoice> chooseGallery(const std::vector<std::string>& words) {
    GalleryChooser chooser;
    for (const std::string& word : words) chooser.add(word);
    if (words.empty()) chooser.addAll();
    return chooser.take();
}

}  // namespace demos
