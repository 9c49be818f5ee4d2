#include "demos/scene/toml_value.h"

#include <cstdint>
#include <algorithm>
#include <tuple>
#include <utility>

#include <toml++/toml.h>

#include "demos/scene/toml_limits.h"
#include "demos/scene/toml_mend.h"

namespace demos {
namespace {

Place placeOf(const toml::source_region& source) {
    return {static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

Value convert(const toml::node& node, int depth, Complaints& complaints);

void convertTable(const toml::table& table, Value& value, int depth, Complaints& complaints) {
    struct Entry {
        Key key;
        const toml::node* node;
    };
    std::vector<Entry> entries;
    for (auto&& [key, node] : table)
        entries.push_back({{std::string(key.str()), placeOf(key.source())}, &node});
    // Back to the order of the file: toml++ sorts by name.
    std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return std::tie(a.key.place.line, a.key.place.column) <
               std::tie(b.key.place.line, b.key.place.column);
    });
    for (Entry& entry : entries) {
        value.keys.push_back(std::move(entry.key));
        value.items.push_back(convert(*entry.node, depth + 1, complaints));
    }
}

Value convert(const toml::node& node, int depth, Complaints& complaints) {
    Value value;
    value.place = placeOf(node.source());
    if (depth > kDeepestNesting) {
        complaints.add(value.place, "nested deeper than 32 tables and arrays");
        return value;
    }
    if (const toml::table* table = node.as_table()) {
        convertTable(*table, value, depth, complaints);
    } else if (const toml::array* array = node.as_array()) {
        value.kind = Value::Kind::array;
        for (const toml::node& item : *array)
            value.items.push_back(convert(item, depth + 1, complaints));
    } else if (const auto* text = node.as_string()) {
        value.kind = Value::Kind::text, value.text = text->get();
    } else if (const auto* integer = node.as_integer()) {
        value.kind = Value::Kind::integer, value.integer = integer->get();
        value.real = static_cast<double>(value.integer);
        constexpr std::int64_t kExact = std::int64_t{1} << 53;
        if (value.integer > kExact || value.integer < -kExact)
            complaints.add(value.place, std::to_string(value.integer) +
                                            " is not exact; whole numbers should be from "
                                            "-9007199254740992 to 9007199254740992");
    } else if (const auto* real = node.as_floating_point()) {
        value.kind = Value::Kind::real, value.real = real->get();
    } else if (const auto* boolean = node.as_boolean()) {
        value.kind = Value::Kind::boolean, value.boolean = boolean->get();
    } else {
        value.kind = Value::Kind::date;
    }
    return value;
}

void placeEverything(Value& value, Place place) {
    value.place = place;
    for (Key& key : value.keys) key.place = place;
    for (Value& item : value.items) placeEverything(item, place);
}

}  // namespace

const Value* Value::find(std::string_view key) const {
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (keys[i].name == key) return &items[i];
    return nullptr;
}

Value* Value::find(std::string_view key) {
    return const_cast<Value*>(std::as_const(*this).find(key));
}

std::string describe(const Value& value) {
    constexpr std::size_t kShown = 40;
    switch (value.kind) {
        case Value::Kind::table:
            return "a table";
        case Value::Kind::array:
            return "a list of " + std::to_string(value.items.size());
        case Value::Kind::text:
            return "the text \"" + value.text.substr(0, kShown) +
                   (value.text.size() > kShown ? "...\"" : "\"");
        case Value::Kind::integer:
            return std::to_string(value.integer);
        case Value::Kind::real:
            return numberText(value.real);
        case Value::Kind::boolean:
            return value.boolean ? "true" : "false";
        case Value::Kind::date:
            return "a date or time";
    }
    return "";
}

Value parseToml(std::string_view text, Complaints& complaints) {
    if (const std::optional<BeyondLimit> beyond = beyondLimits(text)) {
        complaints.add(beyond->place, beyond->what);
        return {};
    }
    try {
        const toml::table table = toml::parse(text);
        return convert(table, 0, complaints);
    } catch (const toml::parse_error& error) {
        Place place = placeOf(error.source());
        if (place.line < 1) place = {1, 1};
        const std::string_view what = error.description();
        complaints.add(place, "not TOML: " + std::string(what) + tomlMend(text, place.line, what));
    }
    return {};
}

Value parseTomlValue(std::string_view text, Place place) {
    Complaints ignored;
    const std::string line = "value = " + std::string(text);
    Value table = parseToml(line, ignored);
    Value value;
    if (ignored.count() == 0 && table.keys.size() == 1) {
        value = std::move(table.items[0]);
    } else {
        value.kind = Value::Kind::text;
        value.text = text;
    }
    placeEverything(value, place);
    return value;
}

}  // namespace demos
