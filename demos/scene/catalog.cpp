#include "demos/scene/catalog.h"

#include <algorithm>

namespace demos {
namespace {

void addUnit(std::string& units, const std::string& unit) {
    const bool known = (" or " + units + " or ").find(" or " + unit + " or ") != std::string::npos;
    if (!unit.empty() && !known) units += (units.empty() ? "" : " or ") + unit;
}

void join(Form& into, const Form& form) {
    into.range.low = std::min(into.range.low, form.range.low);
    into.range.high = std::max(into.range.high, form.range.high);
    for (const std::string& word : form.words)
        if (std::find(into.words.begin(), into.words.end(), word) == into.words.end())
            into.words.push_back(word);
    if (!form.table.empty()) into.table = form.table;
    addUnit(into.units, form.range.unit);
}

}  // namespace

std::string unitsOf(const std::vector<Form>& forms) {
    std::string units;
    for (const Form& form : forms) addUnit(units, form.units);
    return units;
}

std::string definitionName(std::string_view table) {
    for (const std::string_view article : {"a ", "an "})
        if (table.starts_with(article)) {
            table.remove_prefix(article.size());
            break;
        }
    std::string name;
    for (const char c : table)
        if (c != '[' && c != ']') name += c == ' ' ? '-' : c;
    return name;
}

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
    forms.back().units = form.range.unit;
}

const AskedTable* Catalog::heldBy(const AskedKey& key) const {
    for (const Form& form : key.forms) {
        if (form.kind != Form::Kind::table && form.kind != Form::Kind::tables) continue;
        const std::string name = form.table.empty() ? key.name : definitionName(form.table);
        for (const AskedTable& table : tables_)
            if (definitionName(table.name) == name) return &table;
    }
    return nullptr;
}

void Catalog::askOthers(const std::string& table, const Form& form) {
    tableOf(table).others = {form};
    tableOf(table).others.front().units = form.range.unit;
}

}  // namespace demos
