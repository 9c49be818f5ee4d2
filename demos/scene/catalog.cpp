#include "demos/scene/catalog.h"

#include <algorithm>

namespace demos {
namespace {

void join(Form& into, const Form& form) {
    into.range.low = std::min(into.range.low, form.range.low);
    into.range.high = std::max(into.range.high, form.range.high);
    for (const std::string& word : form.words)
        if (std::find(into.words.begin(), into.words.end(), word) == into.words.end())
            into.words.push_back(word);
    if (!form.table.empty()) into.table = form.table;
}

}  // namespace

AskedTable& Catalog::tableOf(const std::string& name) {
    for (AskedTable& table : tables_)
        if (table.name == name) return table;
    tables_.push_back({name, {}, {}});
    return tables_.back();
}

AskedKey& Catalog::ask(const std::string& table, std::string_view key, bool given) {
    std::vector<AskedKey>& keys = tableOf(table).keys;
    const auto isKey = [&](const AskedKey& asked) { return asked.name == key; };
    auto found = std::find_if(keys.begin(), keys.end(), isKey);
    if (found == keys.end()) found = keys.insert(keys.end(), {std::string(key), {}, false});
    found->given = found->given || given;
    return *found;
}

void Catalog::ask(const std::string& table, std::string_view key, const Form& form, bool given) {
    std::vector<Form>& forms = ask(table, key, given).forms;
    for (Form& known : forms)
        if (known.kind == form.kind) return join(known, form);
    forms.push_back(form);
}

void Catalog::askOthers(const std::string& table, const Form& form) {
    tableOf(table).others = {form};
}

}  // namespace demos
