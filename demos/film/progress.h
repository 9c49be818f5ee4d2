/// A run's output while it works: a bar on a terminal, a line per 10 % elsewhere, JSON lines for
/// programs. Progress goes to standard error, results and JSON to standard output.
#pragma once
#include <chrono>
#include <string>

#include "demos/options/options.h"
#include "demos/text/hex_text.h"

namespace demos {

/// `text` as a JSON string, with its quotes.
std::string jsonString(const std::string& text);

/// Prints results on standard output, or on standard error if standard output carries data;
/// nothing with --quiet or --json.
class Talk {
public:
    Talk(const Options& options, bool dataOnStdout);
    void say(const std::string& line) const;
    /// A line about the work, on standard error.
    void mention(const std::string& line) const;
    /// A line about what failed, on standard error; with --quiet and --json too.
    void complain(const std::string& line) const;
    /// A line of JSON, with --json only; flushed, so that a reader may act on it.
    void json(const std::string& object) const;

private:
    bool quiet_, json_, dataOnStdout_;
};

class Progress {
public:
    /// `kept` of the `total` frames exist already.
    Progress(const Options& options, int total, int kept);
    void advance();
    /// Ends the bar's line.
    void finish();

private:
    enum class Kind { none, bar, lines };
    void drawBar() const;
    void printLine() const;
    double rate() const;  // frames/s of this run

    Kind kind_;
    bool color_;
    int total_, kept_, done_;
    std::chrono::steady_clock::time_point start_, drawn_;
};

}  // namespace demos
