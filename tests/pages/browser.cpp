#include "tests/pages/browser.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

#include "demos/text/base64.h"
#include "render/encode/png_read.h"
#include "tests/pages/devtools.h"

namespace support {
namespace {

using Json = DevTools::Json;

constexpr int kWidth = 1400, kHeight = 900;  // pixels
constexpr int kBudget = 20'000;              // ms that the page has, in its own virtual time

/// The process that opens all pages; it ends with the tests.
DevTools& browser() {
    static const TemporaryFolder folder;
    static DevTools tools(folder.path().string());
    return tools;
}

/// The tab that shows all pages, one after the other: a new one takes half a second.
class Tab {
public:
    Tab() {
        const Json target{
            {"url", "about:blank"}, {"newWindow", true}, {"width", kWidth}, {"height", kHeight}};
        const std::string id = tools_.call("", "Target.createTarget", target).at("targetId");
        session_ = tools_.call("", "Target.attachToTarget", {{"targetId", id}, {"flatten", true}})
                       .at("sessionId");
        for (const char* domain : {"Page", "Runtime", "Network", "Log"})
            call(std::string(domain) + ".enable");
    }
    Tab(const Tab&) = delete;
    Tab& operator=(const Tab&) = delete;

    Json call(const std::string& method, const Json& params = Json::object()) {
        return tools_.call(session_, method, params);
    }

    /// Removes the page, and what it stored.
    void leave() {
        call("Runtime.evaluate",
             {{"expression", "localStorage.clear(); sessionStorage.clear(); window.name = ''"}});
        call("Page.navigate", {{"url", "about:blank"}});
    }

    void resize(const std::optional<Window>& window) {
        if (!window) return void(call("Emulation.clearDeviceMetricsOverride"));
        call("Emulation.setDeviceMetricsOverride", {{"width", window->width},
                                                    {"height", window->height},
                                                    {"deviceScaleFactor", 1},
                                                    {"mobile", false}});
    }

    /// Returns when the page has used up its virtual time, which begins with its load and goes on
    /// even if the page always has something to do.
    void go(const std::string& address) {
        tools_.clear();
        call("Emulation.setVirtualTimePolicy", {{"policy", "pause"}});
        call("Page.navigate", {{"url", address}});
        call("Emulation.setVirtualTimePolicy", {{"policy", "pauseIfNetworkFetchesPending"},
                                                {"budget", kBudget},
                                                {"maxVirtualTimeTaskStarvationCount", 9999}});
        tools_.waitFor(session_, "Emulation.virtualTimeBudgetExpired");
    }

    std::string dom() {
        return call("Runtime.evaluate", {{"expression", "document.documentElement.outerHTML"}})
            .at("result")
            .at("value");
    }

    render::Image screenshot() {
        const Json shot = call("Page.captureScreenshot", {{"optimizeForSpeed", true}});
        const std::string png = demos::fromBase64(shot.at("data").get<std::string>()).value();
        return render::decodePng({reinterpret_cast<const std::uint8_t*>(png.data()), png.size()});
    }

    /// Without remarks of a graphics driver about speed.
    std::vector<std::string> console() const {
        std::vector<std::string> lines;
        for (const Json& event : events()) {
            const std::string method = event["method"];
            const Json& params = event["params"];
            std::string line;
            if (method == "Log.entryAdded") line = params["entry"]["text"];
            if (method == "Runtime.exceptionThrown") line = params["exceptionDetails"].dump();
            if (method == "Runtime.consoleAPICalled")
                for (const Json& argument : params["args"])
                    line += argument.value("value", argument.value("description", Json())).dump();
            if (!line.empty() && line.find("GL Driver Message (OpenGL, Performance") == line.npos)
                lines.push_back(line);
        }
        return lines;
    }

    /// Without what the content policy has refused.
    std::vector<std::string> requests() const {
        std::set<std::string> refused;
        for (const Json& event : events())
            if (event["method"] == "Network.loadingFailed" &&
                event["params"].value("blockedReason", "") == "csp")
                refused.insert(event["params"]["requestId"]);
        std::vector<std::string> addresses;
        for (const Json& event : events()) {
            if (event["method"] != "Network.requestWillBeSent") continue;
            const std::string address = event["params"]["request"]["url"];
            if (address.starts_with("http") && !refused.contains(event["params"]["requestId"]))
                addresses.push_back(address);
        }
        return addresses;
    }

private:
    std::vector<Json> events() const {
        std::vector<Json> own;
        std::ranges::copy_if(tools_.events(), std::back_inserter(own), [this](const Json& event) {
            return event.value("sessionId", "") == session_;
        });
        return own;
    }

    DevTools& tools_ = browser();
    std::string session_;
};

}  // namespace

std::string contentOf(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

Opened Browser::open(std::string page, const std::string& hash, const std::string& driver,
                     std::optional<Window> window) const {
    page.insert(page.rfind("</body>"), "<script>" + driver + "</script>");
    std::ofstream(folder_ / "page.html", std::ios::binary) << page;
    std::ofstream(folder_ / "empty.svg") << R"(<svg xmlns="http://www.w3.org/2000/svg"/>)";
    static Tab tab;
    tab.resize(window);
    tab.go("file://" + (folder_ / "page.html").string() + "#" + hash);
    Opened opened{tab.dom(), tab.console(), tab.requests(), screenshots_ ? tab.screenshot() : render::Image{}};
    tab.leave();
    return opened;
}

}  // namespace support
