#include "demos/formulas/text_formulas.h"

#include <algorithm>
#include <string_view>

#include "demos/formulas/formula.h"

namespace demos {
namespace {

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool isDigit(char c) { return c >= '0' && c <= '9'; }

class FormulaScanner {
public:
    explicit FormulaScanner(const std::string& text) : text_(text) {}

    ScannedText scan() {
        while (i_ < text_.size()) {
            if (text_[i_] == '\\')
                i_ += 2;
            else if (text_[i_] == '`')
                skipCode();
            else if (text_[i_] == '$')
                takeFormula();
            else
                ++i_;
        }
        return std::move(found_);
    }

private:
    std::size_t runOf(char c, std::size_t from) const {
        return std::min(text_.find_first_not_of(c, from), text_.size()) - from;
    }

    /// Code ends with as many backquotes as it began with; without these there is no code.
    void skipCode() {
        const std::size_t begin = i_, ticks = runOf('`', i_);
        i_ += ticks;
        if (ticks < unclosed_.size() && unclosed_[ticks]) return;
        for (std::size_t j = text_.find('`', i_); j < text_.size(); j = text_.find('`', j)) {
            const std::size_t run = runOf('`', j);
            j += run;
            if (run != ticks) continue;
            i_ = j;
            found_.code.push_back({begin, j});
            return;
        }
        unclosed_.resize(std::max(unclosed_.size(), ticks + 1));
        unclosed_[ticks] = true;
    }

    bool emptyLineAt(std::size_t newline) const {
        const std::size_t next = text_.find_first_not_of(" \t\r", newline + 1);
        return next == std::string::npos || text_[next] == '\n';
    }

    bool closes(std::size_t at, std::size_t from, bool display) const {
        if (display) return at + 1 < text_.size() && text_[at + 1] == '$' && at > from;
        const bool digit = at + 1 < text_.size() && isDigit(text_[at + 1]);
        return at > from && !isSpace(text_[at - 1]) && !digit;
    }

    /// Where the formula's last dollars begin; the text's size if they are missing.
    std::size_t closingDollar(std::size_t from, bool display) const {
        for (std::size_t j = from; j < text_.size(); ++j) {
            if (text_[j] == '\\')
                ++j;
            else if (text_[j] == '\n' && emptyLineAt(j))
                break;
            else if (text_[j] == '$' && closes(j, from, display))
                return j;
            else if (text_[j] == '$' && !display)
                break;
        }
        return text_.size();
    }

    void takeFormula() {
        const bool display = runOf('$', i_) >= 2;
        const std::size_t dollars = display ? 2 : 1;
        const std::size_t from = i_ + dollars;
        const bool opens = from < text_.size() && (display || !isSpace(text_[from]));
        const std::size_t close = opens ? closingDollar(from, display) : text_.size();
        if (close == text_.size()) {
            const bool price = !display && opens && isDigit(text_[from]);
            if (!price) found_.loose.push_back(i_);
            i_ = from;
            return;
        }
        found_.formulas.push_back(
            {text_.substr(from, close - from), display, i_, close + dollars, from});
        i_ = close + dollars;
    }

    const std::string& text_;
    std::size_t i_ = 0;
    std::vector<bool> unclosed_;  // by number of backquotes: nothing closes these from here on
    ScannedText found_;
};

}  // namespace

ScannedText scannedText(const std::string& text) { return FormulaScanner(text).scan(); }

std::vector<TextFormula> formulasIn(const std::string& text) { return scannedText(text).formulas; }

std::string mathMlIn(const TextFormula& formula) {
    try {
        return mathMlOf(formula.tex, formula.display);
    } catch (const FormulaError& error) {
        throw FormulaError(formula.at + error.at(), error.what());
    }
}

}  // namespace demos
