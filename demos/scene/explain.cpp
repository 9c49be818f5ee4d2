#include "demos/scene/explain.h"

#include <algorithm>
#include <optional>

#include "demos/scene/every_key.h"
#include "demos/scene/key_path.h"
#include "demos/scene/keys.h"
#include "demos/scene/schema.h"
#include "demos/text/complaints.h"
#include "demos/text/nearest.h"
#include "demos/text/stop.h"

namespace demos {
namespace {

/// A key, and how it is reached: "body.shape.sphere".
struct Reached {
    const AskedTable* table = nullptr;
    const AskedKey* key = nullptr;  // null: any key of the table
    std::string path;

    const KeyText& text() const { return *textOn(table->name, key ? key->name : "*"); }
    const std::vector<Form>& forms() const { return key ? key->forms : table->others; }
};

const AskedKey* keyOf(const AskedTable& table, const std::string& name) {
    for (const AskedKey& key : table.keys)
        if (key.name == name) return &key;
    return nullptr;
}

bool holdsList(const AskedKey& key) {
    return std::any_of(key.forms.begin(), key.forms.end(),
                       [](const Form& form) { return form.kind == Form::Kind::tables; });
}

std::string under(const std::string& path, const std::string& name) {
    return path.empty() ? name : path + "." + name;
}

/// The keys of one table.
std::vector<Reached> keysOf(const AskedTable& table, const std::string& path) {
    std::vector<Reached> keys;
    for (const AskedKey& key : table.keys) keys.push_back({&table, &key, under(path, key.name)});
    if (!table.others.empty()) keys.push_back({&table, nullptr, under(path, "NAME")});
    return keys;
}

/// Every key once, by its shortest path.
std::vector<Reached> allKeys(const Catalog& catalog) {
    std::vector<const AskedTable*> seen{&catalog.tables().front()};
    std::vector<Reached> all = keysOf(*seen.front(), "");
    for (std::size_t i = 0; i < all.size(); ++i) {
        const AskedTable* held = all[i].key ? catalog.heldBy(*all[i].key) : nullptr;
        if (!held || std::find(seen.begin(), seen.end(), held) != seen.end()) continue;
        seen.push_back(held);
        const std::vector<Reached> more = keysOf(*held, all[i].path);
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

std::optional<Reached> reach(const Catalog& catalog, const std::vector<std::string>& parts) {
    Reached at;
    const AskedTable* table = &catalog.tables().front();
    bool list = false;  // a name or number may come first
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (!table) return std::nullopt;
        const auto item = indexedPart(parts[i]);
        const AskedKey* key = keyOf(*table, item ? item->name : parts[i]);
        if (!key && list && i + 1 < parts.size()) {
            list = false;
            continue;
        }
        if (!key && table->others.empty()) return std::nullopt;
        at = {table, key, under(at.path, key ? key->name : "NAME")};
        list = key && holdsList(*key);
        table = key ? catalog.heldBy(*key) : nullptr;
    }
    return at;
}

/// The keys of the table to which all parts but the last lead, or all but the name of an item and
/// the last; none if they lead nowhere.
std::vector<Reached> keysBeside(const Catalog& catalog, std::vector<std::string> parts) {
    if (parts.size() == 1) return keysOf(catalog.tables().front(), "");
    for (int i = 0; i < 2 && parts.size() > 1; ++i) {
        parts.pop_back();
        const std::optional<Reached> parent = reach(catalog, parts);
        const AskedTable* held = parent && parent->key ? catalog.heldBy(*parent->key) : nullptr;
        if (held) return keysOf(*held, parent->path);
    }
    return {};
}

/// The paths, in quotes, of the keys whose name is nearest to the word.
std::vector<std::string> pathsNear(const std::string& word, const std::vector<Reached>& keys) {
    std::vector<std::string> names, paths;
    for (const Reached& one : keys)
        if (one.key) names.push_back(one.key->name);
    const std::string close = nearest(word, names);
    for (const Reached& one : keys)
        if (one.key && one.key->name == close) paths.push_back("'" + one.path + "'");
    return paths;
}

/// "; did you mean 'body.mass'?": keys of nearly this name, in the same table if it has one.
std::string nearestKeys(const Catalog& catalog, const std::vector<std::string>& parts) {
    constexpr std::size_t kMost = 4;
    std::vector<std::string> paths = pathsNear(parts.back(), keysBeside(catalog, parts));
    if (paths.empty()) paths = pathsNear(parts.back(), allKeys(catalog));
    if (paths.empty()) return "; 'impulse list --explain scene' lists all tables";
    paths.resize(std::min(paths.size(), kMost));
    return "; did you mean " + anyOf(paths) + "?";
}

std::string typeOf(const Form& form) {
    std::vector<std::string> words;
    for (const std::string& word : form.words) words.push_back(inToml(word));
    switch (form.kind) {
        case Form::Kind::number:
            return "a number";
        case Form::Kind::whole:
            return "a whole number";
        case Form::Kind::truth:
            return "true or false";
        case Form::Kind::text:
            return "a text";
        case Form::Kind::vector:
            return "three numbers [x, y, z]";
        case Form::Kind::texts:
            return "a text or a list of texts";
        case Form::Kind::numbers:
            return "a list of numbers";
        case Form::Kind::vectors:
            return "a list of [x, y, z]";
        case Form::Kind::word:
            return anyOf(words);
        case Form::Kind::color:
            return "a colour like \"#c89b6c\"";
        case Form::Kind::table:
            return "a table";
        case Form::Kind::tables:
            break;
    }
    return "a table or a list of tables";
}

std::string typesOf(const std::vector<Form>& forms) {
    std::vector<std::string> types;
    for (const Form& form : forms) types.push_back(typeOf(form));
    return anyOf(types);
}

/// Of the numbers; empty if there are none.
std::string rangeOf(const std::vector<Form>& forms) {
    for (const Form& form : forms)
        if (form.range.low < form.range.high)
            return numberText(form.range.low) + " to " + numberText(form.range.high);
    return {};
}

std::string row(const char* name, const std::string& value) {
    return value.empty() ? "" : std::string("  ") + name + value + "\n";
}

std::string keyList(const std::vector<Reached>& keys) {
    std::size_t width = 0;
    for (const Reached& one : keys) width = std::max(width, one.path.size());
    std::string text;
    for (const Reached& one : keys)
        text += "  " + one.path + std::string(width + 2 - one.path.size(), ' ') +
                one.text().sentence + "\n";
    return text;
}

std::string explained(const Catalog& catalog, const Reached& key) {
    std::string text = key.path + ": " + key.text().sentence + "\n";
    text += row("type     ", typesOf(key.forms()));
    text += row("unit     ", unitsOf(key.forms()));
    text += row("default  ", key.text().usual);
    text += row("range    ", rangeOf(key.forms()));
    const AskedTable* held = key.key ? catalog.heldBy(*key.key) : nullptr;
    if (held) text += "its keys:\n" + keyList(keysOf(*held, key.path));
    return text;
}

/// turn_deg: body.turn_deg, body.shape.turn_deg, ...
std::vector<Reached> keysEndingIn(const Catalog& catalog, const std::string& path) {
    std::vector<Reached> keys = allKeys(catalog);
    std::erase_if(keys, [&](const Reached& key) {
        return !key.key || !key.path.ends_with("." + path);
    });
    return keys;
}

}  // namespace

std::vector<KeyFacts> keyFacts() {
    const Catalog& catalog = formatCatalog();
    std::vector<KeyFacts> facts;
    for (const Reached& key : allKeys(catalog))
        facts.push_back({key.path, key.text().sentence, typesOf(key.forms()), unitsOf(key.forms()),
                         key.text().usual, rangeOf(key.forms())});
    return facts;
}

std::string explanationOf(const std::string& path) {
    const Catalog& catalog = formatCatalog();
    if (path == "scene")
        return "the tables and keys of a scene:\n" + keyList(keysOf(catalog.tables().front(), ""));
    const std::vector<std::string> parts = keyParts(path);
    const std::optional<Reached> found = reach(catalog, parts);
    if (found) return explained(catalog, *found);
    std::string text;
    for (const Reached& key : keysEndingIn(catalog, path))
        text += (text.empty() ? "" : "\n") + explained(catalog, key);
    if (text.empty())
        refuse("no key of a scene is called '" + printable(shown(path)) + "'" +
               nearestKeys(catalog, parts));
    return text;
}

}  // namespace demos
