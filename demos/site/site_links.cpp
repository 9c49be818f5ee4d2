#include "demos/site/site_links.h"

#include <algorithm>
#include <filesystem>

#include "demos/scene/explain.h"
#include "demos/site/documents.h"

namespace demos {
namespace {

bool isWeb(const std::string& url) {
    return url.starts_with("https://") || url.starts_with("http://") || url.starts_with("mailto:");
}

std::string fragmentOf(const std::string& url) {
    const std::size_t at = url.find('#');
    return at == std::string::npos ? "" : url.substr(at);
}

/// Files that are not on the site, such as sources, have no address.
std::string linkFrom(const SitePage& page, const std::string& url) {
    if (isWeb(url) || url.starts_with('#')) return url;
    const std::string path = pathFrom(page.source, url);
    for (const std::string& source : {path, path + "/README.md"})
        if (const SitePage* shown = pageShowing(source)) return shown->file + fragmentOf(url);
    return "";
}

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// The READMEs' own pictures are of the gallery; those of a tutorial are with it.
std::string pictureFrom(const SitePage& page, const std::string& url,
                        const std::vector<std::string>& scenes) {
    const std::string path = pathFrom(page.source, url);
    const std::string folder = kGalleryFolder;
    if (path == ".github/gallery.png") return folder + "/sheet.png";
    if (path == ".github/wall.png" && has(scenes, "wall")) return folder + "/wall.png";
    if (documentAt(path)) return "pictures/" + std::filesystem::path(path).filename().string();
    return "";
}

/// "camera.fov_deg" -> its place in the list of keys; also "camera.fov_deg = 20" and "[[joint]]".
std::string keyAddress(const std::string& code) {
    static const std::vector<KeyFacts> keys = keyFacts();
    const std::size_t first = code.find_first_not_of('[');
    std::string path = first == std::string::npos ? "" : code.substr(first);
    path = path.substr(0, path.find(" = "));
    if (first > 0 && first != std::string::npos) path = path.substr(0, path.find(']'));
    if (first == 0 && path.find('.') == std::string::npos) return "";  // "mass" is in many tables
    for (const KeyFacts& key : keys)
        if (key.path == path) return std::string(kKeysPage) + "#" + path;
    return "";
}

}  // namespace

std::string pathFrom(const std::string& source, const std::string& url) {
    const std::string target = url.substr(0, url.find('#'));
    std::string path =
        (std::filesystem::path(source).parent_path() / target).lexically_normal().generic_string();
    while (path.ends_with('/')) path.pop_back();
    return path;
}

DocumentLinks linksOf(const SitePage& page, const std::vector<std::string>& scenes) {
    const bool listsScenes = page.source == std::string("demos/scenes/README.md");
    return {[&page](const std::string& url) { return linkFrom(page, url); },
            [&page, &scenes](const std::string& url) { return pictureFrom(page, url, scenes); },
            [&scenes, listsScenes](const std::string& code) {
                if (listsScenes && has(scenes, code))
                    return std::string(kGalleryPage) + "#scene-" + code;
                return keyAddress(code);
            }};
}

}  // namespace demos
