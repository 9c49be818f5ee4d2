#include "demos/site/key_reference.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/scene/explain.h"
#include "demos/slides/markup.h"

namespace demos {
namespace {

std::string parentOf(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    return dot == std::string::npos ? "" : path.substr(0, dot);
}

/// Options outside of `code` become code: Markdown would make a dash of their hyphens.
std::string withOptionsAsCode(const std::string& sentence) {
    std::string marked;
    bool code = false;
    for (std::size_t at = 0; at < sentence.size();) {
        const bool option = !code && sentence.compare(at, 2, "--") == 0;
        std::size_t end = at + 1;
        if (option) end = sentence.find_first_not_of("-abcdefghijklmnopqrstuvwxyz", at);
        const std::string part = sentence.substr(at, end - at);
        marked += option ? "`" + part + "`" : part;
        code = code != (sentence[at] == '`');
        at = std::min(end, sentence.size());
    }
    return marked;
}

class KeyList {
public:
    DocumentHtml made() {
        made_.html =
            "<h1 id=\"every-key\">Every key</h1>\n<p>What a scene file may hold. "
            "<code>impulse list --explain solver.sweeps</code> says the same of one key; "
            "<code>impulse list --schema</code> lets an editor know them all.</p>\n";
        made_.sections.push_back({1, "every-key", "Every key", "What a scene file may hold."});
        add("", "The file");
        return std::move(made_);
    }

private:
    /// The keys of a table, then the tables that they hold.
    void add(const std::string& table, const std::string& title) {
        made_.html += fmt::format("<h2 id=\"{0}\">{1}</h2>\n<dl class=\"keys\">\n",
                                  table.empty() ? "file" : "table-" + table, htmlEscaped(title));
        const std::string id = table.empty() ? "file" : "table-" + table;
        made_.sections.push_back({2, id, title, ""});
        for (const KeyFacts& key : keys_)
            if (parentOf(key.path) == table) addKey(key);
        made_.html += "</dl>\n";
        for (const KeyFacts& key : keys_)
            if (parentOf(key.path) == table && holds(key.path)) add(key.path, key.path);
    }

    bool holds(const std::string& path) const {
        for (const KeyFacts& key : keys_)
            if (parentOf(key.path) == path) return true;
        return false;
    }

    void addKey(const KeyFacts& key) {
        std::string facts;
        for (const auto& [name, value] :
             {std::pair{"type", key.type}, std::pair{"unit", key.unit},
              std::pair{"default", key.usual}, std::pair{"range", key.range}})
            if (!value.empty())
                facts += fmt::format("<span><i>{}</i> {}</span>", name, htmlEscaped(value));
        const std::string sentence = withOptionsAsCode(key.sentence);
        const std::string name = key.path.substr(key.path.rfind('.') + 1);
        const std::string more =
            holds(key.path) ? fmt::format(" <a href=\"#table-{}\">its keys</a>", key.path) : "";
        made_.html += fmt::format(
            "<dt id=\"{0}\"><a href=\"#{0}\"><code>{1}</code></a></dt>"
            "<dd><p>{2}{3}</p><p class=\"facts\">{4}</p></dd>\n",
            htmlEscaped(key.path), htmlEscaped(name), htmlInlineOf(sentence), more, facts);
        made_.sections.push_back({3, key.path, key.path, plainOf(sentence)});
    }

    std::vector<KeyFacts> keys_ = keyFacts();
    DocumentHtml made_;
};

}  // namespace

DocumentHtml keyReference() { return KeyList().made(); }

}  // namespace demos
