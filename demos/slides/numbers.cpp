#include "demos/slides/numbers.h"

#include <charconv>
#include <optional>
#include <string_view>

#include "demos/measures/summary.h"
#include "demos/text/complaints.h"
#include "demos/text/nearest.h"

namespace demos {
namespace {

constexpr int kMostRuns = 1000;  // of a sweep
constexpr int kMostDigits = 9;
constexpr std::size_t kShortest = 3;  // letters of a beginning that is completed

struct Group {
    const char* name;
    const char* article;
    bool named;  // whether its numbers are those of one body or joint
    std::vector<std::string> fields;
};

const std::vector<Group>& groups() {
    static const std::vector<Group> all = {
        {"body", "a body", true, {"position", "velocity", "spin", "height", "speed"}},
        {"joint", "a joint", true, {"impulse", "force", "separation"}},
        {"contacts", "'contacts'", false, {"impulse", "points", "largest"}},
        {"run", "a run", false, {"time", "steps", "sweeps", "energy", "hash"}}};
    return all;
}

/// All names of numbers, for suggestions.
std::vector<std::string> spellings() {
    std::vector<std::string> all;
    for (const Measure& measure : measures()) all.emplace_back(measure.name);
    all.emplace_back("expect.1");
    for (const Group& group : groups())
        for (const std::string& field : group.fields)
            all.push_back(std::string(group.name) + (group.named ? ".NAME." : ".") + field);
    return all;
}

std::optional<int> wholeFrom(std::string_view text) {
    int value = 0;
    const char* end = text.data() + text.size();
    const std::from_chars_result read = std::from_chars(text.data(), end, value);
    if (read.ec == std::errc() && read.ptr == end) return value;
    return std::nullopt;
}

/// Reads the text between the braces.
class NumberReader {
public:
    NumberReader(std::string_view text, std::size_t at) : whole_(text), rest_(text), at_(at) {}

    NumberName read() {
        NumberName name;
        if (const std::size_t colon = rest_.rfind(':'); colon != std::string_view::npos) {
            name.digits = readDigits(rest_.substr(colon + 1));
            name.zeros = Zeros::kept;
            rest_ = rest_.substr(0, colon);
        }
        readRun(name);
        const std::size_t dot = rest_.find('.');
        name.group = rest_.substr(0, dot);
        if (dot == std::string_view::npos) return measure(std::move(name));
        rest_ = rest_.substr(dot + 1);
        if (name.group == "expect") return expectation(std::move(name));
        for (const Group& group : groups())
            if (name.group == group.name) return member(std::move(name), group);
        failUnknown(whole_);
    }

private:
    [[noreturn]] void fail(const std::string& what) const { throw NumberError(at_, what); }

    [[noreturn]] void failUnknown(std::string_view name) const {
        for (const std::string& whole : spellings())
            if (name.size() >= kShortest && whole.starts_with(name))
                fail("no number is called '" + shown(name) + "'; did you mean '" + whole + "'?");
        fail("no number is called '" + shown(name) + "'" + suggestion(name, spellings()));
    }

    int readDigits(std::string_view text) const {
        const std::optional<int> digits = wholeFrom(text);
        if (digits && *digits >= 1 && *digits <= kMostDigits) return *digits;
        fail("'" + shown(text) + "' significant digits; it should be a whole number from 1 to " +
             std::to_string(kMostDigits));
    }

    void readRun(NumberName& name) {
        const std::size_t dot = rest_.find('.');
        if (dot == std::string_view::npos || rest_.find_first_not_of("0123456789") != dot ||
            dot == 0)
            return;
        const std::optional<int> run = wholeFrom(rest_.substr(0, dot));
        if (!run || *run < 1 || *run > kMostRuns)
            fail("run " + shown(rest_.substr(0, dot)) + "; it should be from 1 to " +
                 std::to_string(kMostRuns));
        name.run = *run;
        rest_ = rest_.substr(dot + 1);
    }

    NumberName measure(NumberName name) const {
        if (measureCalled(name.group) < 0) failUnknown(rest_);
        name.field = name.group;
        name.group = "measure";
        return name;
    }

    NumberName expectation(NumberName name) const {
        const std::optional<int> number = wholeFrom(rest_);
        if (!number || *number < 1 || *number > kMostExpectations)
            fail("expectation '" + shown(rest_) + "'; they count from 1, as in @{expect.1}");
        name.of = std::to_string(*number);
        return name;
    }

    /// A body's name may have dots: the field is what comes after the last one.
    NumberName member(NumberName name, const Group& group) const {
        const std::size_t dot = group.named ? rest_.rfind('.') : std::string_view::npos;
        const bool has = dot != std::string_view::npos;
        if (group.named && (!has || dot == 0))
            fail("'" + shown(whole_) + "' has no field; write @{" + name.group + ".NAME." +
                 group.fields.front() + "}");
        name.of = has ? rest_.substr(0, dot) : std::string_view();
        name.field = has ? rest_.substr(dot + 1) : rest_;
        for (const std::string& field : group.fields)
            if (field == name.field) return name;
        fail(std::string(group.article) + " has no '" + shown(name.field) + "'" +
             suggestion(name.field, group.fields));
    }

    std::string_view whole_, rest_;
    std::size_t at_;
};

/// The position of the brace that closes the one at `open`; a body's name may have paired braces.
std::size_t closingBrace(const std::string& text, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < text.size() && text[i] != '\n'; ++i) {
        if (text[i] == '{') ++depth;
        if (text[i] == '}' && --depth == 0) return i;
    }
    return std::string::npos;
}

}  // namespace

NumberedText numberedText(const std::string& text) {
    NumberedText result;
    result.words.emplace_back();
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '@' && i + 1 < text.size() && text[i + 1] == '{') {
            const std::size_t close = closingBrace(text, i + 1);
            if (close == std::string::npos)
                throw NumberError(i, "'" + shown(std::string_view(text).substr(i, 24)) +
                                         "' has no } in its line; write \\@{ for an @ and a brace");
            const std::string_view name = std::string_view(text).substr(i + 2, close - i - 2);
            result.numbers.push_back(NumberReader(name, i).read());
            result.places.push_back(i);
            result.ends.push_back(close + 1);
            result.words.emplace_back();
            i = close;
            continue;
        }
        result.words.back() += text[i];
        // In CommonMark \@ is an @ and \\ a backslash.
        if (text[i] == '\\' && i + 1 < text.size()) result.words.back() += text[++i];
    }
    return result;
}

std::string maskedNumbers(const std::string& text, const NumberedText& parts, char letter) {
    std::string masked = text;
    for (std::size_t i = 0; i < parts.places.size(); ++i)
        masked.replace(parts.places[i], parts.ends[i] - parts.places[i],
                       parts.ends[i] - parts.places[i], letter);
    return masked;
}

}  // namespace demos
