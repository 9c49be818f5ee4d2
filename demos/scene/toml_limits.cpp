#include "demos/scene/toml_limits.h"

#include <algorithm>

namespace demos {
namespace {

class Scan {
public:
    explicit Scan(std::string_view text) : text_(text) {}

    std::optional<BeyondLimit> run() {
        if (text_.starts_with("\xff\xfe") || text_.starts_with("\xfe\xff"))
            return beyond("UTF-16; save the file as UTF-8");
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '#') {
                skipTo("\n");
                continue;
            }
            if (c == '"' || c == '\'') {
                skipQuoted(c);
                continue;
            }
            count(c);
            if (isBeyondAscii(c) && !isByteOrderMark())
                return beyond("a character beyond ASCII; put it in quotes or in a comment");
            if (depth_ > kDeepestNesting) return beyond("nested deeper than 32 tables and arrays");
            if (dots_ >= kDeepestNesting) return beyond("a key of more than 32 parts");
            if (values_ > kMostTomlValues) return beyond("more than a million values");
            ++at_;
        }
        return std::nullopt;
    }

private:
    static bool isBeyondAscii(char c) { return static_cast<unsigned char>(c) >= 0x80; }

    /// An editor may have written EF BB BF at the very beginning.
    bool isByteOrderMark() const { return at_ < 3 && text_.starts_with("\xef\xbb\xbf"); }

    void count(char c) {
        if (c == '[' || c == '{') ++depth_;
        if ((c == ']' || c == '}') && depth_ > 0) --depth_;
        if (c == ',' || c == '=' || c == '\n') ++values_;
        if (c == '.')
            ++dots_;
        else if (std::string_view("[]{},=\n").find(c) != std::string_view::npos)
            dots_ = 0;
        if (c == '\n') ++line_, lineStart_ = at_ + 1;
    }

    /// Moves at_ to the next occurrence of `end`, or to the end of the text.
    void skipTo(std::string_view end) {
        const std::size_t found = text_.find(end, at_);
        at_ = found == std::string_view::npos ? text_.size() : found;
    }

    void skipQuoted(char quote) {
        const bool block = text_.substr(at_, 3) == std::string(3, quote);
        at_ += block ? 3 : 1;
        while (at_ < text_.size()) {
            if (text_[at_] == '\n') {
                if (!block) return;  // not closed: the parser reports it
                ++line_, lineStart_ = at_ + 1;
            }
            if (quote == '"' && text_[at_] == '\\') {
                at_ += at_ + 1 < text_.size() && text_[at_ + 1] != '\n' ? 2 : 1;
                continue;
            }
            if (block ? text_.substr(at_, 3) == std::string(3, quote) : text_[at_] == quote) {
                at_ += block ? 3 : 1;
                // Up to two more quotes belong to the text: of five in a row, the first two.
                for (int i = 0; block && i < 2 && at_ < text_.size() && text_[at_] == quote; ++i)
                    ++at_;
                return;
            }
            ++at_;
        }
    }

    BeyondLimit beyond(const char* what) const {
        // Columns are characters, as toml++ counts them: a byte 10xxxxxx continues one.
        const std::string_view before = text_.substr(lineStart_, at_ - lineStart_);
        const auto characters = std::count_if(before.begin(), before.end(), [](char c) {
            return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u;
        });
        return {{line_, static_cast<int>(characters) + 1}, what};
    }

    std::string_view text_;
    std::size_t at_ = 0, lineStart_ = 0;
    int line_ = 1, depth_ = 0, dots_ = 0, values_ = 0;
};

}  // namespace

std::optional<BeyondLimit> beyondLimits(std::string_view text) { return Scan(text).run(); }

}  // namespace demos
