#include "demos/scene/overrides.h"

#include <charconv>
#include <utility>

namespace demos {
namespace {

constexpr std::size_t kDeepest = 16;

std::vector<std::string> parts(std::string_view path) {
    std::vector<std::string> list(1);
    for (const char c : path) {
        if (c == '.')
            list.emplace_back();
        else if (c != ' ')
            list.back() += c;
    }
    return list;
}

/// Of a list: the item with this number, or this name; null when there is none.
Value* itemOf(Value& list, const std::string& part) {
    std::size_t number = 0;
    const char* end = part.data() + part.size();
    const std::from_chars_result read = std::from_chars(part.data(), end, number);
    if (read.ec == std::errc() && read.ptr == end)
        return number < list.items.size() ? &list.items[number] : nullptr;
    for (Value& item : list.items)
        if (const Value* name = item.find("name"); name && name->text == part) return &item;
    return nullptr;
}

Value* memberOf(Value& table, const std::string& part, Place place) {
    if (Value* member = table.find(part)) return member;
    Value member;
    member.place = place;
    table.keys.push_back({part, place});
    table.items.push_back(std::move(member));
    return &table.items.back();
}

void apply(const std::string& text, Place place, Value& document, Complaints& complaints) {
    const std::size_t equals = text.find('=');
    const std::vector<std::string> path = parts(std::string_view(text).substr(0, equals));
    bool good = equals != std::string::npos && path.size() <= kDeepest;
    for (const std::string& part : path) good = good && !part.empty();
    if (!good) {
        complaints.add(place, "should be KEY=VALUE, like world.hz=240");
        return;
    }
    Value* at = &document;
    Key* key = nullptr;
    for (const std::string& part : path) {
        if (at->kind == Value::Kind::array) {
            at = itemOf(*at, part);
            key = nullptr;
        } else if (at->kind == Value::Kind::table) {
            Value* parent = at;
            at = memberOf(*at, part, place);
            key = &parent->keys[static_cast<std::size_t>(at - parent->items.data())];
        } else {
            at = nullptr;
        }
        if (!at) {
            complaints.add(place, "there is no '" + part +
                                      "' in this scene; a list takes a "
                                      "number or the name of one of its tables");
            return;
        }
    }
    *at = parseTomlValue(std::string_view(text).substr(equals + 1), place);
    if (key) key->place = place;
}

}  // namespace

void applyOverrides(const std::vector<std::string>& overrides, Value& document,
                    Complaints& complaints) {
    for (std::size_t i = 0; i < overrides.size(); ++i)
        apply(overrides[i], {0, static_cast<int>(i) + 1}, document, complaints);
}

}  // namespace demos
