/// Expressions in a scene: "3 * cos(i * tau / n)" in place of a number. muparser reads them; what
/// they may call is here, and gives the same bits on every machine: the library's own functions and
/// operators, which are the C library's, are not there.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace demos {

constexpr int kDeepestRepeat = 3;

/// Which turn of which [[repeat]] a table is read for: i, j, k and how many turns each has.
struct Turns {
    int depth = 0;  // 0: not in a [[repeat]]; 1: i counts; 2: i and j; 3: and k
    int index[kDeepestRepeat] = {};
    int count[kDeepestRepeat] = {};
};

/// A number, or what is wrong with the text: the end of a sentence.
struct Evaluated {
    std::optional<double> value;  // finite
    std::string wrong;
};

class Expressions {
public:
    Expressions();
    ~Expressions();

    /// A name that later expressions know. Empty, or why it cannot be one.
    std::string whyNoName(std::string_view name) const;
    void define(const std::string& name, double value);
    /// Names that will be defined, for messages; each until it is withdrawn.
    void announce(const std::string& name) { later_.insert(name); }
    void withdraw(const std::string& name) { later_.erase(name); }

    /// At most 200 characters: numbers, names, + - * / ^ ( ) and commas.
    Evaluated evaluate(std::string_view text, const Turns& turns);

private:
    std::string checkName(std::string_view name, bool called, const Turns& turns) const;
    std::string checkWords(std::string_view text, const Turns& turns) const;
    Evaluated computed(const std::string& text);
    std::vector<std::string> names(const Turns& turns) const;

    class Parser;
    std::unique_ptr<Parser> parser_;
    std::map<std::string, double, std::less<>> values_;
    std::set<std::string, std::less<>> later_;
    double turns_[2 * kDeepestRepeat + 1] = {};  // i j k ni nj nk n
    int evaluated_ = 0;
};

/// In [0, 1), 53 bits: as good as chance, and the same everywhere for the same numbers.
double hashed(const double* numbers, int count);

}  // namespace demos
