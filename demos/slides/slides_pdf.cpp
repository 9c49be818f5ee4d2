#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

#include "demos/file_content.h"
#include "demos/film/outputs.h"
#include "demos/slides/child_program.h"
#include "demos/slides/deck_files.h"
#include "demos/slides/scratch_folder.h"
#include "render/encode/file.h"
#include "render/encode/program_path.h"
#include "render/error.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

/// 2 min, or the milliseconds of IMPULSE_CHROMIUM_PATIENCE_MS, which tests of hanging ones set.
std::chrono::milliseconds patience() {
    constexpr int kDefault = 120'000, kMost = 86'400'000;
    const char* text = std::getenv("IMPULSE_CHROMIUM_PATIENCE_MS");
    const int asked = text ? std::atoi(text) : kDefault;
    return std::chrono::milliseconds(asked >= 1 && asked <= kMost ? asked : kDefault);
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
    if (geteuid() == 0) words.emplace_back("--no-sandbox");  // whose sandbox refuses root
    words.push_back("file://" + (folder / "talk.html").string());
    return words;
}

/// "/Type /Page", not "/Type /Pages": Chromium's PDFs have their objects in the open.
std::size_t pagesOf(const std::vector<std::uint8_t>& pdf) {
    const std::string_view text(reinterpret_cast<const char*>(pdf.data()), pdf.size());
    constexpr std::string_view kPage = "/Type /Page";
    std::size_t pages = 0;
    for (std::size_t at = text.find(kPage); at != text.npos; at = text.find(kPage, at + 1))
        pages += text.substr(at + kPage.size(), 1) != "s";
    return pages;
}

}  // namespace

std::string pdfBrowser() {
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
        if (render::programPath(name)) return name;
    return {};
}

void writeSlidesPdf(const MadeDeck& deck, const fs::path& file) {
    const std::string program = pdfBrowser();
    if (program.empty())
        throw render::Error("chromium is needed for a PDF; install it (apt install chromium)");
    render::checkReplaceable(file);
    const ScratchFolder folder;
    render::writeFileAtomically(folder.path() / "talk.html", posterPage(deck));
    const std::string trouble =
        runChild(printing(program, folder.path()), folder.path() / "words", patience());
    const std::vector<std::uint8_t> pdf = contentOf(folder.path() / "talk.pdf");
    if (!trouble.empty() || pdf.empty())
        throw render::Error(fmt::format("no '{}': {} {}", file.string(), program,
                                        trouble.empty() ? "printed nothing" : trouble));
    if (pagesOf(pdf) != deck.slides.size())
        throw render::Error(fmt::format("no '{}': {} printed {} pages of {} slides", file.string(),
                                        program, pagesOf(pdf), deck.slides.size()));
    makeFolder(file.parent_path());
    render::writeFileAtomically(file, pdf);
}

}  // namespace demos
