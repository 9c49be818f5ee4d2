#include "demos/slides/headless.h"

#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <vector>

#include "demos/processes/child_program.h"
#include "demos/text/escaped_path.h"
#include "demos/text/file_content.h"
#include "render/encode/child.h"

namespace demos {
namespace {

/// 2 min, or a time set by tests of a hanging browser.
std::chrono::milliseconds browserPatience() {
    return render::patienceOf("IMPULSE_CHROMIUM_PATIENCE_MS", std::chrono::minutes(2));
}

}  // namespace

std::string browse(const std::string& program, const std::string& action,
                   const std::filesystem::path& folder) {
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
                                   action};
    if (geteuid() == 0) words.emplace_back("--no-sandbox");  // the sandbox refuses root
    words.push_back("file://" +
                    escapedPath(std::filesystem::absolute(folder / "talk.html").string()));
    return runChild(words, folder / "words", browserPatience());
}

std::string withLastWords(const std::string& trouble, const std::filesystem::path& folder) {
    const std::vector<std::uint8_t> said = contentOf(folder / "words");
    const std::string line =
        render::lastLineOf({reinterpret_cast<const char*>(said.data()), said.size()});
    return trouble + (line.empty() ? "" : ": " + line);
}

}  // namespace demos
