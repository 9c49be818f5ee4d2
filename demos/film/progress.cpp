#include "demos/film/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "demos/text/put_text.h"

namespace demos {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string minutes(double seconds) {
    const int whole = static_cast<int>(seconds + 0.5);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

bool hasText(const char* name) {
    const char* value = std::getenv(name);
    return value && *value;
}

bool isTerminal() {
    const char* term = std::getenv("TERM");
    return isatty(STDERR_FILENO) == 1 && term && std::string(term) != "dumb";
}

}  // namespace

std::string jsonString(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            out += std::string("\\") + c;
        else if (static_cast<unsigned char>(c) < 0x20)
            out += fmt::format("\\u{:04x}", static_cast<int>(c));
        else
            out += c;
    }
    return out + "\"";
}

Talk::Talk(const Options& options, bool dataOnStdout)
    : quiet_(options.quiet), json_(options.json), dataOnStdout_(dataOnStdout) {}

void Talk::say(const std::string& line) const {
    if (!quiet_ && !json_) putText(dataOnStdout_ ? stderr : stdout, line + "\n");
}

void Talk::mention(const std::string& line) const {
    if (!quiet_ && !json_) putText(stderr, line + "\n");
}

void Talk::complain(const std::string& line) const { putText(stderr, line + "\n"); }

void Talk::json(const std::string& object) const {
    if (!json_) return;
    putText(stdout, object + "\n");
    std::fflush(stdout);
}

Progress::Progress(const Options& options, int total, int kept)
    : kind_(options.quiet || options.json ? Kind::none
            : isTerminal()                ? Kind::bar
                                          : Kind::lines),
      color_(!hasText("NO_COLOR")),
      total_(total),
      kept_(kept),
      done_(kept),
      start_(Clock::now()),
      drawn_(start_) {}

double Progress::rate() const {
    const double seconds = since(start_);
    return seconds > 0.0 ? (done_ - kept_) / seconds : 0.0;
}

void Progress::advance() {
    const int before = done_++;
    if (kind_ == Kind::bar && (done_ == total_ || since(drawn_) > 0.1)) {
        drawn_ = Clock::now();
        drawBar();
    }
    const auto tenths = [this](int frames) { return 10LL * frames / total_; };
    if (kind_ == Kind::lines && tenths(done_) != tenths(before)) printLine();
}

void Progress::drawBar() const {
    constexpr int kWidth = 30;
    const int filled = static_cast<int>(static_cast<long long>(kWidth) * done_ / total_);
    std::string bar;
    for (int i = 0; i < kWidth; ++i) bar += i < filled ? "█" : "░";
    if (color_) bar = "\x1b[32m" + bar + "\x1b[0m";
    const double perSecond = rate();
    const double left = perSecond > 0.0 ? (total_ - done_) / perSecond : 0.0;
    putText(stderr, fmt::format("\r{} {}/{} frames  {:.1f} frames/s  {} left   ", bar, done_, total_,
                                perSecond, minutes(left)));
}

void Progress::printLine() const {
    const double perSecond = rate();
    const double left = perSecond > 0.0 ? (total_ - done_) / perSecond : 0.0;
    putText(stderr, fmt::format("{:3d} %  {}/{} frames  {:.1f} frames/s  {} left\n",
                                100LL * done_ / total_, done_, total_, perSecond, minutes(left)));
}

void Progress::finish() {
    if (kind_ == Kind::bar && done_ > kept_) putText(stderr, "\n");
    kind_ = Kind::none;
}

}  // namespace demos
