/// A TOML document as plain data, each value with its place. (Only toml_value.cpp uses toml++.)
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "demos/text/complaints.h"

namespace demos {

struct Key {
    std::string name;
    Place place;
};

struct Value {
    enum class Kind { table, array, text, integer, real, boolean, date };

    Kind kind = Kind::table;
    Place place;
    std::string text;
    double real = 0.0;  // also set for an integer
    std::int64_t integer = 0;
    bool boolean = false;
    std::vector<Value> items;  // of an array; of a table: in the order of `keys`
    std::vector<Key> keys;     // of a table, in the order of the file

    /// The member of a table, or null.
    const Value* find(std::string_view key) const;
    Value* find(std::string_view key);
    bool isNumber() const { return kind == Kind::integer || kind == Kind::real; }
};

/// For messages: `text "60"`, `the number 3.5`, `a table` ...
std::string describe(const Value& value);

/// An empty table, with an error, if the text is not TOML or exceeds the limits of a scene.
Value parseToml(std::string_view text, Complaints& complaints);

/// The right side of the '=' in --set: a TOML value, or else the text itself.
Value parseTomlValue(std::string_view text, Place place);

}  // namespace demos
