#include "demos/scene/expression.h"

#include <muParserBase.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cmath>

#include "demos/scene/expression_functions.h"
#include "demos/text/complaints.h"
#include "demos/text/nearest.h"

namespace demos {
namespace {

constexpr std::size_t kLongestName = 32;
constexpr const char* kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789";
constexpr const char* kTurnNames[] = {"i", "j", "k", "ni", "nj", "nk", "n"};
constexpr const char* kFunctions[] = {"sin",   "cos",   "tan", "asin", "acos", "atan",
                                      "atan2", "sqrt",  "abs", "min",  "max",  "floor",
                                      "ceil",  "round", "mod", "hash"};
struct Constant {
    const char* name;
    double value;
};
constexpr Constant kConstants[] = {
    {"pi", 3.14159265358979323846}, {"tau", 6.28318530717958647693}, {"e", 2.71828182845904523536}};

bool isFunction(std::string_view name) {
    return std::find(std::begin(kFunctions), std::end(kFunctions), name) != std::end(kFunctions);
}

/// The index in i j k ni nj nk n; -1: none of them.
int turnNumber(std::string_view name) {
    const auto found = std::find(std::begin(kTurnNames), std::end(kTurnNames), name);
    return found == std::end(kTurnNames) ? -1 : static_cast<int>(found - std::begin(kTurnNames));
}

/// How many [[repeat]]s have to be around the name.
int depthOf(int turn) { return turn == 2 * kDeepestRepeat ? 1 : turn % kDeepestRepeat + 1; }

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

std::size_t wordLength(std::string_view text) {
    std::size_t length = 0;
    while (length < text.size() && (isLetter(text[length]) || isDigit(text[length]))) ++length;
    return length;
}

/// The length of the number at the front of the text; 0: none.
std::size_t numberLength(const char* begin, const char* end, double& value) {
    if (begin == end || !(isDigit(*begin) || *begin == '.')) return 0;
    const std::from_chars_result read = std::from_chars(begin, end, value);
    return read.ec == std::errc() ? static_cast<std::size_t>(read.ptr - begin) : 0;
}

int numberAt(const char* text, int* at, double* value) {
    const std::string_view rest(text);
    const std::size_t length = numberLength(text, text + rest.size(), *value);
    *at += static_cast<int>(length);
    return length > 0 ? 1 : 0;
}

/// Whether a number stands before this place and a word or a sign of a unit at it: "7800 kg", "20 %".
bool isUnit(std::string_view text, std::size_t at) {
    if (at >= text.size()) return false;
    const bool unit = isLetter(text[at]) || text[at] == '%' || (text[at] & 0x80) != 0;
    while (at > 0 && text[at - 1] == ' ') --at;
    std::size_t begin = at;
    while (begin > 0 && (isLetter(text[begin - 1]) || isDigit(text[begin - 1]))) --begin;
    const bool number = begin < at ? isDigit(text[begin]) : at > 0 && text[at - 1] == '.';
    return unit && number;
}

/// Whether it is a whole number above 2^53, the largest to which each has a double of its own.
bool isInexact(std::string_view number) {
    constexpr std::uint64_t kExact = std::uint64_t{1} << 53;
    std::uint64_t whole = 0;
    const auto read = std::from_chars(number.data(), number.data() + number.size(), whole);
    return read.ptr == number.data() + number.size() && (read.ec != std::errc{} || whole > kExact);
}

std::string atCharacter(std::size_t at) { return " at character " + std::to_string(at + 1); }

std::string sentenceOf(const mu::ParserError& error) {
    const std::string token = error.GetToken();
    switch (error.GetCode()) {
        case mu::ecUNEXPECTED_EOF:
            return "it ends too early";
        case mu::ecMISSING_PARENS:
            return "a '(' without its ')'";
        case mu::ecTOO_MANY_PARAMS:
            return "more arguments than " + token + "() takes";
        case mu::ecTOO_FEW_PARAMS:
            return "fewer arguments than " + token + "() takes";
        default:
            break;
    }
    const std::string what = token.empty() ? "a mistake" : "'" + token + "' is not expected";
    const int at = error.GetPos();
    return at < 0 ? what : what + atCharacter(static_cast<std::size_t>(at));
}

}  // namespace

/// muparser without its built-in functions: no assignment, no strings, no pow.
class Expressions::Parser : public mu::ParserBase {
public:
    Parser() {
        EnableBuiltInOprt(false);
        EnableOptimizer(false);
        InitCharSets();
        InitFun();
        InitConst();
        InitOprt();
        AddValIdent(numberAt);
    }

private:
    void InitCharSets() override {
        DefineNameChars(kLetters);
        DefineOprtChars("+-*/^");
        DefineInfixOprtChars("+-");
    }

    void InitFun() override {
        using namespace expressions;
        DefineFun("sin", sine);
        DefineFun("cos", cosine);
        DefineFun("tan", tangent);
        DefineFun("asin", arcsine);
        DefineFun("acos", arccosine);
        DefineFun("atan", expressions::arctangent);
        DefineFun("atan2", arctangent2);
        DefineFun("sqrt", squareRoot);
        DefineFun("abs", magnitude);
        DefineFun("floor", below);
        DefineFun("ceil", above);
        DefineFun("round", nearestWhole);
        DefineFun("mod", modulo);
        DefineFun("min", smallest);
        DefineFun("max", largest);
        DefineFun("hash", hashed);
    }

    void InitConst() override {
        for (const Constant& constant : kConstants) DefineConst(constant.name, constant.value);
    }

