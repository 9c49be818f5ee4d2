#include <fmt/format.h>

#include <string_view>

#include "demos/slides/deck_files.h"
#include "demos/slides/headless.h"
#include "demos/slides/scratch_folder.h"
#include "demos/text/complaints.h"
#include "demos/text/file_content.h"
#include "demos/text/plural.h"
#include "render/encode/file.h"
#include "render/encode/program_path.h"
#include "render/error.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNoBrowser =
    "chromium is needed for a PDF; install it (apt install chromium)";

std::string posterPage(MadeDeck deck) {
    for (MadeSlide& slide : deck.slides)
        if (slide.film) slide.film->file.clear();
    return slidesPage(deck);
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

}  // namespace

std::string pdfBrowser() {
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
        if (render::programPath(name)) return name;
    return {};
}

void writeSlidesPdf(const MadeDeck& deck, const fs::path& file, render::Existing existing) {
    const std::string program = pdfBrowser();
    if (program.empty()) throw render::Error(kNoBrowser);
    render::checkReplaceable(file);
    const ScratchFolder folder;
    render::writeFileAtomically(folder.path() / "talk.html", posterPage(deck));
    std::string trouble =
        browse(program, "--print-to-pdf=" + (folder.path() / "talk.pdf").string(), folder.path());
    const std::vector<std::uint8_t> pdf = contentOf(folder.path() / "talk.pdf");
    if (trouble.empty() && pdf.empty()) trouble = "printed nothing";
    if (!trouble.empty()) trouble = withLastWords(trouble, folder.path());
    const std::size_t pages = pagesOf(pdf), slides = deck.slides.size();
    if (trouble.empty() && pages != slides)
        trouble = "printed " + plural(pages, "page") + " of " + plural(slides, "slide");
    if (!trouble.empty())
        throw render::Error(
            fmt::format("no '{}': {} {}", printable(file.string()), program, trouble));
    render::makeFolder(file.parent_path());
    render::writeFileAtomically(file, pdf, existing);
}

}  // namespace demos
