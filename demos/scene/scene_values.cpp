#include "demos/scene/scene_values.h"

#include <algorithm>
#include <set>

#include "demos/scene/include.h"
#include "demos/scene/overrides.h"
#include "demos/text/hex_text.h"
#include "demos/text/text_hash.h"

namespace demos {
namespace {

constexpr std::size_t kLongestValue = 200;

std::string cut(const std::string& text) {
    if (text.size() <= kLongestValue) return printable(text);
    return printable(text.substr(0, 40)) + "... #" + hexText(hashOf(text));
}

bool isTables(const Value& value) {
    return value.kind == Value::Kind::array && !value.items.empty() &&
           value.items.front().kind == Value::Kind::table;
}

/// A number, a text, a list of them, ...
std::string textOf(const Value& value) {
    if (value.isNumber()) return numberText(value.real);
    if (value.kind == Value::Kind::boolean) return value.boolean ? "true" : "false";
    if (value.kind == Value::Kind::table) return "{}";
    if (value.kind != Value::Kind::array) return value.text;
    std::string list;
    for (const Value& item : value.items) list += (list.empty() ? "" : ", ") + textOf(item);
    return "[" + list + "]";
}

std::string textAt(const Value& table, const char* key) {
    const Value* value = table.find(key);
    return value ? textOf(*value) : "";
}

/// What a table of a list is called: an index would change with the tables before it.
std::string labelOf(const Value& table) {
    if (const std::string name = textAt(table, "name"); !name.empty()) return name;
    for (const char* repeated : {"body", "joint", "force"})
        if (const Value* inner = table.find(repeated); inner && inner->kind == Value::Kind::table)
            return labelOf(*inner);
    if (const std::string what = textAt(table, "what"); !what.empty())
        return what + " of " + (table.find("of") ? textAt(table, "of") : "all");
    if (table.find("a") && table.find("b")) return textAt(table, "a") + "-" + textAt(table, "b");
    if (const std::string type = textAt(table, "type"); !type.empty()) return type;
    return table.find("at") ? "at " + textAt(table, "at") : "table";
}

class Flattener {
public:
    SceneValues flatten(const Value& document) {
        // [world], [solver] and the like are compared as they are read, with their defaults.
        static const std::set<std::string> kElsewhere = {"format",  "include", "purpose", "group",
                                                         "seconds", "world",   "solver"};
        for (std::size_t i = 0; i < document.keys.size(); ++i)
            if (!kElsewhere.count(document.keys[i].name))
                add(document.keys[i].name, document.items[i]);
        return std::move(values_);
    }
    void addLeaf(const std::string& key, const std::string& text) {
        values_.emplace_back(printable(key), cut(text));
    }

private:
    void add(const std::string& key, const Value& value) {
        if (isTables(value)) return addTables(key, value);
        if (value.kind != Value::Kind::table || value.keys.empty())
            return addLeaf(key, textOf(value));
        addTable(key, value);
    }

    void addTable(const std::string& key, const Value& table) {
        for (std::size_t i = 0; i < table.keys.size(); ++i)
            add(key + "." + table.keys[i].name, table.items[i]);
    }

    void addTables(const std::string& key, const Value& list) {
        std::set<std::string> labels;
        for (const Value& table : list.items) {
            const std::string label = labelOf(table);
            std::string own = label;
            for (int i = 2; !labels.insert(own).second; ++i) own = label + " #" + std::to_string(i);
            addLeaf(key + "." + own, "[[" + key.substr(key.rfind('.') + 1) + "]]");
            addTable(key + "." + own, table);
        }
    }

    SceneValues values_;
};

}  // namespace

SceneValues sceneValues(std::string_view text, const std::string& fileName,
                        const std::vector<std::string>& overrides,
                        const std::optional<std::filesystem::path>& folder) {
    Complaints complaints(overrides);
    std::optional<std::filesystem::path> path;
    if (folder) path = *folder / std::filesystem::path(fileName).filename();
    Document document = readDocument(text, fileName, path, complaints);
    Flattener flattener;
    for (const ItemOverride& later : applyOverrides(overrides, document.table, complaints)) {
        std::string key =
            later.list + "." + later.item.name + "[" + std::to_string(later.item.index) + "]";
        for (const std::string& part : later.path) key += "." + part;
        flattener.addLeaf(key, later.value);
    }
    SceneValues values = flattener.flatten(document.table);
    std::sort(values.begin(), values.end());
    return values;
}

}  // namespace demos
