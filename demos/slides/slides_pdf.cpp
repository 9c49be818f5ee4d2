#include <fmt/format.h>
#include <unistd.h>

#include <string_view>

#include "demos/film/outputs.h"
#include "demos/processes/child_program.h"
#include "demos/slides/deck_files.h"
#include "demos/slides/scratch_folder.h"
#include "demos/text/complaints.h"
#include "demos/text/escaped_path.h"
#include "demos/text/file_content.h"
#include "demos/text/plural.h"
#include "render/encode/child.h"
#include "render/encode/file.h"
#include "render/encode/program_path.h"
#include "render/error.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNoBrowser =
    "chromium is needed for a PDF; install it (apt install chromium)";

/// 2 min, or a time set by tests of a hanging browser.
std::chrono::milliseconds patience() {
    return render::patienceOf("IMPULSE_CHROMIUM_PATIENCE_MS", std::chrono::minutes(2));
}

std::string posterPage(MadeDeck deck) {
    for (MadeSlide& slide : deck.slides)
        if (slide.film) slide.film->file.clear();
    return slidesPage(deck);
}

std::vector<std::string> printing(const std::string& program, const fs::path& folder) {
    std::vector<std::string> words{program,
                                   "--headless",
                                   "--disable-gpu",
                                   "--disable-background-networking",
                                   "--disable-component-update",
                                   "--disable-sync",
                                   "--no-first-run",
                                   "--host-resolver-rules=MAP * ~NOTFOUND",
                                   "--no-pdf-header-footer",
                                   "--virtual-time-budget=20000",
                                   "--user-data-dir=" + (folder / "profile").string(),
                                   "--print-to-pdf=" + (folder / "talk.pdf").string()};
    if (geteuid() == 0) words.emplace_back("--no-sandbox");  // the sandbox refuses root
    words.push_back("file://" + escapedPath(fs::absolute(folder / "talk.html").string()));
    return words;
}

/// Counts "/Type /Page", not "/Type /Pages": objects in Chromium's PDFs are not compressed.
std::size_t pagesOf(const std::vector<std::uint8_t>& pdf) {
    const std::string_view text(reinterpret_cast<const char*>(pdf.data()), pdf.size());
    constexpr std::string_view kPage = "/Type /Page";
    std::size_t pages = 0;
    for (std::size_t at = text.find(kPage); at != text.npos; at = text.find(kPage, at + 1))
        pages += text.substr(at + kPage.size(), 1) != "s";
    return pages;
}

/// Why there is no PDF, with the last line of the program's output; empty if there is one.
std::string troubleOf(const std::string& ended, bool printed, const fs::path& words) {
    if (ended.empty() && printed) return {};
    const std::vector<std::uint8_t> said = contentOf(words);
    const std::string line =
        render::lastLineOf({reinterpret_cast<const char*>(said.data()), said.size()});
    return (ended.empty() ? "printed nothing" : ended) + (line.empty() ? "" : ": " + line);
}

}  // namespace

std::string pdfBrowser() {
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
        if (render::programPath(name)) return name;
    return {};
}

void writeSlidesPdf(const MadeDeck& deck, const fs::path& file) {
    const std::string program = pdfBrowser();
    if (program.empty()) throw render::Error(kNoBrowser);
    render::checkReplaceable(file);
    const ScratchFolder folder;
    const fs::path words = folder.path() / "words";
    render::writeFileAtomically(folder.path() / "talk.html", posterPage(deck));
    const std::string ended = runChild(printing(program, folder.path()), words, patience());
    const std::vector<std::uint8_t> pdf = contentOf(folder.path() / "talk.pdf");
    std::string trouble = troubleOf(ended, !pdf.empty(), words);
    const std::size_t pages = pagesOf(pdf), slides = deck.slides.size();
    if (trouble.empty() && pages != slides)
        trouble = "printed " + plural(pages, "page") + " of " + plural(slides, "slide");
    if (!trouble.empty())
        throw render::Error(
            fmt::format("no '{}': {} {}", printable(file.string()), program, trouble));
    render::makeFolder(file.parent_path());
    render::writeFileAtomically(file, pdf);
}

}  // namespace demos
