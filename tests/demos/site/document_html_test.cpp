// Texts of the project as pages: tables, ids, links.
#include "demos/site/document_html.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "demos/site/documents.h"
#include "demos/site/key_reference.h"
#include "demos/site/site_links.h"

namespace {

using namespace demos;

/// Links and pictures as they are, except those to "gone"; no code is a link but `key`.
const DocumentLinks kPlain{
    [](const std::string& url) { return url == "gone" ? "" : url; },
    [](const std::string& url) { return url == "gone" ? "" : url; },
    [](const std::string& code) { return code == "key" ? std::string("keys.html#key") : ""; }};

std::string htmlOfText(const std::string& markdown) { return documentHtml(markdown, kPlain).html; }

TEST(DocumentHtml, HasGitHubsTables) {
    EXPECT_EQ(htmlOfText("| a | *b* |\n|---|--:|\n| `x\\|y` | 2 |\n\nAfter.\n"),
              "<div class=\"table\"><table>\n"
              "<thead><tr><th>a</th><th class=\"number\"><em>b</em></th></tr></thead>\n<tbody>\n"
              "<tr><td><code>x|y</code></td><td class=\"number\">2</td></tr>\n"
              "</tbody></table></div>\n<p>After.</p>\n");
    EXPECT_EQ(htmlOfText("```\n| a |\n|---|\n```\n"), "<pre><code>| a |\n|---|\n</code></pre>\n")
        << "in a block it is text";
}

TEST(DocumentHtml, HeadingsHaveTheIdsOfGitHub) {
    EXPECT_EQ(headingId("What `--show` adds"), "what---show-adds");
    EXPECT_EQ(headingId("When steady, when fast, when seed"), "when-steady-when-fast-when-seed");
    const DocumentHtml made =
        documentHtml("# A b\n\nFirst *words*\nhere.\n\n## A b\n\nMore.\n", kPlain);
    EXPECT_EQ(made.html,
              "<h1 id=\"a-b\">A b</h1>\n<p>First <em>words</em>\nhere.</p>\n"
              "<h2 id=\"a-b-1\">A b</h2>\n<p>More.</p>\n");
    ASSERT_EQ(made.sections.size(), 2u);
    EXPECT_EQ(made.sections[0].text, "First words here.");
    EXPECT_EQ(made.sections[1].level, 2);
}

TEST(DocumentHtml, LinksLeadOnOrAreText) {
    EXPECT_EQ(htmlOfText("[a](b.md) [c](gone)"), "<p><a href=\"b.md\">a</a> c</p>\n");
    EXPECT_EQ(htmlOfText("`key` `other` [`key`](b)"),
              "<p><a href=\"keys.html#key\"><code>key</code></a> <code>other</code> "
              "<a href=\"b\"><code>key</code></a></p>\n");
    EXPECT_EQ(htmlOfText("![p \"q\"](a.png)![r](gone)"),
              "<p><img src=\"a.png\" alt=\"p \u201cq\u201d\" loading=\"lazy\"></p>\n");
    EXPECT_EQ(htmlOfText("a <b onclick=1> c").find("<b"), std::string::npos);
}

TEST(DocumentHtml, HasFormulas) {
    const DocumentHtml made =
        documentHtml("It is $a|b$, for `$x$`.\n\n| $c$ |\n|---|\n| $\\cancel d$ |\n", kPlain);
    EXPECT_NE(made.html.find("<p>It is <math"), std::string::npos) << made.html;
    EXPECT_NE(made.html.find("</math>, for <code>$x$</code>.</p>"), std::string::npos) << made.html;
    EXPECT_NE(made.html.find("<th><math"), std::string::npos) << made.html;
    EXPECT_NE(made.html.find("<td><code>\\cancel d</code></td>"), std::string::npos) << made.html;
    EXPECT_EQ(made.sections[0].text, "It is a|b, for $x$. c \\cancel d");
}

TEST(SiteLinks, FollowTheSources) {
    EXPECT_EQ(pathFrom("demos/scenes/recipes.md", "../scene/README.md#values"),
              "demos/scene/README.md");
    EXPECT_EQ(pathFrom("README.md", "engine/"), "engine");
    const std::vector<std::string> scenes{"wall"};
    const DocumentLinks links = linksOf(*pageShowing("demos/scenes/recipes.md"), scenes);
    EXPECT_EQ(links.link("first-scene.md"), "first-scene.html");
    EXPECT_EQ(links.link("../README.md#incidents"), "program.html#incidents");
    EXPECT_EQ(links.link("../scene"), "scene-format.html");
    EXPECT_EQ(links.link("wall.toml"), "") << "not on the site";
    EXPECT_EQ(links.link("https://commonmark.org"), "https://commonmark.org");
    EXPECT_EQ(links.code("camera.fov_deg"), "keys.html#camera.fov_deg");
    EXPECT_EQ(links.code("solver.slop = 1e-4"), "keys.html#solver.slop");
    EXPECT_EQ(links.code("[[joint]]"), "keys.html#joint");
    EXPECT_EQ(links.code("mass"), "");
    EXPECT_EQ(links.code("wall"), "");
    EXPECT_EQ(linksOf(*pageShowing("demos/scenes/README.md"), scenes).code("wall"),
              "gallery/index.html#scene-wall");
    EXPECT_EQ(linksOf(*pageShowing("README.md"), scenes).picture(".github/wall.png"),
              "gallery/wall.png");
    EXPECT_EQ(linksOf(*pageShowing("README.md"), {}).picture(".github/wall.png"), "");
    EXPECT_EQ(
        linksOf(*pageShowing("demos/scenes/first-scene.md"), {}).picture("pictures/table.png"),
        "pictures/table.png");
}

/// Every text is on a page, as it is in the sources, and every page has its text.
TEST(SitePages, ShowEveryText) {
    std::set<std::string> files;
    for (const SiteDocument& document : documents()) {
        const bool text = document.path.ends_with(".md");
        EXPECT_TRUE(!text || pageShowing(document.path)) << document.path;
        std::error_code error;
        EXPECT_EQ(std::filesystem::file_size(
                      std::filesystem::path(IMPULSE_SOURCE_DIR) / document.path, error),
                  document.text.size())
            << document.path;
    }
    for (const SitePage& page : sitePages()) {
        EXPECT_TRUE(!*page.source || documentAt(page.source)) << page.source;
        EXPECT_TRUE(files.insert(page.file).second) << page.file;
    }
}

TEST(KeyReference, HasEveryKeyOnceWithItsFacts) {
    const DocumentHtml made = keyReference();
    std::set<std::string> ids;
    for (const DocumentSection& section : made.sections) {
        EXPECT_TRUE(ids.insert(section.id).second) << section.id;
        EXPECT_NE(made.html.find("id=\"" + section.id + "\""), std::string::npos) << section.id;
    }
    EXPECT_TRUE(ids.contains("solver.baumgarte") && ids.contains("body.shape.sphere"));
    EXPECT_GE(ids.size(), 240u);
    const std::size_t at = made.html.find("id=\"camera.fov_deg\"");
    ASSERT_NE(at, std::string::npos);
    const std::string key = made.html.substr(at, made.html.find("</dd>", at) - at);
    for (const char* fact : {"<i>unit</i> deg<", "<i>default</i> 35", "<i>range</i> 1 to 170"})
        EXPECT_NE(key.find(fact), std::string::npos) << key;
    EXPECT_NE(made.html.find("and <code>--set</code> may"), std::string::npos);
    EXPECT_EQ(made.html.find("\u2013set"), std::string::npos);
}

}  // namespace
