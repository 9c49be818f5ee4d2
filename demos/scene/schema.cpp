#include "demos/scene/schema.h"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

#include "demos/scene/catalog.h"
#include "demos/scene/every_key.h"
#include "demos/scene/reader.h"

namespace demos {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kDraft = "https://json-schema.org/draft/2020-12/schema";

Json reference(std::string_view definition) {
    return {{"$ref", "#/$defs/" + std::string(definition)}};
}

Json anyOne(std::vector<Json> forms) {
    return forms.size() == 1 ? forms.front() : Json{{"anyOf", std::move(forms)}};
}

/// Whole numbers without a decimal point.
Json bound(double value) {
    constexpr double kExact = 1e15;
    const bool whole = value == std::floor(value) && std::fabs(value) < kExact;
    return whole ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

/// A number, or an expression; bounds too large to be useful are left out.
Json numberSchema(const Range& range, const char* type) {
    constexpr double kSaysNothing = 1e15;
    Json number{{"type", type}};
    if (range.low > -kSaysNothing) number["minimum"] = bound(range.low);
    if (range.high < kSaysNothing) number["maximum"] = bound(range.high);
    return anyOne({number, reference("expression")});
}

Json listOf(Json items) { return {{"type", "array"}, {"items", std::move(items)}}; }

Json vectorSchema(const Range& range) {
    Json schema = listOf(numberSchema(range, "number"));
    schema["minItems"] = schema["maxItems"] = 3;
    return schema;
}

/// For the editor's hint at a key.
std::string descriptionOf(const KeyText& text, const std::string& units) {
    return text.sentence + (units.empty() ? "" : " Unit: " + units + ".") +
           " Default: " + text.usual + ".";
}

/// Of a key; `name`: its own.
Json schemaOf(const Form& form, const std::string& name) {
    const std::string table = form.table.empty() ? name : definitionName(form.table);
    switch (form.kind) {
        case Form::Kind::number:
            return numberSchema(form.range, "number");
        case Form::Kind::whole:
            if (form.range.low == form.range.high) return {{"const", bound(form.range.low)}};
            return numberSchema(form.range, "integer");
        case Form::Kind::truth:
            return {{"type", "boolean"}};
        case Form::Kind::text:
            return {{"type", "string"}};
        case Form::Kind::vector:
            return vectorSchema(form.range);
        case Form::Kind::texts:
            return anyOne({Json{{"type", "string"}}, listOf({{"type", "string"}})});
        case Form::Kind::numbers:
            return listOf(numberSchema(form.range, "number"));
        case Form::Kind::vectors:
            return listOf(vectorSchema(form.range));
        case Form::Kind::word:
            return {{"enum", form.words}};
        case Form::Kind::color:
            return {{"type", "string"}, {"pattern", "^#[0-9a-fA-F]{6}$"}};
        case Form::Kind::table:
            return reference(table);
        case Form::Kind::tables:
            return anyOne({reference(table), listOf(reference(table))});
    }
    return true;
}

/// Several forms: any of them; no form: anything.
Json schemaOf(const std::vector<Form>& forms, const std::string& name, const KeyText* text) {
    std::vector<Json> list;
    for (const Form& form : forms) list.push_back(schemaOf(form, name));
    if (list.empty()) return true;
    Json schema = anyOne(std::move(list));
    if (text) schema["description"] = descriptionOf(*text, unitsOf(forms));
    return schema;
}

Json schemaOf(const AskedTable& table) {
    const auto textOf = [&](const std::string& key) { return textOn(table.name, key); };
    Json properties = Json::object();
    for (const AskedKey& key : table.keys)
        properties[key.name] = schemaOf(key.forms, key.name, textOf(key.name));
    const Json others =
        table.others.empty() ? Json(false) : schemaOf(table.others, "", textOf("*"));
    return {{"type", "object"}, {"properties", properties}, {"additionalProperties", others}};
}

}  // namespace

const Catalog& formatCatalog() {
    static const Catalog format = [] {
        Catalog catalog;
        for (const KeyExample& example : everyKey())
            catalogScene(sceneOf(example), example.what, catalog);
        return catalog;
    }();
    return format;
}

std::string sceneSchema() {
    const Catalog& catalog = formatCatalog();
    Json schema{{"$schema", kDraft}, {"title", "a scene of impulse, format 1"}};
    Json definitions{
        {"expression",
         {{"type", "string"},
          {"maxLength", 200},
          {"description", "an expression, like \"3 * cos(i * tau / n)\"; angles in radians"}}}};
    for (const AskedTable& table : catalog.tables())
        if (&table == &catalog.tables().front())
            schema.update(schemaOf(table));
        else
            definitions[definitionName(table.name)] = schemaOf(table);
    schema["required"] = {"format"};
    schema["$defs"] = definitions;
    return schema.dump(2) + "\n";
}

}  // namespace demos
