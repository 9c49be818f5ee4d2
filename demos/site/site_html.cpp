#include "demos/site/site_html.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "demos/slides/markup.h"
#include "demos/slides/math_font.h"
#include "demos/text/page_text.h"
#include "demos/text/script_safe.h"
#include "demos/text/version.h"

namespace demos {
namespace {

void replaceMark(std::string& text, std::string_view mark, const std::string& value) {
    for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos; at += value.size())
        text.replace(at, mark.size(), value);
}

/// The list of all pages by group.
std::string listOfPages(const SitePage* here) {
    std::string html, group;
    for (const SitePage& page : sitePages()) {
        if (group != page.group)
            html += fmt::format("{}<h2>{}</h2><ul>", group.empty() ? "" : "</ul>", page.group);
        group = page.group;
        html += fmt::format("<li><a href=\"{}\"{}>{}</a></li>", page.file,
                            &page == here ? " aria-current=\"page\"" : "", page.name);
    }
    return html + "</ul>";
}

/// The headings of a page, if there are several.
std::string listOfHeadings(const DocumentHtml& content) {
    std::string html;
    int count = 0;
    for (const DocumentSection& section : content.sections) {
        if (section.level != 2) continue;
        html += fmt::format("<li><a href=\"#{}\">{}</a></li>", htmlEscaped(section.id),
                            htmlEscaped(section.title));
        ++count;
    }
    return count < 2
               ? ""
               : "<nav id=\"headings\" aria-label=\"on this page\"><h2>On this page</h2><ul>" +
                     html + "</ul></nav>";
}

/// A page's neighbours in the list.
std::string wayOn(const SitePage* here) {
    const std::span<const SitePage> pages = sitePages();
    const auto link = [](const SitePage& page, const char* side, const char* word) {
        return fmt::format("<a class=\"{}\" href=\"{}\"><span>{}</span>{}</a>", side, page.file,
                           word, page.name);
    };
    std::string html;
    for (std::size_t i = 0; here && i < pages.size(); ++i) {
        if (&pages[i] != here) continue;
        if (i > 0) html += link(pages[i - 1], "before", "before");
        if (i + 1 < pages.size()) html += link(pages[i + 1], "after", "next");
    }
    return html.empty() ? "" : "<nav id=\"way\" aria-label=\"next pages\">" + html + "</nav>";
}

std::string tile(const SitePage& page) {
    return fmt::format("<a class=\"tile\" href=\"{}\"><b>{}</b><span>{}</span></a>", page.file,
                       page.name, page.purpose);
}

/// One scene of each group, with its picture.
std::string scenesToSee(const std::vector<GalleryCard>& scenes) {
    constexpr int kMost = 8;
    std::string html;
    std::vector<std::string> groups;
    for (const GalleryCard& scene : scenes) {
        const bool seen = std::find(groups.begin(), groups.end(), scene.group) != groups.end();
        if (seen || static_cast<int>(groups.size()) == kMost) continue;
        groups.push_back(scene.group);
        const std::string name = htmlEscaped(scene.name);
        html += fmt::format(
            "<a href=\"{0}#scene-{1}\"><img src=\"{2}/{1}.png\" alt=\"\" width=\"{3}\" "
            "height=\"{4}\"><span>{5}</span></a>",
            kGalleryPage, name, kGalleryFolder, scene.width, scene.height,
            htmlEscaped(scene.title.empty() ? scene.name : scene.title));
    }
    return html.empty() ? "" : "<div id=\"seen\">" + html + "</div>";
}

std::string row(const std::string& address, const std::string& page, const std::string& title,
                const std::string& text) {
    const nlohmann::ordered_json json{address, page, title, text};
    return scriptSafe(json);
}

}  // namespace

std::string sitePageHtml(const SitePage* page, const DocumentHtml& content) {
    PageText text = sitePageText();
    replaceMark(text.before, "@name@",
                page ? std::string(page->name) + " \u00b7 impulse" : "impulse");
    const bool formulas = content.html.find("<math") != std::string::npos;
    replaceMark(text.before, "@mathfont@", formulas ? mathFontStyle() : "");
    replaceMark(text.before, "@kind@", page ? "text" : "front");
    replaceMark(text.before, "@pages@", listOfPages(page));
    replaceMark(text.after, "@headings@", page ? listOfHeadings(content) : "");
    replaceMark(text.after, "@way@", wayOn(page));
    replaceMark(text.after, "@version@", kVersion);
    return text.before + content.html + text.after;
}

DocumentHtml frontPage(const std::vector<GalleryCard>& scenes) {
    DocumentHtml made;
    made.html =
        "<h1>impulse</h1>\n<p class=\"lead\">Rigid bodies by sequential impulses: one command "
        "turns "
        "a scene file into a film, without a display or a GPU.</p>\n"
        "<pre><code>impulse render wall -o wall.mp4</code></pre>\n" +
        scenesToSee(scenes);
    std::string group;
    for (const SitePage& page : sitePages()) {
        if (group != page.group)
            made.html += fmt::format("{}<h2>{}</h2>\n<div class=\"tiles\">",
                                     group.empty() ? "" : "</div>\n", page.group);
        group = page.group;
        made.html += tile(page);
    }
    made.html += "</div>\n";
    return made;
}

void SearchIndex::add(const SitePage& page, const DocumentHtml& content) {
    for (const DocumentSection& section : content.sections)
        rows_.push_back(row(section.level == 1 ? page.file : page.file + ("#" + section.id),
                            page.name, section.level == 1 ? "" : section.title, section.text));
}

void SearchIndex::add(const GalleryCard& scene) {
    rows_.push_back(row(std::string(kGalleryPage) + "#scene-" + scene.name, "Gallery",
                        scene.title.empty() ? scene.name : scene.title,
                        scene.name + ": " + scene.purpose));
}

std::string SearchIndex::text() const {
    return fmt::format(
        "// Made by impulse site: [address, page, heading, text]\n"
        "window.impulseTexts = [\n{}\n];\n",
        fmt::join(rows_, ",\n"));
}

}  // namespace demos
