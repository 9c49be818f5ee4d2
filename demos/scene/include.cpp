#include "demos/scene/include.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "demos/scene/reader.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestPath = 1000;

bool isList(std::string_view key) {
    constexpr std::string_view kLists[] = {"material", "body",    "joint", "force",
                                           "repeat",   "section", "expect"};
    return std::find(std::begin(kLists), std::end(kLists), key) != std::end(kLists);
}

void setFile(Value& value, int file) {
    value.place.file = file;
    for (Key& key : value.keys) key.place.file = file;
    for (Value& item : value.items) setFile(item, file);
}

/// A single table [body] counts as a list of one.
void append(Value& list, Value more) {
    if (list.kind != Value::Kind::array) {
        Value alone = std::move(list);
        list = {};
        list.kind = Value::Kind::array;
        list.place = alone.place;
        list.items.push_back(std::move(alone));
    }
    if (more.kind != Value::Kind::array) return list.items.push_back(std::move(more));
    for (Value& item : more.items) list.items.push_back(std::move(item));
}

/// The keys of a table by name: a file of 8 MiB may hold very many.
class Index {
public:
    explicit Index(Value& table) : table_(table) {
        for (std::size_t i = 0; i < table.keys.size(); ++i) places_.insert({table.keys[i].name, i});
    }

    Value* find(const std::string& name) {
        const auto found = places_.find(name);
        return found == places_.end() ? nullptr : &table_.items[found->second];
    }

    /// Replaces the key of this name, or appends it.
    void set(Key key, Value value) {
        const auto [found, isNew] = places_.insert({key.name, table_.keys.size()});
        if (isNew) {
            table_.keys.push_back(std::move(key));
            table_.items.push_back(std::move(value));
        } else {
            table_.keys[found->second].place = key.place;
            table_.items[found->second] = std::move(value);
        }
    }

private:
    Value& table_;
    std::map<std::string, std::size_t> places_;
};

void setKeys(Value& base, Value own) {
    Index index(base);
    for (std::size_t i = 0; i < own.keys.size(); ++i)
        index.set(std::move(own.keys[i]), std::move(own.items[i]));
}

/// Merges `own` into `base`; `own` wins.
void merge(Value& base, Value own) {
    base.place = own.place;
    Index index(base);
    for (std::size_t i = 0; i < own.keys.size(); ++i) {
        Key& key = own.keys[i];
        Value& value = own.items[i];
        Value* known = index.find(key.name);
        if (known && isList(key.name))
            append(*known, std::move(value));
        else if (known && known->kind == Value::Kind::table && value.kind == known->kind)
            setKeys(*known, std::move(value));
        else
            index.set(std::move(key), std::move(value));
    }
}

/// Removes the keys that each file has for itself.
void dropOwn(Value& table) {
    for (const char* key : {"format", "include"})
        for (std::size_t i = 0; i < table.keys.size(); ++i)
            if (table.keys[i].name == key) {
                table.keys.erase(table.keys.begin() + static_cast<std::ptrdiff_t>(i));
                table.items.erase(table.items.begin() + static_cast<std::ptrdiff_t>(i));
                break;
            }
}

fs::path fullPath(const fs::path& path) {
    std::error_code error;
    const fs::path full = fs::weakly_canonical(path, error);
    return error ? path.lexically_normal() : full;
}

class Reading {
public:
    Reading(Document& document, Complaints& complaints)
        : document_(document), complaints_(complaints) {}

