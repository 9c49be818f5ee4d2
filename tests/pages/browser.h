/// Opens a page in headless Chromium with its own profile; no host name resolves: no network.
#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "render/encode/png_read.h"
#include "tests/support/temporary_folder.h"

namespace support {

inline std::string contentOf(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The results of opening a page.
struct Opened {
    std::string dom;                    // after its script ran
    std::vector<std::string> console;   // its messages, including refusals by the content policy
    std::vector<std::string> requests;  // addresses it requested from the network
    render::Image screenshot;           // 1400x900
};

class Browser {
public:
    explicit Browser(const TemporaryFolder& folder) : folder_(folder) {}

    /// `driver`: a script that runs after the page's own. `hash`: "scene=a&mode=7".
    Opened open(std::string page, const std::string& hash, const std::string& driver = "") const {
        const std::size_t end = page.rfind("</body>");
        page.insert(end, "<script>" + driver + "</script>");
        std::ofstream(folder_ / "page.html", std::ios::binary) << page;
        std::ofstream(folder_ / "empty.svg") << R"(<svg xmlns="http://www.w3.org/2000/svg"/>)";
        run("file://" + (folder_ / "page.html").string() + "#" + hash);
        Opened opened;
        opened.dom = contentOf(folder_ / "dom");
        opened.console = consoleLines();
        opened.requests = pageRequests();
        const std::string png = contentOf(folder_ / "shot.png");
        if (!png.empty())
            opened.screenshot =
                render::decodePng({reinterpret_cast<const std::uint8_t*>(png.data()), png.size()});
        return opened;
    }

private:
    void run(const std::string& address) const {
        const std::string at = folder_.path().string();
        const std::string command =
            "cd " + at +
            " && timeout 60 " IMPULSE_CHROMIUM
            " --headless --no-sandbox --disable-gpu --enable-unsafe-swiftshader"
            " --disable-background-networking"
            " --disable-component-update --disable-sync --no-first-run --hide-scrollbars"
            " --disable-popup-blocking"
            " --host-resolver-rules='MAP * ~NOTFOUND' --user-data-dir=" +
            at +
            "/profile"
            " --enable-logging=stderr --log-net-log=" +
            at +
            "/net.json --window-size=1400,900"
            " --virtual-time-budget=20000 --screenshot=" +
            at + "/shot.png --dump-dom '" + address + "' >dom 2>log";
        ASSERT_EQ(std::system(command.c_str()), 0) << contentOf(folder_ / "log");
    }

    /// "[..:INFO:CONSOLE:17] "text", source: ..."; without remarks of a graphics driver about
    /// speed.
    std::vector<std::string> consoleLines() const {
        std::vector<std::string> lines;
        std::istringstream log(contentOf(folder_ / "log"));
        for (std::string line; std::getline(log, line);)
            if (line.find("CONSOLE") != line.npos &&
                line.find("GL Driver Message (OpenGL, Performance") == line.npos)
                lines.push_back(line);
        return lines;
    }

    static std::string valueOf(const std::string& event, const std::string& key) {
        const std::string mark = '"' + key + "\":\"";
        const std::size_t at = event.find(mark);
        if (at == event.npos) return "";
        const std::size_t begin = at + mark.size();
        return event.substr(begin, event.find('"', begin) - begin);
    }

    /// Without those of the browser itself, whose initiator is "not an origin".
    std::vector<std::string> pageRequests() const {
        std::vector<std::string> addresses;
        const std::string log = contentOf(folder_ / "net.json");
        EXPECT_FALSE(log.empty());
        std::istringstream events(log);  // one per line
        for (std::string line; std::getline(events, line);) {
            const std::string initiator = valueOf(line, "initiator"), url = valueOf(line, "url");
            if (!initiator.empty() && initiator != "not an origin" && url.starts_with("http"))
                addresses.push_back(url);
        }
        return addresses;
    }

    const TemporaryFolder& folder_;
};

}  // namespace support
