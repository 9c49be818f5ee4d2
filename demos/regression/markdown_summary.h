/// The verdict as Markdown for the page of a job or a pull request (GitHub, GitLab).
#pragma once
#include <string>

#include "demos/regression/verdict.h"

namespace demos {

/// Where a page finds the pictures. An empty prefix: it cannot show them, and their names are
/// given.
struct PictureLinks {
    std::string root;      ///< folder that names on the web begin in: of the checkout
    std::string baseline;  ///< what comes before the name of a committed picture
    std::string actual;    ///< and of one that the test has drawn
};

/// On GitHub (GITHUB_ACTIONS=true) committed pictures at their commit; artifacts cannot be linked.
/// On GitLab (GITLAB_CI=true) also what the job keeps. Elsewhere names relative to the folder of
/// `file`.
PictureLinks pictureLinks(const std::string& file);

/// The result, a table of pictures and the differences of each scene that did not pass, new and
/// updated ones too; at most `kMostSummary` bytes.
std::string markdownSummary(const TestVerdict& verdict, const PictureLinks& links);

inline constexpr std::size_t kMostSummary = 900'000;  // bytes; GitHub takes 1 MiB a step

/// Gives the file this text. What a job has already written to $GITHUB_STEP_SUMMARY is kept: the
/// text is added to it. Throws render::Error.
void writeSummary(const std::string& file, const std::string& text);

}  // namespace demos
