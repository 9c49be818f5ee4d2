#include "demos/scene/schema.h"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "demos/scene/catalog.h"
#include "demos/scene/every_key.h"
#include "demos/scene/reader.h"
#include "demos/text/complaints.h"

namespace demos {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kDraft = "https://json-schema.org/draft/2020-12/schema";

/// "a key of the camera" -> "key-of-the-camera", "an [[expect]]" -> "expect"
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
    Json schema = anyOne({number, reference("expression")});
    if (*range.unit) schema["description"] = range.unit;
    return schema;
}

Json listOf(Json items) { return {{"type", "array"}, {"items", std::move(items)}}; }

Json vectorSchema(const Range& range) {
    Json schema = listOf(numberSchema(range, "number"));
    schema["minItems"] = schema["maxItems"] = 3;
    return schema;
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
Json schemaOf(const std::vector<Form>& forms, const std::string& name) {
    std::vector<Json> list;
    for (const Form& form : forms) list.push_back(schemaOf(form, name));
    return list.empty() ? Json(true) : anyOne(std::move(list));
}

Json schemaOf(const AskedTable& table) {
    Json properties = Json::object();
    for (const AskedKey& key : table.keys) properties[key.name] = schemaOf(key.forms, key.name);
    const Json others = table.others.empty() ? Json(false) : schemaOf(table.others, "");
    return {{"type", "object"}, {"properties", properties}, {"additionalProperties", others}};
}

}  // namespace

Catalog formatCatalog() {
    Catalog catalog;
    for (const KeyExample& example : everyKey())
        catalogScene(sceneOf(example), example.what, catalog);
    return catalog;
}

std::string sceneSchema() {
    const Catalog catalog = formatCatalog();
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