    /// The file merged with all that it includes. It is numbered after the included files.
    Value file(std::string_view text, const std::string& name,
               const std::optional<fs::path>& path) {
        document_.text += text;
        if (path) {
            inside_.push_back(fullPath(*path));
            known_.insert(inside_.back());
        }
        Complaints own;  // gets the file's number once the included files have theirs
        Value table = parseToml(text, own);
        if (table.place.line < 1) table.place = {1, 1};
        if (inside_.size() > 1 && own.count() == 0) checkFormat(table, own);
        Value merged;
        if (const Value* list = table.find("include")) {
            for (const Value* item : itemsOf(*list, own)) {
                if (own.count() >= kEnoughComplaints) break;
                if (std::optional<Value> part = included(*item, path, own))
                    merge(merged, std::move(*part));
            }
        }
        const int number = complaints_.addFile(name);
        complaints_.addAll(own, number);
        if (path) inside_.pop_back();
        setFile(table, number);
        merge(merged, std::move(table));
        return merged;
    }

private:
    static void checkFormat(const Value& table, Complaints& own) {
        const Value* format = table.find("format");
        if (!format)
            own.add({1, 1}, "the included file has no format; begin it with format = 1");
        else if (format->kind != Value::Kind::integer || format->integer != 1)
            own.add(format->place,
                    "format is " + describe(*format) + "; this version reads format 1");
    }

    static std::vector<const Value*> itemsOf(const Value& list, Complaints& own) {
        std::vector<const Value*> items;
        if (list.kind == Value::Kind::text) items.push_back(&list);
        bool good = list.kind == Value::Kind::text || list.kind == Value::Kind::array;
        if (list.kind == Value::Kind::array)
            for (const Value& item : list.items) {
                good = good && item.kind == Value::Kind::text;
                items.push_back(&item);
            }
        if (items.size() > kMostIncluded) {
            own.add(list.place, "include has " + std::to_string(items.size()) + " files; it should have at most " +
                                    std::to_string(kMostIncluded));
            return {};
        }
        if (good) return items;
        own.add(list.place, "include is " + describe(list) +
                                "; it should be files, like [\"parts/floor.toml\"]");
        return {};
    }

    /// Nothing after an error, or if the file was included already.
    std::optional<Value> included(const Value& item, const std::optional<fs::path>& from,
                                  Complaints& own) {
        const std::string wrong = whyNot(item.text, from);
        if (!wrong.empty()) {
            own.add(item.place, wrong);
            return std::nullopt;
        }
        const fs::path path = (from->parent_path() / item.text).lexically_normal();
        const fs::path full = fullPath(path);
        if (std::find(inside_.begin(), inside_.end(), full) != inside_.end()) {
            own.add(item.place, "'" + item.text + "' includes itself, by way of " +
                                    inside_.back().filename().string() +
                                    "; one of the two should not");
            return std::nullopt;
        }
        if (known_.contains(full)) return std::nullopt;
        try {
            const std::string text = readSceneFile(path);
            if (document_.text.size() + text.size() <= kMostSceneBytes) {
                document_.files.push_back(path.string());
                Value table = file(text, path.string(), path);
                dropOwn(table);
                return table;
            }
            own.add(item.place, "more than 8 MiB in all files; leave some out");
        } catch (const SceneError& error) {
            own.add(item.place, error.lines().front());
        }
        return std::nullopt;
    }

    std::string whyNot(const std::string& text, const std::optional<fs::path>& from) const {
        if (!from)
            return "a scene that is not in a file cannot include others; save it with 'impulse "
                   "list NAME --print'";
        if (text.empty() || text.find('\0') != std::string::npos)
            return "include is '" + text + "'; it should be a file, like \"parts/floor.toml\"";
        if (text.size() > kLongestPath)
            return "include is '" + shown(text) + "' of " + std::to_string(text.size()) +
                   " characters; it should be at most " + std::to_string(kLongestPath);
        if (inside_.size() > kDeepestInclude)
            return "files include each other more than 8 deep";
        if (known_.size() >= kMostSceneFiles) return "more than 64 files in a scene";
        return "";
    }

    Document& document_;
    Complaints& complaints_;
    std::vector<fs::path> inside_;  // the files that are being read
    std::set<fs::path> known_;
};

}  // namespace

Document readDocument(std::string_view text, const std::string& name,
                      const std::optional<fs::path>& path, Complaints& complaints) {
    Document document;
    document.table = Reading(document, complaints).file(text, name, path);
    return document;
}

}  // namespace demos
