/// Opens a page in headless Chromium.
#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "render/image.h"
#include "tests/support/temporary_folder.h"

namespace support {

std::string contentOf(const std::filesystem::path& path);

struct Window {
    int width = 1400, height = 900;  // CSS pixels
};

/// The results of opening a page.
struct Opened {
    std::string dom;                    // after its script ran
    std::vector<std::string> console;   // its messages, including refusals by the content policy
    std::vector<std::string> requests;  // addresses it requested from the network
    render::Image screenshot;           // of the window
};

/// Pages in files of a folder. All of them are opened by one browser process, each in a context of
/// its own: nothing that one stores is there for the next.
class Browser {
public:
    explicit Browser(const TemporaryFolder& folder) : folder_(folder) {}

    /// `driver`: a script that runs after the page's own. `hash`: "scene=a&mode=7".
    Opened open(std::string page, const std::string& hash, const std::string& driver = "",
                Window window = {}) const;

private:
    const TemporaryFolder& folder_;
};

}  // namespace support
