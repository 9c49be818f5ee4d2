#include "demos/scene/overrides.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "demos/text/nearest.h"

namespace demos {
namespace {

constexpr std::size_t kLongestKeyPath = 16;

std::vector<std::string> parts(std::string_view path) {
    std::vector<std::string> list(1);
    bool quoted = false;
    for (const char c : path) {
        if (c == '"')
            quoted = !quoted;
        else if (c == '.' && !quoted)
            list.emplace_back();
        else if (c != ' ')
            list.back() += c;
    }
    return list;
}

bool isCalled(const Value& table, const std::string& name) {
    const Value* own = table.find("name");
    return own && own->text == name;
}

/// Whether the item, or what it repeats, has this name.
bool holdsCalled(const Value& item, const std::string& name) {
    if (isCalled(item, name)) return true;
    for (const char* key : {"body", "joint", "force"})
        if (const Value* inner = item.find(key)) {
            if (isCalled(*inner, name)) return true;
            for (const Value& one : inner->items)
                if (isCalled(one, name)) return true;
        }
    return false;
}

std::optional<std::size_t> numberOf(const std::string& part) {
    std::size_t number = 0;
    const char* end = part.data() + part.size();
    const std::from_chars_result read = std::from_chars(part.data(), end, number);
    if (read.ec == std::errc() && read.ptr == end) return number;
    return std::nullopt;
}

/// The item of a list with this number or name; null if there is none.
Value* listItem(Value& list, const std::string& part) {
    if (const std::optional<std::size_t> number = numberOf(part))
        return *number < list.items.size() ? &list.items[*number] : nullptr;
    for (Value& item : list.items)
        if (holdsCalled(item, part)) return &item;
    return nullptr;
}

/// Why --set cannot change this; empty if it can.
std::string whyNot(const std::vector<std::string>& path, const Value& document) {
    if (path[0] == "include") return "files are included before --set; name them in the scene";
    if (path[0] != "values" || path.size() < 2) return "";
    const Value* values = document.find("values");
    if (values && values->find(path[1])) return "";
    std::vector<std::string> names;
    if (values)
        for (const Key& key : values->keys) names.push_back(key.name);
    return "the scene has no value '" + shown(path[1]) + "'" + suggestion(path[1], names);
}

Value* memberOf(Value& table, const std::string& part, Place place) {
    if (Value* member = table.find(part)) return member;
    Value member;
    member.place = place;
    table.keys.push_back({part, place});
    table.items.push_back(std::move(member));
    return &table.items.back();
}

/// The value at a path and, in a table, its key.
struct Setting {
    Value* value = nullptr;
    Key* key = nullptr;
};

/// Missing tables are created, missing lists and items are not. If the path leads nowhere, reports
/// an error and gives no value.
Setting settingAt(const std::vector<std::string>& path, Place place, Value& document,
                  Complaints& complaints) {
    Setting at{&document, nullptr};
    for (auto part = path.begin(); part != path.end(); ++part) {
        Value& around = *at.value;
        at = {};
        auto missing = part;
        if (around.kind == Value::Kind::array) {
            at.value = listItem(around, *part);
        } else if (around.kind == Value::Kind::table) {
            const bool known = around.find(*part) != nullptr;
            if (!known) missing = std::find_if(part, path.end(), numberOf);
            if (known || missing == path.end()) {
                at.value = memberOf(around, *part, place);
                at.key = &around.keys[static_cast<std::size_t>(at.value - around.items.data())];
            }
        }
        if (at.value) continue;
        complaints.add(place, "there is no '" + shown(*missing) +
                                  "' in this scene; a list takes a "
                                  "number or the name of one of its tables");
        return {};
    }
    return at;
}

void apply(const std::string& text, Place place, Value& document, Complaints& complaints) {
    const std::size_t equals = text.find('=');
    const std::vector<std::string> path = parts(std::string_view(text).substr(0, equals));
    bool good = equals != std::string::npos && path.size() <= kLongestKeyPath;
    for (const std::string& part : path) good = good && !part.empty();
    if (!good) {
        complaints.add(place, "should be KEY=VALUE, like world.hz=240");
        return;
    }
    if (const std::string wrong = whyNot(path, document); !wrong.empty()) {
        complaints.add(place, wrong);
        return;
    }
    const Setting setting = settingAt(path, place, document, complaints);
    if (!setting.value) return;
    *setting.value = parseTomlValue(std::string_view(text).substr(equals + 1), place);
    if (setting.key) setting.key->place = place;
}

}  // namespace

void applyOverrides(const std::vector<std::string>& overrides, Value& document,
                    Complaints& complaints) {
    for (std::size_t i = 0; i < overrides.size(); ++i)
        apply(overrides[i], {0, static_cast<int>(i) + 1}, document, complaints);
}

}  // namespace demos
