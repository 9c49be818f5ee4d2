/// A Markdown text of the project as HTML: CommonMark (libcmark) with GitHub's tables and with
/// formulas in dollars. Headings have the ids that GitHub gives them.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace demos {

/// Where the parts of a text lead. Each returns an address, or "" for nowhere.
struct DocumentLinks {
    std::function<std::string(const std::string& url)> link;     // "": its text stays
    std::function<std::string(const std::string& url)> picture;  // "": it is left out
    std::function<std::string(const std::string& code)> code;    // of `code` that is no link yet
};

/// What is between two headings.
struct DocumentSection {
    int level = 1;  // of its heading
    std::string id, title;
    std::string text;  // without markup, on one line
};

struct DocumentHtml {
    std::string html;
    std::vector<DocumentSection> sections;
};

DocumentHtml documentHtml(std::string_view markdown, const DocumentLinks& links);

/// "What `--show` adds" -> "what---show-adds"
std::string headingId(const std::string& title);

}  // namespace demos
