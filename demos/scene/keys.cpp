#include "demos/scene/keys.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "demos/scene/schema.h"
#include "demos/text/nearest.h"
#include "demos/text/synonyms.h"

namespace demos {
namespace {

std::string rangeText(const Range& range, const char* kind) {
    return std::string(kind) + " from " + numberText(range.low) + " to " + numberText(range.high) +
           (*range.unit ? std::string(" ") + range.unit : "");
}

std::string wholeText(const Range& range) {
    return "a whole number from " + std::to_string(static_cast<std::int64_t>(range.low)) + " to " +
           std::to_string(static_cast<std::int64_t>(range.high)) +
           (*range.unit ? std::string(" ") + range.unit : "");
}

bool holds(const std::vector<std::string_view>& list, std::string_view name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

/// [[world]] instead of [world].
bool isDoubled(const Value& table, const std::string& where) {
    return table.kind == Value::Kind::array && where.starts_with('[');
}

std::vector<std::string> namesOf(const AskedTable& table) {
    std::vector<std::string> names;
    for (const AskedKey& key : table.keys) names.push_back(key.name);
    return names;
}

/// The tables of the format that have such a key, or one of the same meaning, if they are few: "; it
/// is a key of a [[material]]".
std::string otherTables(const std::string& where, const std::string& key, const Scope& scope) {
    constexpr std::size_t kMost = 3;
    if (scope.catalog) return {};  // the format itself is being read
    const Catalog& format = formatCatalog();
    std::vector<std::string> same, like;
    bool ofFormat = false;
    for (const AskedTable& table : format.tables()) {
        const std::string meant = sameMeaning(key, namesOf(table));
        if (table.name == where && meant == key) return {};  // for other kinds of this table
        ofFormat = ofFormat || table.name == where;
        if (meant == key)
            same.push_back(table.name);
        else if (!meant.empty() && table.name != where)
            like.push_back("'" + meant + "' of " + table.name);
    }
    if (!ofFormat) return {};
    if (!same.empty()) return same.size() > kMost ? "" : "; it is a key of " + anyOf(same);
    return like.empty() || like.size() > kMost ? "" : "; did you mean " + anyOf(like) + "?";
}

}  // namespace

std::string anyOf(const std::vector<std::string>& words) {
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i)
        list += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
    return list;
}

Keys::Keys(const Value& table, std::string where, Complaints& complaints, const Scope& scope)
    : table_(table), where_(std::move(where)), complaints_(complaints), scope_(&scope) {
    if (table.kind != Value::Kind::table)
        complaints_.add(table.place, where_ + " is " + describe(table) + "; it should be a table" +
                                         (isDoubled(table, where_) ? ", in single brackets" : ""));
}

Keys Keys::inner(const Value& table, std::string where) const {
    if (scope_->catalog)
        for (std::size_t i = 0; i < table_.keys.size(); ++i) {
            const std::vector<Value>& list = table_.items[i].items;
            const bool isItem = std::any_of(list.begin(), list.end(),
                                            [&](const Value& item) { return &item == &table; });
            if (&table != &table_.items[i] && !isItem) continue;
            const auto kind = isItem ? Form::Kind::tables : Form::Kind::table;
            scope_->catalog->ask(where_, table_.keys[i].name, {kind, {}, {}, where}, true);
        }
    return {table, std::move(where), complaints_, *scope_};
}

const Value* Keys::any(std::string_view key) {
    if (scope_->catalog && !takesOthers_) scope_->catalog->ask(where_, key, has(key));
    if (!holds(known_, key)) known_.push_back(key);
    return table_.find(key);
}

const Value* Keys::ask(std::string_view key, const Form& form) {
    if (scope_->catalog && !takesOthers_) scope_->catalog->ask(where_, key, form, has(key));
    if (!holds(known_, key)) known_.push_back(key);
    return table_.find(key);
}

const std::vector<Key>& Keys::others(Range range) {
    takesOthers_ = true;
    if (scope_->catalog) scope_->catalog->askOthers(where_, {Form::Kind::number, range});
    return table_.keys;
}

Place Keys::placeOf(std::string_view key) const {
    for (const Key& k : table_.keys)
        if (k.name == key) return k.place;
    return table_.place;
}

void Keys::complain(std::string_view key, const std::string& what) {
    const bool reported = table_.kind != Value::Kind::table;  // reported already: it is not a table
    if (!reported) complaints_.add(placeOf(key), what);
}

void Keys::complainOf(std::string_view key, const std::string& what, std::size_t item) {
    const Value* value = table_.find(key);
    if (!value) return complain(key, what);
    const bool listed = value->kind == Value::Kind::array && item < value->items.size();
    complaints_.add(listed ? value->items[item].place : value->place, what);
}

void Keys::wrong(const Value& value, std::string_view key, const std::string& right,
                 std::optional<double> computed) {
    const std::string result = computed && !value.isNumber() ? " = " + numberText(*computed) : "";
    complaints_.add(value.place, std::string(key) + " is " + describe(value) + result +
                                     "; it should be " + right);
}

std::optional<double> Keys::numberIn(const Value& value, std::string_view key, const Range& range,
                                     bool& reported) {
    if (value.isNumber()) return value.real;
    if (value.kind != Value::Kind::text) return std::nullopt;
    const Evaluated result = scope_->expressions->evaluate(value.text, scope_->turns);
    reported = !result.value;
    if (result.unit)
        wrong(value, key,
              std::string("the number alone, in ") + (*range.unit ? range.unit : "SI units"));
    else if (reported)
        complaints_.add(value.place,
                        std::string(key) + " is " + describe(value) + ": " + result.wrong);
    return result.value;
}

std::optional<double> Keys::checked(const Value& value, std::string_view key, Range range) {
    bool reported = false;
    const std::optional<double> x = numberIn(value, key, range, reported);
    if (x && std::isfinite(*x) && *x >= range.low && *x <= range.high)
        return *x + 0.0;  // -0 becomes +0
    if (!reported) wrong(value, key, rangeText(range, "a number"), x);
    return std::nullopt;
}

std::optional<double> Keys::number(std::string_view key, Range range) {
    const Value* value = ask(key, {Form::Kind::number, range});
    return value ? checked(*value, key, range) : std::nullopt;
}

std::optional<std::int64_t> Keys::large(std::string_view key, Range range) {
    const Value* value = ask(key, {Form::Kind::whole, range});
    if (!value) return std::nullopt;
    bool reported = false;
    const std::optional<double> x = numberIn(*value, key, range, reported);
    // 60.0 in the file does not count as whole, but the result of an expression is always a double.
    const bool whole = value->kind != Value::Kind::real && x && *x == std::floor(*x);
    if (whole && *x >= range.low && *x <= range.high) return static_cast<std::int64_t>(*x);
    if (!reported) wrong(*value, key, wholeText(range), x);
    return std::nullopt;
}

std::optional<int> Keys::whole(std::string_view key, Range range) {
    const std::optional<std::int64_t> x = large(key, range);
    return x ? std::optional(static_cast<int>(*x)) : std::nullopt;
}

std::optional<bool> Keys::truth(std::string_view key) {
    const Value* value = ask(key, {Form::Kind::truth, {}});
    if (!value) return std::nullopt;
    if (value->kind == Value::Kind::boolean) return value->boolean;
    wrong(*value, key, "true or false");
    return std::nullopt;
}

std::optional<std::string> Keys::text(std::string_view key) {
    const Value* value = ask(key, {Form::Kind::text, {}});
    if (!value) return std::nullopt;
    if (value->kind == Value::Kind::text) return value->text;
    wrong(*value, key, "a text in quotes");
    return std::nullopt;
}

std::optional<Vec3> Keys::checkedVector(const Value& value, std::string_view key, Range range) {
    if (value.kind != Value::Kind::array || value.items.size() != 3) {
        wrong(value, key, "three numbers [x, y, z]");
        return std::nullopt;
    }
    Vec3 v;
    bool good = true;
    for (int i = 0; i < 3; ++i) {
        const std::optional<double> x =
            checked(value.items[static_cast<std::size_t>(i)], key, range);
        good = good && x.has_value();
        v[i] = x.value_or(0.0);
    }
    return good ? std::optional<Vec3>(v) : std::nullopt;
}

std::optional<Vec3> Keys::vector(std::string_view key, Range range) {
    const Value* value = ask(key, {Form::Kind::vector, range});
    return value ? checkedVector(*value, key, range) : std::nullopt;
}

std::optional<std::vector<Vec3>> Keys::vectors(std::string_view key, Range range) {
    const Value* value = ask(key, {Form::Kind::vectors, range});
    if (!value) return std::nullopt;
    if (value->kind != Value::Kind::array) {
        wrong(*value, key, "a list of points [[x, y, z], ...]");
        return std::nullopt;
    }
    std::vector<Vec3> points;
    for (const Value& item : value->items) {
        const std::optional<Vec3> point = checkedVector(item, key, range);
        if (!point) return std::nullopt;
        points.push_back(*point);
    }
    return points;
}

std::optional<std::vector<std::string>> Keys::texts(std::string_view key) {
    const Value* value = ask(key, {Form::Kind::texts, {}});
    if (!value) return std::nullopt;
    if (value->kind == Value::Kind::text) return std::vector<std::string>{value->text};
    constexpr std::size_t kMostTexts = 1000;
    if (value->items.size() > kMostTexts) {
        complaints_.add(value->place, std::string(key) + " is " + describe(*value) +
                                          " texts; it should have at most " +
                                          std::to_string(kMostTexts));
        return std::nullopt;
    }
    std::vector<std::string> list;
    const Value* bad = value->kind == Value::Kind::array ? nullptr : value;
    for (const Value& item : value->items) {
        if (!bad && item.kind != Value::Kind::text) bad = &item;
        list.push_back(item.text);
    }
    if (!bad) return list;
    complaints_.add(bad->place, std::string(key) + (bad == value ? " is " : " holds ") +
                                    describe(*bad) +
                                    "; it should be a list of texts, like [\"box0\", \"box1\"]");
    return std::nullopt;
}

std::optional<std::vector<double>> Keys::numbers(std::string_view key, Range range) {
    const Value* value = ask(key, {Form::Kind::numbers, range});
    if (!value) return std::nullopt;
    if (value->kind != Value::Kind::array) {
        wrong(*value, key, "a list of numbers");
        return std::nullopt;
    }
    std::vector<double> list;
    for (const Value& item : value->items)
        if (const std::optional<double> x = checked(item, key, range)) list.push_back(*x);
    return list.size() == value->items.size() ? std::optional(list) : std::nullopt;
}

std::optional<std::string> Keys::word(std::string_view key, const std::vector<std::string>& words,
                                      const std::vector<std::string>& later) {
    const Value* value = ask(key, {Form::Kind::word, {}, words});
    if (!value) return std::nullopt;
    if (value->kind == Value::Kind::text) {
        if (std::find(words.begin(), words.end(), value->text) != words.end()) return value->text;
        if (std::find(later.begin(), later.end(), value->text) != later.end()) {
            complaints_.add(value->place, std::string(key) + " \"" + value->text +
                                              "\" is not supported yet; use " + anyOf(words));
            return std::nullopt;
        }
    }
    const std::string close =
        value->kind == Value::Kind::text ? nearest(value->text, words) : std::string();
    wrong(*value, key, anyOf(words) + (close.empty() ? "" : "; did you mean '" + close + "'?"));
    return std::nullopt;
}

std::optional<unsigned> Keys::color(std::string_view key) {
    const Value* value = ask(key, {Form::Kind::color, {}});
    if (!value) return std::nullopt;
    const std::string& text = value->text;
    if (value->kind == Value::Kind::text && text.size() == 7 && text[0] == '#' &&
        text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos)
        return static_cast<unsigned>(std::stoul(text.substr(1), nullptr, 16));
    wrong(*value, key, "like \"#c89b6c\": red, green and blue in hexadecimal");
    return std::nullopt;
}

std::vector<const Value*> Keys::tables(std::string_view key) {
    const Value* value = ask(key, {Form::Kind::tables, {}});
    if (!value) return {};
    if (value->kind == Value::Kind::table) return {value};
    std::vector<const Value*> list;
    for (const Value& item : value->items) list.push_back(&item);
    if (value->kind != Value::Kind::array)
        wrong(*value, key, "one or more tables [[" + std::string(key) + "]]");
    return list;
}

bool Keys::isMisspelt(std::string_view key) const {
    return !has(key) &&
           std::any_of(table_.keys.begin(), table_.keys.end(),
                       [key](const Key& given) { return editDistance(given.name, key, 3) <= 2; });
}

void Keys::later(std::initializer_list<std::string_view> keys) {
    later_.insert(later_.end(), keys.begin(), keys.end());
}

std::string Keys::meant(const std::string& key) const {
    const std::vector<std::string> known(known_.begin(), known_.end());
    if (nearest(key, known).empty())
        if (const std::string elsewhere = otherTables(where_, key, *scope_); !elsewhere.empty())
            return elsewhere;
    return suggestion(key, known);
}

void Keys::done() {
    constexpr int kMostSuggestions = 100;  // a file may consist of unknown keys only
    int unknown = 0;
    for (const Key& key : table_.keys) {
        if (holds(known_, key.name)) continue;
        if (holds(later_, key.name)) {
            complaints_.add(key.place, "'" + key.name + "' in " + where_ +
                                           " is not supported yet; leave it out");
            continue;
        }
        std::string what = "unknown key '" + shown(key.name) + "' in " + where_;
        if (++unknown <= kMostSuggestions) what += meant(key.name);
        complaints_.add(key.place, what);
    }
}

}  // namespace demos