    void InitOprt() override {
        using namespace expressions;
        DefineInfixOprt("-", minus);
        DefineInfixOprt("+", plus);
        DefineOprt("+", add, mu::prADD_SUB);
        DefineOprt("-", subtract, mu::prADD_SUB);
        DefineOprt("*", multiply, mu::prMUL_DIV);
        DefineOprt("/", divide, mu::prMUL_DIV);
        DefineOprt("^", power, mu::prPOW, mu::oaRIGHT);
    }
};

Expressions::Expressions() : parser_(std::make_unique<Parser>()) {
    for (std::size_t t = 0; t < std::size(kTurnNames); ++t)
        parser_->DefineVar(kTurnNames[t], &turns_[t]);
}

Expressions::~Expressions() = default;

std::string Expressions::whyNoName(std::string_view name) const {
    const bool good = !name.empty() && name.size() <= kLongestName && name[0] >= 'a' &&
                      name[0] <= 'z' && std::none_of(name.begin(), name.end(), [](char c) {
                          return !(c >= 'a' && c <= 'z') && !isDigit(c) && c != '_';
                      });
    if (!good) return "it should be 1 to 32 of a-z 0-9 _, a letter first";
    for (const Constant& constant : kConstants)
        if (name == constant.name) return "this is a constant of expressions; choose another name";
    if (isFunction(name)) return "this is a function of expressions; choose another name";
    if (turnNumber(name) >= 0) return "this is a variable of [[repeat]]; choose another name";
    return "";
}

void Expressions::define(const std::string& name, double value) {
    double& place = values_[name];
    place = value;
    parser_->DefineVar(name, &place);
}

std::vector<std::string> Expressions::names(const Turns& turns) const {
    std::vector<std::string> list;
    for (const auto& [name, value] : values_) list.push_back(name);
    for (int t = 0; t <= 2 * kDeepestRepeat; ++t)
        if (depthOf(t) <= turns.depth) list.emplace_back(kTurnNames[t]);
    for (const Constant& constant : kConstants) list.emplace_back(constant.name);
    return list;
}

std::string Expressions::checkName(std::string_view name, bool called, const Turns& turns) const {
    if (called) {
        if (isFunction(name)) return "";
        return "there is no function '" + std::string(name) + "'" +
               suggestion(name, {std::begin(kFunctions), std::end(kFunctions)});
    }
    if (isFunction(name))
        return std::string(name) + " is a function; write " + std::string(name) + "(x)";
    const int turn = turnNumber(name);
    if (turn >= 0 && depthOf(turn) <= turns.depth) return "";
    if (turn >= 0)
        return std::string(name) + " is not defined at [[repeat]] depth " +
               std::to_string(turns.depth) + "; it needs depth " + std::to_string(depthOf(turn));
    for (const Constant& constant : kConstants)
        if (name == constant.name) return "";
    if (values_.find(name) != values_.end()) return "";
    if (later_.contains(name))
        return "there is no value '" + std::string(name) +
               "' yet; define it earlier in [values]";
    return "there is no value '" + std::string(name) + "'" + suggestion(name, names(turns));
}

std::string Expressions::checkWords(std::string_view text, const Turns& turns,
                                    std::size_t& at) const {
    while (at < text.size()) {
        const std::string_view rest = text.substr(at);
        double number = 0.0;
        if (isDigit(rest[0]) || rest[0] == '.') {
            const std::size_t length = numberLength(rest.data(), rest.data() + rest.size(), number);
            if (length == 0) return "a number that cannot be read" + atCharacter(at);
            if (isInexact(rest.substr(0, length)))
                return shown(rest.substr(0, length)) + " is not exact; whole numbers should be up to "
                       "9007199254740992" + atCharacter(at);
            at += length;
        } else if (isLetter(rest[0])) {
            const std::size_t length = wordLength(rest);
            const bool called = rest.substr(length).starts_with('(');
            const std::string wrong = checkName(rest.substr(0, length), called, turns);
            if (!wrong.empty()) return wrong;
            at += length;
        } else if (std::string_view("+-*/^(), ").find(rest[0]) == std::string_view::npos) {
            return "'" + std::string(1, rest[0]) + "' is not expected" + atCharacter(at) +
                   "; an expression is made of numbers, names, + - * / ^ ( ) and ,";
        } else {
            ++at;
        }
    }
    return "";
}

Evaluated Expressions::computed(const std::string& text) {
    try {
        parser_->SetExpr(text);
        const double value = parser_->Eval();
        if (parser_->GetNumResults() != 1) return {{}, "two numbers; it should be one"};
        if (std::isfinite(value)) return {value + 0.0, ""};  // -0 becomes +0
        return {{}, "it is too large for a number"};
    } catch (const Undefined& undefined) {
        return {{}, undefined.what()};
    } catch (const mu::ParserError& error) {
        return {{}, sentenceOf(error)};
    }
}

Evaluated Expressions::evaluate(std::string_view text, const Turns& turns) {
    if (++evaluated_ > kMostEvaluated) return {{}, "more than 300000 expressions in a scene"};
    if (text.size() > kLongestExpression)
        return {{}, std::to_string(text.size()) + " characters; it should be at most 200"};
    if (text.find_first_not_of(' ') == std::string_view::npos) return {{}, "an empty expression"};
    std::size_t at = 0;
    const std::string wrong = checkWords(text, turns, at);
    if (!wrong.empty()) return {{}, wrong, isUnit(text, at)};
    for (int t = 0; t < kDeepestRepeat; ++t) {
        turns_[t] = turns.index[t];
        turns_[kDeepestRepeat + t] = turns.count[t];
    }
    turns_[2 * kDeepestRepeat] = turns.depth > 0 ? turns.count[turns.depth - 1] : 0.0;
    return computed(std::string(text));
}

}  // namespace demos
