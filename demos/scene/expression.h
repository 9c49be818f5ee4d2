/// Expressions in a scene: "3 * cos(i * tau / n)" instead of a number. muparser parses them with
/// the functions and operators of this project only, which give the same bits on every machine;
/// those of the library would depend on the C library.
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
constexpr std::size_t kLongestExpression = 200;
constexpr int kMostEvaluated = 300'000;  // of a scene: two seconds of evaluating

/// The turn of each [[repeat]] around a table: the indices i, j, k and the numbers of turns.
struct Turns {
    int depth = 0;  // 0: not in a [[repeat]]; 1: i is defined; 2: i and j; 3: i, j and k
    int index[kDeepestRepeat] = {};
    int count[kDeepestRepeat] = {};
};

/// A number, or what is wrong with the text, as the end of a sentence.
struct Evaluated {
    std::optional<double> value;  // finite
    std::string wrong;
    bool unit = false;  // a word or sign that is not known follows a number: "7800 kg"
};

class Expressions {
public:
    Expressions();
    ~Expressions();

    /// Empty if `name` can be defined for later expressions, else why not.
    std::string whyNoName(std::string_view name) const;
    void define(const std::string& name, double value);
    /// A name that will be defined later, for messages, until it is withdrawn.
    void announce(const std::string& name) { later_.insert(name); }
    void withdraw(const std::string& name) { later_.erase(name); }

    /// At most 200 characters: numbers, names, + - * / ^ ( ) and commas.
    Evaluated evaluate(std::string_view text, const Turns& turns);

private:
    std::string checkName(std::string_view name, bool called, const Turns& turns) const;
    /// `at`: where the check ended.
    std::string checkWords(std::string_view text, const Turns& turns, std::size_t& at) const;
    Evaluated computed(const std::string& text);
    std::vector<std::string> names(const Turns& turns) const;

    class Parser;
    std::unique_ptr<Parser> parser_;
    std::map<std::string, double, std::less<>> values_;
    std::set<std::string, std::less<>> later_;
    double turns_[2 * kDeepestRepeat + 1] = {};  // i j k ni nj nk n
    int evaluated_ = 0;
};

/// A pseudo-random number in [0, 1) of 53 bits, the same on every machine for the same numbers.
double hashed(const double* numbers, int count);

}  // namespace demos
