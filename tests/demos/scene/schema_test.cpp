// The JSON Schema accepts exactly what the reader accepts.

#include "demos/scene/schema.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>

#include "demos/load/builtin.h"
#include "demos/scene/catalog.h"
#include "demos/scene/every_key.h"
#include "demos/scene/toml_value.h"
#include "tests/demos/reading.h"

namespace demos::test {
namespace {

using Json = nlohmann::json;

constexpr double kNoBound = 1e300;

const Json& schema() {
    static const Json json = Json::parse(sceneSchema());
    return json;
}

/// The keywords of draft 2020-12 that the schema uses. Empty, or the first error.
class Validator {
public:
    std::string wrong(const Value& value, const Json& rule, const std::string& path) const {
        if (rule.is_boolean()) return rule.get<bool>() ? "" : path + " is not known";
        if (rule.contains("$ref"))
            return wrong(value,
                         schema().at(Json::json_pointer(rule["$ref"].get<std::string>().substr(1))),
                         path);
        if (rule.contains("anyOf")) {
            std::string first;
            for (const Json& one : rule["anyOf"]) {
                const std::string failed = wrong(value, one, path);
                if (failed.empty()) return "";
                if (first.empty()) first = failed;
            }
            return first;
        }
        if (rule.contains("const"))
            return value.isNumber() && value.real == rule["const"] ? "" : path + " is another";
        if (rule.contains("enum"))
            return contains(rule["enum"], value.text) ? "" : path + " is none of the words";
        return ofType(value, rule, path);
    }

private:
    static bool contains(const Json& words, const std::string& word) {
        return std::find(words.begin(), words.end(), word) != words.end();
    }

    std::string ofType(const Value& value, const Json& rule, const std::string& path) const {
        const std::string type = rule.at("type");
        using Kind = Value::Kind;
        const bool good = type == "boolean"   ? value.kind == Kind::boolean
                          : type == "string"  ? value.kind == Kind::text
                          : type == "integer" ? value.kind == Kind::integer
                          : type == "number"  ? value.isNumber()
                          : type == "array"   ? value.kind == Kind::array
                                              : value.kind == Kind::table;
        if (!good) return path + " is no " + type;
        if (type == "string") return ofText(value, rule, path);
        if (type == "array") return ofList(value, rule, path);
        if (type == "object") return ofTable(value, rule, path);
        if (value.real < rule.value("minimum", -kNoBound)) return path + " is too small";
        return value.real > rule.value("maximum", kNoBound) ? path + " is too large" : "";
    }

