/// Strict access to one table of a scene. A key that the reader never asks for is reported as
/// unknown. Every wrong value is reported with what would be right, and then treated as missing.
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

/// Where a number is expected, a text is evaluated as an expression.
class Keys {
public:
    /// `where`: the table's name in messages: "[world]", "a [[body]]". `scope` has to outlive this.
    Keys(const Value& table, std::string where, Complaints& complaints, const Scope& scope);

    /// The keys of a table that this one holds, directly or in a list.
    Keys inner(const Value& table, std::string where) const;

    /// The value of any kind; null when missing.
    const Value* any(std::string_view key);
    bool has(std::string_view key) const { return table_.find(key) != nullptr; }
    /// Whether `key` is missing, but a key at most two edits away is given.
    bool isMisspelt(std::string_view key) const;
    Place placeOf(std::string_view key) const;
    Place place() const { return table_.place; }
    /// Of the whole scene so far.
    int complaintCount() const { return complaints_.count(); }

    std::optional<double> number(std::string_view key, Range range);
    std::optional<int> whole(std::string_view key, Range range);
    /// The same for numbers beyond int; from -2^53 to 2^53.
    std::optional<std::int64_t> large(std::string_view key, Range range);
    std::optional<bool> truth(std::string_view key);
    std::optional<std::string> text(std::string_view key);
    std::optional<Vec3> vector(std::string_view key, Range range);
    std::optional<std::vector<std::string>> texts(std::string_view key);
    std::optional<std::vector<double>> numbers(std::string_view key, Range range);
    /// [[x, y, z], ...]
    std::optional<std::vector<Vec3>> vectors(std::string_view key, Range range);
    /// One of `words`; `later`: words of the format that this version does not support yet.
    std::optional<std::string> word(std::string_view key, const std::vector<std::string>& words,
                                    const std::vector<std::string>& later = {});
    /// 0xRRGGBB of "#rrggbb".
    std::optional<unsigned> color(std::string_view key);
    /// The tables of [[key]], or a single table [key].
    std::vector<const Value*> tables(std::string_view key);

    /// All keys of the table, whatever their names; each holds a number.
    const std::vector<Key>& others(Range range);

    /// Keys of the format that this version does not support yet.
    void later(std::initializer_list<std::string_view> keys);
    /// Reports the keys that nobody asked for.
    void done();

    void complain(std::string_view key, const std::string& what);
    /// At the value, or at this item of a list; at the key if there is no value.
    void complainOf(std::string_view key, const std::string& what,
                    std::size_t item = static_cast<std::size_t>(-1));

private:
    const Value* ask(std::string_view key, const Form& form);
    /// What an unknown key may have meant, as the end of a sentence.
    std::string meant(const std::string& key) const;
    /// The number, or the result of its expression. `reported`: an error was reported here.
    std::optional<double> numberIn(const Value& value, std::string_view key, const Range& range,
                                   bool& reported);
    std::optional<double> checked(const Value& value, std::string_view key, Range range);
    std::optional<Vec3> checkedVector(const Value& value, std::string_view key, Range range);
    void wrong(const Value& value, std::string_view key, const std::string& right,
               std::optional<double> computed = {});

    const Value& table_;  // may be of another kind, and then has no keys
    std::string where_;
    Complaints& complaints_;
    const Scope* scope_;
    std::vector<std::string_view> known_, later_;
    bool takesOthers_ = false;
};

/// A missing value leaves `to` unchanged.
template <class To, class From>
void set(To& to, const std::optional<From>& from) {
    if (from) to = *from;
}

/// "a, b or c"
std::string anyOf(const std::vector<std::string>& words);

}  // namespace demos
