#include "demos/site/site.h"

#include <fmt/format.h>

#include <filesystem>

#include "demos/film/outputs.h"
#include "demos/film/progress.h"
#include "demos/gallery/gallery.h"
#include "demos/processes/folder_lock.h"
#include "demos/site/documents.h"
#include "demos/site/key_reference.h"
#include "demos/site/site_html.h"
#include "demos/site/site_links.h"
#include "demos/text/complaints.h"
#include "demos/text/file_content.h"
#include "demos/text/plural.h"
#include "demos/text/shell_word.h"
#include "render/encode/file.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMark = "<meta name=\"generator\" content=\"impulse site\">";
constexpr const char* kFrontPage = "index.html";
constexpr const char* kSearchFile = "search.js";

struct SiteFile {
    fs::path name;  // in the folder
    std::string content;
};

std::vector<std::string> namesOf(const std::vector<GalleryCard>& cards) {
    std::vector<std::string> names;
    for (const GalleryCard& card : cards) names.push_back(card.name);
    return names;
}

DocumentHtml contentOf(const SitePage& page, const std::vector<std::string>& scenes) {
    if (!*page.source) return keyReference();
    return documentHtml(documentAt(page.source)->text, linksOf(page, scenes));
}

/// All files but those of the gallery.
std::vector<SiteFile> siteFiles(const std::vector<GalleryCard>& cards) {
    const std::vector<std::string> scenes = namesOf(cards);
    std::vector<SiteFile> files{{kFrontPage, sitePageHtml(nullptr, frontPage(cards))}};
    SearchIndex index;
    for (const GalleryCard& card : cards) index.add(card);
    for (const SitePage& page : sitePages()) {
        if (page.file == std::string(kGalleryPage)) continue;
        const DocumentHtml content = contentOf(page, scenes);
        index.add(page, content);
        files.push_back({page.file, sitePageHtml(&page, content)});
    }
    files.push_back({kSearchFile, index.text()});
    for (const SiteDocument& document : documents())
        if (document.path.ends_with(".png"))
            files.push_back(
                {"pictures" / fs::path(document.path).filename(), std::string(document.text)});
    return files;
}

/// A folder whose front page a site made is the site's. Otherwise no file of it is replaced.
void checkOwnSite(const fs::path& folder, bool overwrite) {
    const std::vector<std::uint8_t> front = demos::contentOf(folder / kFrontPage);
    const std::string text(front.begin(), front.end());
    if (overwrite || text.find(kMark) != std::string::npos) return;
    for (const SiteFile& file : siteFiles({})) {
        std::error_code ignored;
        if (fs::exists(fs::symlink_status(folder / file.name, ignored)))
            refuseToReplace(folder / file.name,
                            "already exists, and no index.html says that it is a site's; "
                            "--overwrite replaces it");
    }
}

GalleryOptions galleryOf(const GalleryOptions& options, const fs::path& folder) {
    GalleryOptions gallery = options;
    gallery.outputs = {(folder / kGalleryFolder).string()};
    gallery.links.push_back({"Start", std::string("../") + kFrontPage});
    for (const SitePage& page : sitePages())
        if (page.group == std::string("Start") && page.file != std::string(kGalleryPage))
            gallery.links.push_back({page.name, std::string("../") + page.file});
    gallery.links.push_back({"Every key", std::string("../") + kKeysPage});
    return gallery;
}

}  // namespace

Exit siteInFolder(const GalleryOptions& options) {
    const fs::path folder = options.outputs.empty() ? "output/site" : options.outputs.front();
    const Talk talk(options, false);
    render::makeFolder(folder);
    const FolderLock lock(folder);
    checkOwnSite(folder, options.overwrite);
    const GalleryMade gallery = galleryInFolder(galleryOf(options, folder));
    render::makeFolder(folder / "pictures");
    int pages = 1;  // the gallery's
    for (const SiteFile& file : siteFiles(gallery.cards)) {
        render::writeFileAtomically(folder / file.name, file.content);
        if (file.name.extension() == ".html") ++pages;
    }
    const std::string front = (folder / kFrontPage).string();
    talk.json(fmt::format(R"({{"event":"site","page":{},"pages":{},"scenes":{}}})",
                          jsonString(front), pages, gallery.cards.size()));
    talk.say(fmt::format("wrote {} ({}, {})", printable(front), plural(pages, "page"),
                         plural(gallery.cards.size(), "scene")));
    talk.say(fmt::format("next: open {}", printable(shellWord(front))));
    return gallery.code;
}

}  // namespace demos
