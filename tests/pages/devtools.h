/// Chromium without a display, controlled through a pipe with the DevTools protocol.
#pragma once
#include <sys/types.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace support {

/// A browser process with its own profile; no host name resolves: no network. Errors are
/// std::runtime_error with what the browser has written.
class DevTools {
public:
    using Json = nlohmann::json;

    explicit DevTools(const std::string& folder);
    ~DevTools();
    DevTools(const DevTools&) = delete;
    DevTools& operator=(const DevTools&) = delete;

    /// The result of a command. `session`: the page that it is for, or "".
    Json call(const std::string& session, const std::string& method, const Json& params = Json::object());
    /// Waits for an event of a page. All events until then are in events().
    void waitFor(const std::string& session, const std::string& method);
    /// The events of all pages since the last clear().
    const std::vector<Json>& events() const { return events_; }
    void clear() { events_.clear(); }

private:
    Json receive();
    [[noreturn]] void fail(const std::string& what) const;

    std::string log_, unread_;
    pid_t process_ = -1;
    int commands_ = -1, answers_ = -1;  // our ends of the pipes
    int last_ = 0;                      // number of the last command
    std::vector<Json> events_;
};

}  // namespace support
