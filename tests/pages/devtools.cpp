#include "tests/pages/devtools.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace support {
namespace {

constexpr int kPatience = 60'000;  // ms

/// In the child: the protocol's ends of the pipes are the descriptors 3 and 4.
[[noreturn]] void runBrowser(const std::string& folder, int commands, int answers) {
    const int log = open((folder + "/log").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int from = fcntl(commands, F_DUPFD, 10), to = fcntl(answers, F_DUPFD, 10);
    dup2(log, 1), dup2(log, 2), dup2(from, 3), dup2(to, 4);
    const std::string profile = "--user-data-dir=" + folder + "/profile";
    execl(IMPULSE_CHROMIUM, IMPULSE_CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu",
          "--enable-unsafe-swiftshader", "--disable-background-networking", "--disable-component-update",
          "--disable-sync", "--no-first-run", "--hide-scrollbars", "--disable-popup-blocking",
          "--host-resolver-rules=MAP * ~NOTFOUND", "--window-size=1400,900", "--remote-debugging-pipe",
          profile.c_str(), "about:blank", nullptr);
    _exit(127);
}

}  // namespace

DevTools::DevTools(const std::string& folder) : log_(folder + "/log") {
    int in[2], out[2];
    if (pipe2(in, O_CLOEXEC) != 0 || pipe2(out, O_CLOEXEC) != 0) fail("no pipe");
    process_ = fork();
    if (process_ == 0) runBrowser(folder, in[0], out[1]);
    close(in[0]), close(out[1]);
    commands_ = in[1], answers_ = out[0];
    if (process_ < 0) fail("no process");
}

DevTools::~DevTools() {
    close(commands_), close(answers_);  // the browser ends with its pipe
    if (process_ > 0) waitpid(process_, nullptr, 0);
}

DevTools::Json DevTools::call(const std::string& session, const std::string& method, const Json& params) {
    Json command{{"id", ++last_}, {"method", method}, {"params", params}};
    if (!session.empty()) command["sessionId"] = session;
    const std::string text = command.dump() + '\0';
    for (std::size_t sent = 0; sent < text.size();) {
        const ssize_t n = write(commands_, text.data() + sent, text.size() - sent);
        if (n <= 0) fail("the browser does not read " + method);
        sent += static_cast<std::size_t>(n);
    }
    while (true) {
        const Json message = receive();
        if (message.value("id", 0) != last_) continue;
        if (message.contains("error")) fail(method + ": " + message["error"].dump());
        return message["result"];
    }
}

void DevTools::waitFor(const std::string& session, const std::string& method) {
    for (std::size_t seen = 0;; receive())
        for (; seen < events_.size(); ++seen)
            if (events_[seen]["method"] == method && events_[seen].value("sessionId", "") == session)
                return;
}

/// The next message; an event is kept.
DevTools::Json DevTools::receive() {
    std::size_t end;
    while ((end = unread_.find('\0')) == std::string::npos) {
        pollfd ready{answers_, POLLIN, 0};
        if (poll(&ready, 1, kPatience) <= 0) fail("the browser does not answer");
        char part[65536];
        const ssize_t n = read(answers_, part, sizeof part);
        if (n <= 0) fail("the browser has ended");
        unread_.append(part, static_cast<std::size_t>(n));
    }
    Json message = Json::parse(unread_.substr(0, end));
    unread_.erase(0, end + 1);
    if (message.contains("method")) events_.push_back(message);
    return message;
}

void DevTools::fail(const std::string& what) const {
    std::ifstream file(log_);
    const std::string log{std::istreambuf_iterator<char>(file), {}};
    throw std::runtime_error(what + "\n" + log);
}

}  // namespace support
