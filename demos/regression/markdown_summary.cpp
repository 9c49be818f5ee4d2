#include "demos/regression/markdown_summary.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "demos/regression/verdict_text.h"
#include "demos/text/complaints.h"
#include "demos/text/file_content.h"
#include "demos/text/plural.h"
#include "render/encode/file.h"

namespace demos {
namespace {

namespace fs = std::filesystem;
using State = SceneVerdict::State;

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

/// A text in which nothing is markup, also in a table.
std::string plainMarkdown(const std::string& text) {
    std::string escaped;
    for (const char c : printable(text)) {
        if (std::string_view("\\`*_[]<>#!|~&@$").find(c) != std::string_view::npos)
            escaped += '\\';
        escaped += c;
    }
    return escaped;
}

/// A file's name in an address: letters, digits and - . _ / as they are, others as %20.
std::string addressOf(const std::string& name) {
    std::string address;
    for (const char c : name) {
        const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') ||
                           (c >= 'a' && c <= 'z') ||
                           std::string_view("-._/").find(c) != std::string_view::npos;
        if (plain)
            address += c;
        else
            address += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return address;
}

std::string pictureCell(const PictureLinks& links, const std::string& prefix,
                        const std::string& file) {
    if (file.empty()) return "none";
    std::error_code ignored;
    const std::string name = fs::proximate(file, links.root, ignored).generic_string();
    // A name on the web cannot begin outside the checkout.
    const bool outside = name.starts_with("..") && prefix != "./";
    if (prefix.empty() || name.empty() || outside) return plainMarkdown(name.empty() ? file : name);
    return fmt::format("![{}]({}{})", plainMarkdown(fs::path(file).filename().string()), prefix,
                       addressOf(name));
}

bool isShown(const PictureVerdict& picture, const SceneVerdict& scene) {
    if (scene.state == State::added) return true;
    return !picture.passes() || picture.kind == PictureVerdict::Kind::within;
}

std::string pictureTable(const SceneVerdict& scene, const PictureLinks& links) {
    std::string rows;
    for (const PictureVerdict& picture : scene.pictures)
        if (isShown(picture, scene))
            rows += fmt::format("| {} | {} | {} |\n",
                                plainMarkdown(pictureName(scene.name, picture.time)),
                                pictureCell(links, links.baseline, picture.baseline),
                                pictureCell(links, links.actual, picture.actual));
    if (rows.empty()) return rows;
    return "\n| picture | baseline | drawn by this test |\n|---|---|---|\n" + rows;
}

std::string sceneSection(const SceneVerdict& scene, const PictureLinks& links) {
    std::string text = fmt::format("\n#### {}: {}\n\n", plainMarkdown(scene.name),
                                   nameOf(scene.state));
    for (const std::string& line : detailsOf(scene))
        text += fmt::format("* {}\n", plainMarkdown(line));
    return text + pictureTable(scene, links);
}

}  // namespace

PictureLinks pictureLinks(const std::string& file) {
    PictureLinks links{fs::current_path().string(), "", ""};
    if (variable("GITHUB_ACTIONS") == "true") {
        if (const std::string root = variable("GITHUB_WORKSPACE"); !root.empty()) links.root = root;
        links.baseline = fmt::format("{}/{}/raw/{}/", variable("GITHUB_SERVER_URL"),
                                     variable("GITHUB_REPOSITORY"), variable("GITHUB_SHA"));
    } else if (variable("GITLAB_CI") == "true") {
        if (const std::string root = variable("CI_PROJECT_DIR"); !root.empty()) links.root = root;
        const std::string project = variable("CI_PROJECT_URL");
        links.baseline = fmt::format("{}/-/raw/{}/", project, variable("CI_COMMIT_SHA"));
        links.actual =
            fmt::format("{}/-/jobs/{}/artifacts/raw/", project, variable("CI_JOB_ID"));
    } else {
        links.root = fs::absolute(file).parent_path().string();
        links.baseline = links.actual = "./";
    }
    return links;
}

std::string markdownSummary(const TestVerdict& verdict, const PictureLinks& links) {
    std::string text = fmt::format("### impulse test: {}\n", plainMarkdown(summaryOf(verdict)));
    std::size_t left = 0;
    for (const SceneVerdict& scene : verdict.scenes) {
        if (scene.state == State::passed && scene.changedScene().empty()) continue;
        const std::string section = sceneSection(scene, links);
        if (text.size() + section.size() > kMostSummary)
            ++left;
        else
            text += section;
    }
    if (left > 0) text += fmt::format("\n{} more: see report.html\n", plural(left, "scene"));
    for (const std::string& orphan : verdict.orphans)
        text += fmt::format("\n* {} belongs to no scene\n", plainMarkdown(orphan));
    return text;
}

void writeSummary(const std::string& file, const std::string& text) {
    std::string before;
    if (file == variable("GITHUB_STEP_SUMMARY")) {
        const std::vector<std::uint8_t> bytes = contentOf(file, kMostSummary);
        before.assign(bytes.begin(), bytes.end());
        if (!before.empty()) before += "\n";
    }
    render::writeFileAtomically(file, before + text);
}

}  // namespace demos
