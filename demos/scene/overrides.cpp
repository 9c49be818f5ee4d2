#include "demos/scene/overrides.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

#include "demos/text/nearest.h"
#include "demos/text/plural.h"

namespace demos {
namespace {

constexpr std::size_t kLongestKeyPath = 16;

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

/// The names by which listItem() finds the items.
std::vector<std::string> namesIn(const Value& list) {
    std::vector<std::string> names;
    const auto add = [&](const Value& table) {
        if (const Value* own = table.find("name"); own && own->kind == Value::Kind::text)
            names.push_back(own->text);
    };
    for (const Value& item : list.items) {
        add(item);
        for (const char* key : {"body", "joint", "force"})
            if (const Value* inner = item.find(key)) {
                add(*inner);
                for (const Value& one : inner->items) add(one);
            }
    }
    return names;
}

/// Whether a [[repeat]] makes items whose names begin like this one: box3 of box{i}.
bool isRepeated(const Value& document, const std::string& name) {
    const Value* repeats = document.find("repeat");
    if (!repeats) return false;
    for (const std::string& pattern : namesIn(*repeats))
        if (const std::size_t brace = pattern.find('{');
            brace != 0 && brace != std::string::npos && name.starts_with(pattern.substr(0, brace)))
            return true;
    return false;
}

/// Why a list has no such item, with what would be right. `list`: its key.
std::string noItem(const Value& document, const std::string& list, const Value& items,
                   const std::string& part) {
    const std::string what = "there is no '" + shown(part) + "' in [[" + shown(list) + "]]";
    if (indexNumber(part))
        return what + "; it has " + plural(items.items.size(), "table") + ", counted from 0";
    const std::string stem = part.substr(0, part.find_last_not_of("0123456789") + 1);
    if (list != "repeat" && isRepeated(document, part) && !stem.empty())
        return what + "; what a [[repeat]] makes is reached like " + list + "." + stem + "[0]";
    const std::string meant = suggestion(part, namesIn(items));
    return what + (meant.empty() ? "; a list takes a number from 0" : meant);
}

/// The item of a list with this number or name; null if there is none.
Value* listItem(Value& list, const std::string& part) {
    if (const std::optional<std::size_t> number = indexNumber(part))
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
        if (around.kind == Value::Kind::array) {
            at.value = listItem(around, *part);
            if (at.value) continue;
            const std::string& list = part == path.begin() ? *part : *(part - 1);
            complaints.add(place, noItem(document, list, around, *part));
            return {};
        }
        auto missing = part;
        if (around.kind == Value::Kind::table) {
            const bool known = around.find(*part) != nullptr;
            if (!known) missing = std::find_if(part, path.end(), indexNumber);
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

void put(const std::string& value, const std::vector<std::string>& path, Place place,
         Value& document, Complaints& complaints) {
    const Setting setting = settingAt(path, place, document, complaints);
    if (!setting.value) return;
    *setting.value = parseTomlValue(value, place);
    if (setting.key) setting.key->place = place;
}

/// body[3].mass -> body.3.mass
std::vector<std::string> withItemsApart(const std::vector<std::string>& path) {
    std::vector<std::string> apart;
    for (const std::string& part : path)
        if (const auto indexed = indexedPart(part))
            apart.insert(apart.end(), {indexed->name, std::to_string(indexed->index)});
        else
            apart.push_back(part);
    return apart;
}

/// body.box[3].mass
bool hasToWait(const std::vector<std::string>& path) {
    return (path[0] == "body" || path[0] == "joint" || path[0] == "force") && path.size() > 2 &&
           indexedPart(path[1]);
}

/// One of --set; those that have to wait are added to `later`.
void apply(const std::string& text, Place place, Value& document, std::vector<ItemOverride>& later,
           Complaints& complaints) {
    const std::size_t equals = text.find('=');
    const std::vector<std::string> path = keyParts(std::string_view(text).substr(0, equals));
    bool good = equals != std::string::npos && path.size() <= kLongestKeyPath;
    for (const std::string& part : path) good = good && !part.empty();
    if (!good) {
        complaints.add(place, "should be KEY=VALUE, like world.hz=240");
        return;
    }
    const std::string value = text.substr(equals + 1);
    if (hasToWait(path))
        later.push_back(
            {path[0], *indexedPart(path[1]), {path.begin() + 2, path.end()}, value, place});
    else if (const std::string wrong = whyNot(path, document); !wrong.empty())
        complaints.add(place, wrong);
    else
        put(value, withItemsApart(path), place, document, complaints);
}

/// The name of a body, joint or force; of a joint without one that of its bodies, "a-b".
std::string nameOfItem(const Instance& instance) {
    std::string ignored;
    const auto text = [&](const char* key) {
        const Value* value = instance.table->find(key);
        return value ? instance.named(value->text, ignored) : std::string();
    };
    const std::string name = text("name");
    return name.empty() && instance.table->find("a") ? text("a") + "-" + text("b") : name;
}

/// Whether the name begins with these whole words: box3 with box, boxing not.
bool beginsWith(const std::string& name, const std::string& words) {
    const auto isLetterAt = [&name](std::size_t i) {
        return i < name.size() && std::isalpha(static_cast<unsigned char>(name[i]));
    };
    const std::size_t size = words.size();
    return name.starts_with(words) && !(isLetterAt(size - 1) && isLetterAt(size));
}

/// Null, with an error, if there is none.
Instance* itemMeant(const ItemOverride& change, std::vector<Instance>& list,
                    Complaints& complaints) {
    const std::string& words = change.item.name;
    const std::string& kind = change.list;
    std::vector<std::string> names;
    std::size_t found = 0;
    for (Instance& instance : list) {
        names.push_back(nameOfItem(instance));
        if (!beginsWith(names.back(), words)) continue;
        if (found++ == change.item.index) return &instance;
    }
    if (found == 0)
        complaints.add(change.place, "no " + kind + " has a name that begins with '" +
                                         shown(words) + "'" + suggestion(words, names));
    else
        complaints.add(
            change.place,
            "the names of " +
                plural(found, kind.c_str(), kind == "body" ? "bodies" : (kind + "s").c_str()) +
                " begin with '" + shown(words) +
                "'; the index counts from 0 and should be at most " + std::to_string(found - 1));
    return nullptr;
}

}  // namespace

std::vector<ItemOverride> applyOverrides(const std::vector<std::string>& overrides, Value& document,
                                         Complaints& complaints) {
    std::vector<ItemOverride> later;
    for (std::size_t i = 0; i < overrides.size(); ++i)
        apply(overrides[i], {0, static_cast<int>(i) + 1}, document, later, complaints);
    return later;
}

void applyToItems(const std::vector<ItemOverride>& overrides, Instances& instances,
                  std::deque<Value>& own, Complaints& complaints) {
    for (const ItemOverride& change : overrides) {
        std::vector<Instance>& list = change.list == "body"    ? instances.bodies
                                      : change.list == "joint" ? instances.joints
                                                               : instances.forces;
        Instance* item = itemMeant(change, list, complaints);
        if (!item) continue;
        own.push_back(*item->table);
        put(change.value, change.path, change.place, own.back(), complaints);
        item->table = &own.back();
    }
}

}  // namespace demos
