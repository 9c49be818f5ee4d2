/// Strict access to one table of a scene: what is not asked for is an unknown key, and every wrong
/// value is a complaint that says what would be right. Values that were wrong are as if not given.
#pragma once
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "demos/scene/description.h"
#include "demos/scene/scope.h"
#include "demos/scene/toml_value.h"

namespace demos {

/// Wherever a number is asked for, a text is an expression.
class Keys {
public:
    /// `where`: what the table is called in messages: "[world]", "a [[body]]". `scope` is kept.
    Keys(const Value& table, std::string where, Complaints& complaints, const Scope& scope);

    /// The keys of a table inside this one, or of a list inside this one.
    Keys inner(const Value& table, std::string where) const;

    /// Any value; null when not given.
    const Value* any(std::string_view key);
    bool has(std::string_view key) const { return table_.find(key) != nullptr; }
    /// Whether `key` is not given, but one that differs by two letters at most.
    bool isMisspelt(std::string_view key) const;
    Place placeOf(std::string_view key) const;
    Place place() const { return table_.place; }

    std::optional<double> number(std::string_view key, Range range);
    std::optional<int> whole(std::string_view key, Range range);
    /// The same for what an int cannot hold; at most 2^53 either way.
    std::optional<std::int64_t> large(std::string_view key, Range range);
    std::optional<bool> truth(std::string_view key);
    std::optional<std::string> text(std::string_view key);
    std::optional<Vec3> vector(std::string_view key, Range range);
    std::optional<std::vector<std::string>> texts(std::string_view key);
    std::optional<std::vector<double>> numbers(std::string_view key, Range range);
    /// [[x, y, z], ...]
    std::optional<std::vector<Vec3>> vectors(std::string_view key, Range range);
    /// One of the words; `later`: words of the format that this version lacks.
    std::optional<std::string> word(std::string_view key, const std::vector<std::string>& words,
                                    const std::vector<std::string>& later = {});
    /// 0xRRGGBB of "#rrggbb".
    std::optional<unsigned> color(std::string_view key);
    /// The tables of [[key]], or the table that is not in a list.
    std::vector<const Value*> tables(std::string_view key);

    /// All keys that are given, whatever they are called; each of them is a number.
    const std::vector<Key>& others(Range range);

    /// Keys of the format that this version lacks.
    void later(std::initializer_list<std::string_view> keys);
    /// Complains of the keys that nobody asked for.
    void done();

    void complain(std::string_view key, const std::string& what);
    /// At the value, or at this item of a list; at the key where it has none.
    void complainOf(std::string_view key, const std::string& what,
                    std::size_t item = static_cast<std::size_t>(-1));

private:
    const Value* ask(std::string_view key, const Form& form);
    /// TomlPosition, or computed; without a complaint nothing only where it is no text.
    std::optional<double> numberIn(const Value& value, std::string_view key, bool& told);
    std::optional<double> checked(const Value& value, std::string_view key, Range range);
    std::optional<Vec3> checkedVector(const Value& value, std::string_view key, Range range);
    void wrong(const Value& value, std::string_view key, const std::string& right,
               std::optional<double> computed = {});

    const Value& table_;  // where it is none, it has no keys
    std::string where_;
    Complaints& complaints_;
    const Scope* scope_;
    std::vector<std::string_view> known_, later_;
    bool takesOthers_ = false;
};

/// What is not given leaves `to` as it is.
template <class To, class From>
void set(To& to, const std::optional<From>& from) {
    if (from) to = *from;
}

/// "a, b or c"
std::string anyOf(const std::vector<std::string>& words);

}  // namespace demos