    static std::string ofText(const Value& value, const Json& rule, const std::string& path) {
        if (value.text.size() > rule.value("maxLength", std::size_t{10'000}))
            return path + " is long";
        const std::regex pattern(rule.value("pattern", ".*"));
        return std::regex_search(value.text, pattern) ? "" : path + " is another pattern";
    }

    std::string ofList(const Value& value, const Json& rule, const std::string& path) const {
        if (value.items.size() < rule.value("minItems", std::size_t{0}) ||
            value.items.size() > rule.value("maxItems", std::size_t{1'000'000}))
            return path + " has another length";
        for (const Value& item : value.items)
            if (const std::string failed = wrong(item, rule.at("items"), path + "[]");
                !failed.empty())
                return failed;
        return "";
    }

    std::string ofTable(const Value& value, const Json& rule, const std::string& path) const {
        for (std::size_t i = 0; i < value.keys.size(); ++i) {
            const std::string& name = value.keys[i].name;
            const Json& known = rule.at("properties");
            const Json& one = known.contains(name) ? known[name] : rule.at("additionalProperties");
            const std::string failed = wrong(value.items[i], one, path + "." + name);
            if (!failed.empty()) return failed;
        }
        for (const Json& name : rule.value("required", Json::array()))
            if (!value.find(name.get<std::string>())) return path + " lacks a key";
        return "";
    }
};

std::string wrongIn(const std::string& text) {
    Complaints complaints;
    complaints.addFile("a.toml");
    const Value document = parseToml(text, complaints);
    if (complaints.count() > 0) return complaints.lines().front();
    return Validator().wrong(document, schema(), "");
}

TEST(Schema, TakesEveryBuiltInScene) {
    for (const BuiltinScene& scene : builtinScenes())
        EXPECT_EQ(wrongIn(std::string(scene.text)), "") << scene.name;
}

TEST(Schema, TakesEveryExampleAndSoDoesTheReader) {
    for (const KeyExample& example : everyKey()) {
        Catalog ignored;
        const std::string text = sceneOf(example);
        EXPECT_EQ(wrongIn(text), "") << example.what;
        const auto lines = catalogScene(text, example.what, ignored);
        EXPECT_EQ(lines.empty(), !example.namesFiles) << example.what << "\n" << listed(lines);
    }
}

TEST(Schema, RefusesWhatTheReaderRefuses) {
    const std::string start = "format = 1\n";
    for (const char* text :
         {"secods = 1\n", "seconds = true\n", "seconds = 0\n", "[world]\ngravity = [1, 2]\n",
          "[world]\nhz = 60.5\n", "[world]\nhzz = 60\n", "[solver]\norder = 'up'\n",
          "[look]\nshow = 3\n", "[camera]\nkeys = [{ as = 3 }]\n", "[values]\na = true\n",
          "[[material]]\ncolour = 'red'\n", "[[body]]\nshape = { sphere = 0 }\n",
          "[[body]]\nshape = { capsule = { radiu = 1 } }\n", "[[body]]\nfixed = 1\n",
          "[[repeat]]\ncount = 3\n[[repeat.repeat]]\ncuont = 2\n"}) {
        EXPECT_NE(wrongIn(start + text), "") << text;
        EXPECT_FALSE(errorsOf(start + text + kBall).empty()) << text;
    }
    EXPECT_NE(wrongIn("title = 'a'\n"), "");
    EXPECT_NE(wrongIn("format = 2\n"), "");
}

TEST(Schema, TakesExpressionsForNumbersOnly) {
    const std::string start = "format = 1\n";
    EXPECT_EQ(wrongIn(start + "seconds = '2 * a'\n[values]\na = '1 + 1'\n[world]\nhz = '60'\n"
                              "gravity = [0, '-a', 0]\n"),
              "");
    EXPECT_NE(wrongIn(start + "[[body]]\nfixed = 'a'\n"), "");
    EXPECT_NE(wrongIn(start + "seconds = '" + std::string(201, '1') + "'\n"), "");
}

TEST(Schema, HasNoKeyThatNoSceneMayHave) {
    const Catalog& catalog = formatCatalog();
    EXPECT_GE(catalog.tables().size(), 15u);
    for (const AskedTable& table : catalog.tables())
        for (const AskedKey& key : table.keys) {
            EXPECT_TRUE(key.given)
                << key.name << " in " << table.name << ": give it in demos/scene/every_key_*.cpp";
            EXPECT_FALSE(key.forms.empty())
                << key.name << " in " << table.name << " may be anything";
        }
}

TEST(Schema, DescribesEveryKey) {
    int keys = 0;
    const auto check = [&](const std::string& table, const Json& properties) {
        for (const auto& [name, rule] : properties.items()) {
            const std::string text = rule.value("description", "");
            EXPECT_NE(text.find(". Default: "), std::string::npos) << table << " " << name;
            ++keys;
        }
    };
    check("the file", schema()["properties"]);
    for (const auto& [name, definition] : schema()["$defs"].items())
        if (definition.contains("properties")) check(name, definition["properties"]);
    EXPECT_GE(keys, 200);
    EXPECT_NE(schema()["$defs"]["body"]["properties"]["mass"]["description"]
                  .get<std::string>()
                  .find(" Unit: kg. Default: density times volume."),
              std::string::npos);
}

/// Puts an unknown key into every table of the document, one after the other.
void refuseStrangers(Value& table, const Value& document, const std::string& path) {
    if (table.kind == Value::Kind::table && path != ".values") {
        Value one;
        one.kind = Value::Kind::integer;
        one.place = {1, 1};
        table.keys.push_back({"stranger", {1, 1}});
        table.items.push_back(one);
        EXPECT_NE(Validator().wrong(document, schema(), ""), "") << path;
        table.keys.pop_back();
        table.items.pop_back();
    }
    for (std::size_t i = 0; i < table.items.size(); ++i)
        refuseStrangers(table.items[i], document,
                        path + (table.keys.empty() ? "" : "." + table.keys[i].name));
}

TEST(Schema, RefusesStrangersInEveryTable) {
    for (const KeyExample& example : everyKey()) {
        Complaints complaints;
        Value document = parseToml(sceneOf(example), complaints);
        refuseStrangers(document, document, "");
    }
}

}  // namespace
}  // namespace demos::test
