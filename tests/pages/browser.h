/// Opens a page in headless Chromium.
#pragma once
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "render/image.h"
#include "tests/support/temporary_folder.h"

namespace support {

std::string contentOf(const std::filesystem::path& path);

/// The page's own size, CSS pixels.
struct Window {
    int width, height;
};

/// The results of opening a page.
struct Opened {
    std::string dom;                    // after its script ran
    std::vector<std::string> console;   // its messages, including refusals by the content policy
    std::vector<std::string> requests;  // addresses it requested from the network
    render::Image screenshot;           // 1400x900, or the window; if asked for
};

/// Pages in files of a folder. All of them are opened by one browser process, in one tab; nothing that
/// one stores is there for the next.
class Browser {
public:
    explicit Browser(const TemporaryFolder& folder, bool screenshots = false)
        : folder_(folder), screenshots_(screenshots) {}

    /// `driver`: a script that runs after the page's own. `hash`: "scene=a&mode=7". `window`: by
    /// default one of 1400x900 with the browser's own frame.
    Opened open(std::string page, const std::string& hash, const std::string& driver = "",
                std::optional<Window> window = {}) const;

private:
    const TemporaryFolder& folder_;
    bool screenshots_;  // a sixth of a second each
};

}  // namespace support
